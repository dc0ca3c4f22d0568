// loaded_mesh.hpp -- a mesh, and warnings about what its file means differently.
#pragma once
#include "core/scene/scene.hpp"

#include <string>
#include <vector>

namespace momentscope {

struct LoadedMesh {
    Mesh mesh;
    std::vector<std::string> warnings = {};  // as Scene::warnings; each is one line
};

}  // namespace momentscope
