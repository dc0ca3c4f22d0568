#include "core/render/peeled_fragments.hpp"

#include <algorithm>

#include "core/gl/draw_state.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

namespace {

constexpr std::size_t MOST_FRAGMENTS = 2'500'000;  // of one capture; 120 MB
constexpr std::uint32_t MOST_LAYERS = 255;         // that a stencil of 8 bits can count
constexpr GLuint OPAQUE_DEPTH_UNIT = 11;           // capture.frag

}  // namespace

PeeledFragments::PeeledFragments(glm::ivec2 size, GLuint depth, const Capabilities& gl)
    : depth_(depth),
      primitive_ids_(gl.primitive_ids),
      color_(make_texture(GL_RGBA32F, size)),
      depths_(make_texture(GL_RGBA32F, size)),
      numbers_(make_texture(GL_RGBA32F, size)),
      count_(make_texture(GL_DEPTH24_STENCIL8, size)),
      target_(make_counting_framebuffer({color_, depths_, numbers_}, count_)) {}

std::optional<std::vector<FragmentNode>> PeeledFragments::capture(const PassInput& input,
                                                                  const ShaderVariant& variant,
                                                                  const TexelRect& rect) {
    ShaderVariant layered = variant;
    layered.defines["LAYERED"] = "1";
    if (!primitive_ids_) layered.defines["NO_PRIMITIVE_IDS"] = "1";
    const GLuint program = input.programs.get("passes/scene.vert", "passes/capture.frag", layered);
    bind_texture(OPAQUE_DEPTH_UNIT, depth_);
    use_program(program);
    std::vector<FragmentNode> nodes;
    const TriangleRange all = {0, input.scene.triangle_count(Surfaces::transparent)};
    if (!capture_triangles(input.scene, all, primitive_ids_, rect, nodes)) return std::nullopt;
    return nodes;
}

// If a pixel has more fragments than can be counted, parts of the triangles are captured one after another.
// The GL counts the triangles of a part from 0, so there the order of submission numbers them. False if there
// are too many fragments.
bool PeeledFragments::capture_triangles(const SceneBuffers& scene, const TriangleRange& triangles,
                                        bool numbered, const TexelRect& rect,
                                        std::vector<FragmentNode>& nodes) const {
    const std::size_t before = nodes.size();
    for (std::uint32_t layer = 0; layer <= MOST_LAYERS; ++layer) {
        if (nodes.size() > MOST_FRAGMENTS) return false;
        clear_color(target_, 2, glm::vec4(0), rect);
        clear_stencil(target_, rect);
        set_draw_state({.scissor = rect, .passing_count = layer});
        bind_framebuffer(target_);
        scene.draw(Surfaces::transparent, triangles);
        const std::vector<glm::vec4> numbers = read_colors(numbers_, rect);
        if (std::ranges::none_of(numbers, [](const glm::vec4& texel) { return texel.w > 0; })) return true;
        if (layer == MOST_LAYERS) break;
        const std::size_t first_new = nodes.size();
        read_layer(rect, numbers, nodes);
        // A triangle covers a pixel at most once, so these numbers ascend in the order of submission.
        for (std::size_t i = first_new; !numbered && i < nodes.size(); ++i)
            nodes[i].primitive = static_cast<std::uint32_t>(triangles.first) + layer;
    }
    nodes.resize(before);
    const std::size_t half = triangles.count / 2;
    return half > 0 && capture_triangles(scene, {triangles.first, half}, false, rect, nodes) &&
           capture_triangles(scene, {triangles.first + half, triangles.count - half}, false, rect, nodes);
}

void PeeledFragments::read_layer(const TexelRect& rect, const std::vector<glm::vec4>& numbers,
                                 std::vector<FragmentNode>& nodes) const {
    const auto captured = [](const glm::vec4& texel) { return texel.z > 0; };
    if (std::ranges::none_of(numbers, captured)) return;  // all lie behind opaque surfaces
    const std::vector<glm::vec4> colors = read_colors(color_, rect), depths = read_colors(depths_, rect);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!captured(numbers[i])) continue;
        const auto width = static_cast<std::size_t>(rect.extent.x);
        const auto x = static_cast<std::uint32_t>(rect.corner.x) + static_cast<std::uint32_t>(i % width);
        const auto y = static_cast<std::uint32_t>(rect.corner.y) + static_cast<std::uint32_t>(i / width);
        nodes.push_back({.color_opacity = colors[i],
                         .view_depth = depths[i].x,
                         .depth = depths[i].y,
                         .transmittance = depths[i].z,
                         .draw = static_cast<std::uint32_t>(numbers[i].x),
                         .primitive = static_cast<std::uint32_t>(numbers[i].y),
                         .next = 0,
                         .pixel = x + 65536U * y,
                         .threshold = depths[i].w});
    }
}

}  // namespace momentscope
