// fragment_list.hpp -- captures all transparent fragments of a region of the picture.
#pragma once
#include <optional>
#include <vector>

#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"
#include "core/ray/view_ray.hpp"
#include "core/render/transparency.hpp"

namespace momentscope {

/// shaders/passes/fragment_list.glsl in C++ (std430).
struct FragmentNode {
    glm::vec4 color_opacity;
    float view_depth;
    float depth;
    float transmittance;
    std::uint32_t draw;
    std::uint32_t primitive;
    std::uint32_t next;
    std::uint32_t pixel;  // x + 65536 y, counted from the lower left
    float threshold;
};
static_assert(sizeof(FragmentNode) == 48);

constexpr std::size_t PIXEL_LIST_CAPACITY = 65'536;  // fragments in a captured region

/// The nodes, sorted by draw call and triangle. The append order is nondeterministic.
std::vector<FragmentNode> in_submission_order(std::vector<FragmentNode> nodes);

/// The fragment that a node holds, with its random seed.
Fragment fragment_of(const FragmentNode& node, const SceneBuffers& scene);

/// A bounded list of fragments on the GPU, with one list head per pixel.
class FragmentList {
public:
    /// capacity: the number of fragments that fit, limited to what this GL allows in one buffer. depth: the
    /// texture that fragments are tested against.
    FragmentList(glm::ivec2 size, std::size_t capacity, GLuint depth);

    /// Captures the fragments of a rectangle, in GL pixels, with `program` (capture.frag). Returns how many
    /// fragments there are; only the first capacity() of them are stored.
    std::size_t capture(const PassInput& input, GLuint program, const TexelRect& rect);

    void bind() const;
    std::size_t capacity() const { return capacity_; }
    std::vector<FragmentNode> read(std::size_t count) const;

private:
    std::size_t capacity_;
    GlTexture heads_;
    GlBuffer nodes_;
    GlFramebuffer heads_target_;  // to clear them
    GlFramebuffer target_;        // depth test only, no colours
};

}  // namespace momentscope
