#include "core/render/fragment_list.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "core/gl/buffer.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/peeled_fragments.hpp"

namespace momentscope {

namespace {

constexpr std::size_t HEADER_BYTES = 16;  // count, capacity, padding

std::size_t bounded_capacity(std::size_t wanted, const Capabilities& gl) {
    return std::min(wanted, (gl.storage_bytes - HEADER_BYTES) / sizeof(FragmentNode));
}

}  // namespace

Fragment fragment_of(const FragmentNode& node, const SceneBuffers& scene) {
    return {.depth = node.depth,
            .view_depth = node.view_depth,
            .opacity = node.color_opacity.a,
            .color = glm::vec3(node.color_opacity),
            .draw = node.draw,
            .primitive = node.primitive,
            .seed = fragment_seed(node.pixel, scene.object_of_draw(node.draw),
                                  std::bit_cast<std::uint32_t>(node.view_depth)),
            .threshold = node.threshold};
}

std::unique_ptr<FragmentSource> make_fragment_source(glm::ivec2 size, std::size_t capacity, GLuint depth,
                                                     const Capabilities& gl) {
    if (gl.storage) return std::make_unique<FragmentList>(size, capacity, depth, gl);
    return std::make_unique<PeeledFragments>(size, depth, gl);
}

FragmentList::FragmentList(glm::ivec2 size, std::size_t capacity, GLuint depth, const Capabilities& gl)
    : capacity_(bounded_capacity(capacity, gl)),
      heads_(make_texture(GL_R32UI, size)),
      nodes_(make_buffer(HEADER_BYTES + capacity_ * sizeof(FragmentNode))),
      heads_target_(make_framebuffer({heads_}, 0)),
      target_(make_framebuffer({}, depth)) {}

// The append order is nondeterministic.
std::optional<std::vector<FragmentNode>> FragmentList::capture(const PassInput& input,
                                                               const ShaderVariant& variant,
                                                               const TexelRect& rect) {
    const std::size_t count = append(input, variant, rect);
    if (count > capacity_) return std::nullopt;
    std::vector<FragmentNode> nodes = read(count);
    std::ranges::sort(nodes, {},
                      [](const FragmentNode& node) { return std::pair(node.draw, node.primitive); });
    return nodes;
}

std::size_t FragmentList::append(const PassInput& input, const ShaderVariant& variant,
                                 const TexelRect& rect) {
    constexpr glm::uvec4 END_OF_LIST(0xffffffffU);
    write_buffer(nodes_, std::array<std::uint32_t, 4>{0, static_cast<std::uint32_t>(capacity_), 0, 0});
    clear_color(heads_target_, 0, END_OF_LIST, rect);
    bind();
    use_program(input.programs.get("passes/scene.vert", "passes/capture.frag", variant));
    draw_transparent(input.scene, target_, {.scissor = rect});
    finish_shader_writes();
    std::uint32_t count = 0;
    read_buffer(nodes_, 0, std::as_writable_bytes(std::span(&count, 1)));
    return count;
}

void FragmentList::bind() const {
    bind_storage(0, nodes_);
    bind_image(0, heads_, GL_R32UI);
}

std::vector<FragmentNode> FragmentList::read(std::size_t count) const {
    std::vector<FragmentNode> nodes(std::min(count, capacity_));
    if (!nodes.empty()) read_buffer(nodes_, HEADER_BYTES, std::as_writable_bytes(std::span(nodes)));
    return nodes;
}

}  // namespace momentscope
