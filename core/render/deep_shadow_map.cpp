#include "core/render/deep_shadow_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/gl/gl_info.hpp"
#include "core/gl/texture.hpp"
#include "core/support/error.hpp"

namespace momentscope {

DeepShadowMap make_deep_shadow_map(CasterTexels& texels, const SceneBuffers& scene, GLuint frame_block,
                                   int size) {
    std::vector<glm::uvec2> lists(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    std::vector<glm::vec2> steps;
    const auto most_steps =
        static_cast<std::size_t>(DEEP_ROW) * static_cast<std::size_t>(most_texels_of_a_side());
    for (int y = 0, rows = size; y < size; y += rows) {
        rows = std::min(rows, size - y);
        auto nodes = texels.capture(scene, frame_block, {{0, y}, {size, rows}});
        while (!nodes && rows > 1) {
            rows = (rows + 1) / 2;
            nodes = texels.capture(scene, frame_block, {{0, y}, {size, rows}});
        }
        if (!nodes || steps.size() + nodes->size() >= most_steps)
            throw Error(fmt::format(
                "A deep shadow map of {0}x{0} texels has more fragments than this GL can hold; give a smaller "
                "--shadow-size.",
                size));
        std::ranges::sort(*nodes, {}, [](const FragmentNode& n) { return std::pair(n.pixel, n.depth); });
        double absorbance = 0;
        std::uint32_t pixel = ~0U;
        for (const FragmentNode& node : *nodes) {
            const std::size_t at =
                static_cast<std::size_t>(node.pixel >> 16U) * static_cast<std::size_t>(size) +
                (node.pixel & 0xffffU);
            if (node.pixel != pixel) {
                pixel = node.pixel;
                absorbance = 0;
                lists[at] = {steps.size(), 0};
            }
            absorbance += static_cast<double>(fragment_absorbance(node.color_opacity.a));
            steps.emplace_back(node.depth, static_cast<float>(std::exp(-absorbance)));
            ++lists[at].y;
        }
    }
    DeepShadowMap map;
    map.lists = make_texture(GL_RG32UI, glm::ivec2(size));
    write_texture(map.lists, glm::ivec2(size), GL_RG_INTEGER, GL_UNSIGNED_INT, lists.data());
    const int rows = static_cast<int>(steps.size()) / DEEP_ROW + 1;
    steps.resize(static_cast<std::size_t>(rows) * DEEP_ROW);
    map.steps = make_texture(GL_RG32F, {DEEP_ROW, rows});
    write_texture(map.steps, {DEEP_ROW, rows}, GL_RG, GL_FLOAT, steps.data());
    return map;
}

}  // namespace momentscope
