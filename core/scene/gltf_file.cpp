// gltf_file.cpp -- reads the JSON of a glTF file: extensions, accessors of positions, and nodes in double.
#include "core/scene/gltf_file.hpp"

#include "core/scene/mesh_error.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/support/bounded_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace momentscope {
namespace {

using nlohmann::json;

/// Extensions that do not change the shape: materials, textures, lights, descriptions. A star stands for any
/// ending.
constexpr std::string_view HARMLESS_EXTENSIONS[] = {"KHR_materials_*",
                                                    "KHR_texture_*",
                                                    "EXT_texture_*",
                                                    "MSFT_texture_*",
                                                    "KHR_lights_*",
                                                    "EXT_lights_*",
                                                    "KHR_xmp*",
                                                    "KHR_animation_pointer",
                                                    "KHR_audio*",
                                                    "EXT_mesh_features",
                                                    "EXT_structural_metadata",
                                                    "EXT_instance_features",
                                                    "KHR_technique*",
                                                    "ADOBE_materials_*",
                                                    "MSFT_packing_*",
                                                    "CESIUM_primitive_outline"};

constexpr std::size_t MAX_NAMED = 8;   // extensions in a sentence
constexpr std::size_t MAX_NAME = 60;   // of each name
constexpr int FLOAT_COMPONENT = 5126;  // the code of glTF

/// A node takes about ten values, and there are fewer nodes than triangles. Extensions nest deeper than glTF
/// itself, which has at most 7 levels.
constexpr JsonBounds BOUNDS = {.bytes = MAX_MESH_FILE_BYTES, .values = 10'000'000, .nesting = 64};

bool is_harmless(std::string_view name) {
    return std::ranges::any_of(HARMLESS_EXTENSIONS, [&](std::string_view pattern) {
        return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1))
                                      : name == pattern;
    });
}

/// The JSON chunk of a binary file, or the whole text of a text file; nullopt if it is neither.
std::optional<std::string> json_part(std::string_view bytes) {
    if (bytes.starts_with("glTF")) {
        const auto word = [&](std::size_t offset) {
            std::uint32_t value = 0;  // little-endian, like all machines with GL
            std::memcpy(&value, bytes.data() + offset, sizeof value);
            return value;
        };
        if (bytes.size() < 20 || word(4) != 2 || word(16) != 0x4E4F534A || word(12) > bytes.size() - 20)
            return std::nullopt;
        return std::string(bytes.substr(20, word(12)));
    }
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == bytes.npos || bytes[first] != '{') return std::nullopt;
    return std::string(bytes);
}

/// The member with this key, or null if there is none.
const json& member(const json& object, const char* key) {
    static const json NOTHING;
    if (!object.is_object()) return NOTHING;
    const auto found = object.find(key);
    return found == object.end() ? NOTHING : *found;
}

/// The element at this index, or null if there is none.
const json& element(const json& array, const json& index) {
    static const json NOTHING;
    if (!array.is_array() || !index.is_number_unsigned()) return NOTHING;
    const auto i = index.get<std::size_t>();
    return i < array.size() ? array[i] : NOTHING;
}

std::vector<double> numbers(const json& array) {
    std::vector<double> values;
    if (!array.is_array()) return values;
    for (const json& value : array) values.push_back(value.is_number() ? value.get<double>() : 0.0);
    return values;
}

std::set<std::string> strings(const json& array) {
    std::set<std::string> names;
    if (!array.is_array()) return names;
    for (const json& name : array)
        if (name.is_string()) names.insert(name.get<std::string>());
    return names;
}

/// Collects all extensions that are used, whether or not the file lists them.
void collect_extensions(const json& value, std::set<std::string>& names) {
    if (value.is_object()) {
        for (const auto& [key, child] : value.items()) {
            if (key == "extras") continue;  // data of applications
            if (key == "extensions" && child.is_object())
                for (const auto& [name, ignored] : child.items()) names.insert(name);
            collect_extensions(child, names);
        }
    } else if (value.is_array() && !value.empty() && value.front().is_structured()) {
        for (const json& child : value) collect_extensions(child, names);
    }
}

/// "the glTF extensions X, Y, which are not read"; empty if all of the names are harmless.
std::string unread(const std::set<std::string>& names) {
    std::vector<std::string> left;
    for (const std::string& name : names)
        if (!is_harmless(name) && left.size() < MAX_NAMED) left.push_back(name.substr(0, MAX_NAME));
    if (left.empty()) return "";
    return fmt::format("the glTF extension{} {}, which {} not read", left.size() > 1 ? "s" : "",
                       fmt::join(left, ", "), left.size() > 1 ? "are" : "is");
}

