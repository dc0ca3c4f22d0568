// isolated_read.cpp -- a browser isolates the page from everything else, and has no processes to start.
#include "core/scene/isolated_read.hpp"

#include "core/scene/mesh_file.hpp"

namespace momentscope {

std::optional<LoadedMesh> read_isolated(const IsolatedReader& read, unsigned, const std::stop_token&,
                                        const ReadReport& report) {
    return read(report);
}

}  // namespace momentscope
