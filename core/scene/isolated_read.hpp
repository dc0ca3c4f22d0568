// isolated_read.hpp -- runs a reader that cannot be trusted with hostile files in a process of its own.
#pragma once
#include "core/scene/loaded_mesh.hpp"
#include "core/scene/read_report.hpp"

#include <functional>
#include <optional>
#include <stop_token>

namespace momentscope {

/// Runs in a process of its own; what it reports arrives at home.
using IsolatedReader = std::function<LoadedMesh(const ReadReport& report)>;

/// What `read` returns, having run in a forked process that may take `seconds` of time and what memory is
/// free, and that ends with this one. An Error thrown by `read` is thrown here. Nothing when the process
/// crashed, hung, ran out of memory or returned a mesh that is not well-formed. `read` must not use GL or
/// wait for other threads. `report` is called by this thread. Throws Error soon after a stop is requested,
/// and before it takes more memory for the mesh than is free.
std::optional<LoadedMesh> read_isolated(const IsolatedReader& read, unsigned seconds,
                                        const std::stop_token& stop = {}, const ReadReport& report = {});

}  // namespace momentscope
