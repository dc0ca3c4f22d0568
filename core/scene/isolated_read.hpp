// isolated_read.hpp -- runs a reader that cannot be trusted with hostile files in a process of its own.
#pragma once
#include "core/scene/loaded_mesh.hpp"

#include <functional>
#include <optional>
#include <stop_token>

namespace momentscope {

/// What `read` returns, having run in a forked process that may take `seconds` of time. An Error thrown
/// by `read` is thrown here. Nothing when the process crashed, hung, ran out of memory or returned a
/// mesh that is not well-formed. `read` must not use GL or wait for other threads. Throws Error soon after a
/// stop is requested.
std::optional<LoadedMesh> read_isolated(const std::function<LoadedMesh()>& read, unsigned seconds,
                                        const std::stop_token& stop = {});

}  // namespace momentscope
