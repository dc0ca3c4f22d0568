// gltf_file.hpp -- what of a glTF file Assimp does not read, or reads with too few digits.
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
    glm::dmat4 local = glm::dmat4(1.0);        // to its parent
    std::vector<std::uint32_t> children = {};  // indices of nodes, in range
    std::vector<double> morph_weights = {};    // by default, its own or its mesh's
    bool has_mesh = false;
};

struct GltfFile {
    std::vector<GltfNode> nodes;
    std::vector<std::uint32_t> roots;  // of the scene that is shown
    std::string unread = {};  // "the glTF extension X, which is not read", of those that are not required
};

/// The nodes of a glTF 2 file, .gltf or .glb; nothing when the bytes are something else. Throws Error when an
/// extension is required or positions are in a form that would be read wrongly.
std::optional<GltfFile> read_gltf(std::string_view bytes, const std::filesystem::path& path);

}  // namespace momentscope
