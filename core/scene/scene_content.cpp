#include "core/scene/scene_content.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "core/scene/scenes.hpp"

namespace momentscope {

namespace {

class Hash {
public:
    template <typename T>
    void add(const std::vector<T>& values) {
        add_bytes(values.size());
        const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
        for (std::size_t i = 0; i < values.size() * sizeof(T); ++i) add_byte(bytes[i]);
    }
    std::string digits() const { return fmt::format("{:016x}", state_); }

private:
    void add_bytes(std::uint64_t number) {
        for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<unsigned char>(number >> shift));
    }
    void add_byte(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001B3U; }

    std::uint64_t state_ = 0xCBF29CE484222325U;
};

}  // namespace

std::string scene_content(const Scene& scene) {
    if (is_builtin_scene(scene.id)) return BUILTIN_CONTENT;
    Hash hash;
    for (const Mesh& mesh : scene.meshes) {
        hash.add(mesh.positions);
        hash.add(mesh.normals);
        hash.add(mesh.indices);
        hash.add(mesh.texture_coordinates);
    }
    for (const AlphaMap& map : scene.alpha_maps) hash.add(map.bytes);
    return hash.digits();
}

}  // namespace momentscope
