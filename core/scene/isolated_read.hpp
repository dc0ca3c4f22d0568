// isolated_read.hpp -- runs a reader that hostile files may crash in a process of its own.
#pragma once
#include "core/scene/loaded_mesh.hpp"
#include "core/scene/read_report.hpp"

#include <functional>
#include <optional>
#include <stop_token>

namespace momentscope {

/// A reader that runs in a process of its own. What it reports reaches the parent process.
using IsolatedReader = std::function<LoadedMesh(const ReadReport& report)>;

/// Runs `read` in a forked process and returns its result. The process may take `seconds` of time and the
/// free memory, and ends with this process. If `read` throws an Error, it is thrown here. nullopt if the
/// process crashed, hung, ran out of memory or returned a mesh that is not well-formed. `read` must not use
/// GL or wait for other threads. `report` is called by this thread. Throws Error soon after a stop is
/// requested, and if the mesh would take more memory than is free, before it takes it.
std::optional<LoadedMesh> read_isolated(const IsolatedReader& read, unsigned seconds,
                                        const std::stop_token& stop = {}, const ReadReport& report = {});

}  // namespace momentscope
