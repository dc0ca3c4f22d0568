// scene_size.hpp -- computes how much graphics memory a scene takes, before it is uploaded.
#pragma once
#include <cstddef>
#include <cstdint>

#include "core/scene/scene.hpp"

namespace momentscope {

constexpr std::uintmax_t MAX_SCENE_BYTES = std::uintmax_t{4}
                                           << 30;  // more than 20 million separate triangles

struct SceneSize {
    std::size_t vertices = 0, indices = 0, objects = 0, texels = 0;
    std::size_t most_indices = 0;  // of the largest mesh

    std::uintmax_t bytes() const;
};

SceneSize size_of(const Scene& scene);

/// Throws Error, which gives the numbers, if the scene has more than MAX_SCENE_BYTES bytes, if a mesh has
/// more indices than OpenGL can draw in one call, or if too little memory is free.
void require_drawable(const SceneSize& size);

}  // namespace momentscope
