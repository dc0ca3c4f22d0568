// scene_size.hpp -- how much of the graphics memory a scene takes, before it takes it.
#pragma once
#include <cstddef>

#include "core/scene/scene.hpp"

namespace momentscope {

constexpr std::size_t MAX_SCENE_BYTES = std::size_t{4} << 30;  // more than 20 million separate triangles

struct SceneSize {
    std::size_t vertices = 0, indices = 0, objects = 0, texels = 0;
    std::size_t most_indices = 0;  // of one mesh

    std::size_t bytes() const;
};

SceneSize size_of(const Scene& scene);

/// Throws Error with the numbers when there are more bytes than MAX_SCENE_BYTES, or more indices in a mesh
/// than OpenGL counts in one draw call, or too little memory is free.
void require_drawable(const SceneSize& size);

}  // namespace momentscope
