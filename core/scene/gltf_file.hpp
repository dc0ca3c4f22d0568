// gltf_file.hpp -- reads those parts of a glTF file that Assimp does not read, or reads with too few digits.
#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace momentscope {

struct GltfNode {
    glm::dmat4 local = glm::dmat4(1.0);        // to the parent
    std::vector<std::uint32_t> children = {};  // indices of nodes, in range
    std::vector<double> morph_weights = {};    // default weights, of the node or of its mesh
    bool has_mesh = false;
};

struct GltfFile {
    std::vector<GltfNode> nodes;
    std::vector<std::uint32_t> roots;  // of the default scene
    std::string unread = {};           // "the glTF extension X, which is not read", if not required
};

/// The nodes of a glTF 2 file, .gltf or .glb; nullopt if the bytes are something else. Throws Error if an
/// extension is required, or if positions have a form that would be read wrongly.
std::optional<GltfFile> read_gltf(std::string_view bytes, const std::filesystem::path& path);

}  // namespace momentscope
