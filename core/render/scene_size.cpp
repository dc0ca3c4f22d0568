#include "core/render/scene_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/render/uniform_blocks.hpp"
#include "core/support/error.hpp"
#include "core/support/memory.hpp"

namespace momentscope {

namespace {

constexpr std::size_t MAX_INDICES = std::numeric_limits<int>::max();  // GLsizei is an int

double gib(std::uintmax_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(std::size_t{1} << 30);
}

}  // namespace

std::uintmax_t SceneSize::bytes() const {
    return std::uintmax_t{vertices} * sizeof(Vertex) + std::uintmax_t{indices} * sizeof(std::uint32_t) +
           std::uintmax_t{objects} * sizeof(ObjectBlock) + texels;
}

SceneSize size_of(const Scene& scene) {
    SceneSize size;
    size.objects = scene.objects.size();
    for (const Mesh& mesh : scene.meshes) {
        size.vertices += mesh.positions.size();
        size.indices += mesh.indices.size();
        size.most_indices = std::max(size.most_indices, mesh.indices.size());
    }
    for (const AlphaMap& map : scene.alpha_maps)
        size.texels += static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
    return size;
}

void require_drawable(const SceneSize& size) {
    if (size.most_indices > MAX_INDICES)
        throw Error(
            fmt::format("A mesh of the scene has {} triangles, more than the {} that OpenGL draws at once; "
                        "simplify it or split it up.",
                        size.most_indices / 3, MAX_INDICES / 3));
    if (size.bytes() > MAX_SCENE_BYTES)
        throw Error(
            fmt::format("The scene needs {:.1f} GiB of graphics memory for {} vertices, {} triangles, {} "
                        "objects and {} texels, more than the limit of {:.0f} GiB; simplify it.",
                        gib(size.bytes()), size.vertices, size.indices / 3, size.objects, size.texels,
                        gib(MAX_SCENE_BYTES)));
    // A GL on the CPU holds the scene in main memory. The order of submission and the uploaded data take more
    // memory there.
    require_memory(size.bytes() + size.indices * sizeof(std::uint32_t) + size.vertices * sizeof(Vertex),
                   fmt::format("Drawing {} triangles", size.indices / 3), "simplify the scene");
}

}  // namespace momentscope