/// Throws Error unless positions and normals are floats. Assimp reads them as floats whatever their type is,
/// and reads missing ones as zeros.
void require_floats(const json& file, const std::filesystem::path& path) {
    const auto check = [&](const json& attributes) {
        for (const char* name : {"POSITION", "NORMAL"}) {
            const json& accessor = element(member(file, "accessors"), member(attributes, name));
            if (!accessor.is_object()) continue;
            if (member(accessor, "componentType") != FLOAT_COMPONENT || member(accessor, "type") != "VEC3")
                refuse_mesh(path,
                            "has quantised positions or normals (KHR_mesh_quantization), which are not read; "
                            "export it again with floats.");
            if (!accessor.contains("bufferView") && !accessor.contains("sparse") && name[0] == 'P')
                refuse_mesh(path, "has positions that are compressed; export it again without compression.");
        }
    };
    for (const json& mesh : member(file, "meshes")) {
        for (const json& primitive : member(mesh, "primitives")) {
            check(member(primitive, "attributes"));
            for (const json& target : member(primitive, "targets")) check(target);
        }
    }
}

glm::dmat4 local_transform(const json& node) {
    if (const std::vector<double> m = numbers(member(node, "matrix")); m.size() == 16) {
        glm::dmat4 matrix;
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
        return matrix;
    }
    glm::dmat4 local(1.0);
    if (const std::vector<double> q = numbers(member(node, "rotation")); q.size() == 4) {
        const glm::dquat rotation(q[3], q[0], q[1], q[2]);
        if (glm::length(rotation) > 0.0) local = glm::mat4_cast(glm::normalize(rotation));
    }
    if (const std::vector<double> s = numbers(member(node, "scale")); s.size() == 3)
        for (int axis = 0; axis < 3; ++axis) local[axis] *= s[static_cast<std::size_t>(axis)];
    if (const std::vector<double> t = numbers(member(node, "translation")); t.size() == 3)
        local[3] = {t[0], t[1], t[2], 1.0};
    return local;
}

/// Those elements of the array that are valid indices of nodes.
std::vector<std::uint32_t> node_indices(const json& array, std::size_t node_count) {
    std::vector<std::uint32_t> indices;
    if (!array.is_array()) return indices;
    for (const json& index : array)
        if (index.is_number_unsigned() && index.get<std::uint64_t>() < node_count)
            indices.push_back(index.get<std::uint32_t>());
    return indices;
}

}  // namespace

std::optional<GltfFile> read_gltf(std::string_view bytes, const std::filesystem::path& path) {
    std::optional<std::string> text = json_part(bytes);
    if (!text) return std::nullopt;
    // Some files have names in Latin-1. Names do not matter here, but the JSON reader would not accept such
    // bytes as UTF-8.
    std::ranges::replace_if(
        *text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
    json file;
    try {
        file = parse_bounded_json(*text, BOUNDS);
    } catch (const Error& error) {
        if (path.extension() != ".gltf" && path.extension() != ".glb") return std::nullopt;
        refuse_mesh(path, fmt::format("cannot be read as glTF: {}", error.what()));
    }
    text.reset();
    const json& version = member(member(file, "asset"), "version");
    if (!version.is_string() || version.get<std::string>().starts_with("1")) return std::nullopt;

    const std::string required = unread(strings(member(file, "extensionsRequired")));
    if (!required.empty()) refuse_mesh(path, "needs " + required + "; export it without.");
    require_floats(file, path);

    GltfFile result;
    std::set<std::string> used = strings(member(file, "extensionsUsed"));
    collect_extensions(file, used);
    result.unread = unread(used);
    const json& nodes = member(file, "nodes");
    const std::size_t node_count = nodes.is_array() ? nodes.size() : 0;
    for (std::size_t i = 0; i < node_count; ++i) {
        const json& node = nodes[i];
        const json& own = member(node, "weights");
        const json& mesh = element(member(file, "meshes"), member(node, "mesh"));
        result.nodes.push_back({local_transform(node), node_indices(member(node, "children"), node_count),
                                numbers(own.is_array() ? own : member(mesh, "weights")), mesh.is_object()});
    }
    const json& chosen = member(file, "scene");
    const json& scene = element(member(file, "scenes"), chosen.is_number_unsigned() ? chosen : json(0u));
    result.roots = node_indices(member(scene, "nodes"), node_count);
    return result;
}

}  // namespace momentscope
