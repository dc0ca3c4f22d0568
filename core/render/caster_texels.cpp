#include "core/render/caster_texels.hpp"

#include <utility>

#include "core/gl/buffer.hpp"
#include "core/gl/draw_state.hpp"
#include "core/gl/framebuffer.hpp"

namespace momentscope {

CasterTexels::CasterTexels(int size, std::shared_ptr<ProgramCache> programs)
    : size_(size),
      programs_(std::move(programs)),
      no_depth_(make_texture(GL_DEPTH_COMPONENT32F, glm::ivec2(size))) {
    clear_depth(make_framebuffer({}, no_depth_), 1);
}

std::optional<std::vector<FragmentNode>> CasterTexels::capture(const SceneBuffers& scene, GLuint frame_block,
                                                               const TexelRect& rect) {
    constexpr std::size_t CAPACITY = 1'000'000;
    if (list_ == nullptr) list_ = std::make_unique<FragmentList>(glm::ivec2(size_), CAPACITY, no_depth_);
    set_viewport(glm::ivec2(size_));
    bind_uniforms(0, frame_block);
    static const ResolvedParameters NONE;
    const PassInput input = {*programs_, scene, glm::ivec2(size_), 0, no_depth_, NONE};
    const GLuint program = programs_->get("passes/scene.vert", "passes/capture.frag");
    const std::size_t count = list_->capture(input, program, rect);
    if (count > list_->capacity()) return std::nullopt;
    return list_->read(count);
}

}  // namespace momentscope
