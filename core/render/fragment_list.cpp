#include "core/render/fragment_list.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "core/gl/buffer.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

namespace {

constexpr std::size_t HEADER_BYTES = 16;  // count, capacity, padding

std::size_t bounded_capacity(std::size_t wanted) {
    return std::min(wanted, (most_bytes_of_storage() - HEADER_BYTES) / sizeof(FragmentNode));
}

}  // namespace

std::vector<FragmentNode> in_submission_order(std::vector<FragmentNode> nodes) {
    std::ranges::sort(nodes, {},
                      [](const FragmentNode& node) { return std::pair(node.draw, node.primitive); });
    return nodes;
}

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

FragmentList::FragmentList(glm::ivec2 size, std::size_t capacity, GLuint depth)
    : capacity_(bounded_capacity(capacity)),
      heads_(make_texture(GL_R32UI, size)),
      nodes_(make_buffer(HEADER_BYTES + capacity_ * sizeof(FragmentNode))),
      heads_target_(make_framebuffer({heads_}, 0)),
      target_(make_framebuffer({}, depth)) {}

std::size_t FragmentList::capture(const PassInput& input, GLuint program, const TexelRect& rect) {
    constexpr glm::uvec4 END_OF_LIST(0xffffffffU);
    write_buffer(nodes_, std::array<std::uint32_t, 4>{0, static_cast<std::uint32_t>(capacity_), 0, 0});
    clear_color(heads_target_, 0, END_OF_LIST, rect);
    bind();
    use_program(program);
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
