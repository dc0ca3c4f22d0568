// loaded_mesh.hpp -- a mesh, and what its file meant otherwise.
#pragma once
#include "core/scene/scene.hpp"

#include <string>
#include <vector>

namespace momentscope {

struct LoadedMesh {
    Mesh mesh;
    std::vector<std::string> warnings = {};  // as Scene::warnings, each on one line
};

}  // namespace momentscope
