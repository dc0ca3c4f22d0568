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
    if (source_ == nullptr)
        source_ = make_fragment_source(glm::ivec2(size_), CAPACITY, no_depth_, programs_->gl());
    set_viewport(glm::ivec2(size_));
    bind_uniforms(0, frame_block);
    static const ResolvedParameters NONE;
    const PassInput input = {*programs_, scene, glm::ivec2(size_), 0, no_depth_, NONE};
    return source_->capture(input, {}, rect);
}

}  // namespace momentscope
