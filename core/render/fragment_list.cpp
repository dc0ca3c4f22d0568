#include "core/render/fragment_list.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

namespace {

constexpr std::size_t HEADER_BYTES = 16;  // count, capacity, padding

std::size_t bounded_capacity(std::size_t wanted) {
    GLint64 most_bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most_bytes);
    return std::min(wanted, (static_cast<std::size_t>(most_bytes) - HEADER_BYTES) / sizeof(FragmentNode));
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
    : capacity_(bounded_capacity(capacity)), heads_(make_texture(GL_R32UI, size)) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    nodes_ = GlBuffer(name);
    glNamedBufferStorage(nodes_, static_cast<GLsizeiptr>(HEADER_BYTES + capacity_ * sizeof(FragmentNode)),
                         nullptr, GL_DYNAMIC_STORAGE_BIT);
    target_ = make_framebuffer({}, depth);
}

std::size_t FragmentList::capture(const PassInput& input, GLuint program, glm::ivec2 corner,
                                  glm::ivec2 extent) {
    const std::array<std::uint32_t, 4> header = {0, static_cast<std::uint32_t>(capacity_), 0, 0};
    glNamedBufferSubData(nodes_, 0, sizeof(header), header.data());
    const std::uint32_t end_of_list = 0xffffffffU;
    glClearTexSubImage(heads_, 0, corner.x, corner.y, 0, extent.x, extent.y, 1, GL_RED_INTEGER,
                       GL_UNSIGNED_INT, &end_of_list);
    bind();
    glEnable(GL_SCISSOR_TEST);
    glScissor(corner.x, corner.y, extent.x, extent.y);
    glUseProgram(program);
    draw_transparent(input.scene, target_, Blending::none);
    glDisable(GL_SCISSOR_TEST);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    std::uint32_t count = 0;
    glGetNamedBufferSubData(nodes_, 0, sizeof(count), &count);
    return count;
}

void FragmentList::bind() const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, nodes_);
    glBindImageTexture(0, heads_, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
}

std::vector<FragmentNode> FragmentList::read(std::size_t count) const {
    std::vector<FragmentNode> nodes(std::min(count, capacity_));
    if (!nodes.empty())
        glGetNamedBufferSubData(nodes_, HEADER_BYTES,
                                static_cast<GLsizeiptr>(nodes.size() * sizeof(FragmentNode)), nodes.data());
    return nodes;
}

}  // namespace momentscope
