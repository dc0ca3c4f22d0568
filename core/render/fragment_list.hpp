// fragment_list.hpp -- captures all transparent fragments of a region of the picture.
#pragma once
#include <memory>
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

/// The fragment that a node holds, with its random seed.
Fragment fragment_of(const FragmentNode& node, const SceneBuffers& scene);

/// A way to capture fragments.
class FragmentSource {
public:
    virtual ~FragmentSource() = default;

    /// The fragments of a rectangle, in GL pixels, those of each pixel in submission order; nullopt if there
    /// are more than this source captures at a time. variant: of capture.frag.
    virtual std::optional<std::vector<FragmentNode>> capture(const PassInput& input,
                                                             const ShaderVariant& variant,
                                                             const TexelRect& rect) = 0;
};

/// The way of this GL: lists, or layers if shaders cannot write lists. capacity: the number of fragments for
/// which memory is taken. depth: the texture that fragments are tested against.
std::unique_ptr<FragmentSource> make_fragment_source(glm::ivec2 size, std::size_t capacity, GLuint depth,
                                                     const Capabilities& gl);

/// A bounded list of fragments on the GPU, with one list head per pixel. Needs storage.
class FragmentList : public FragmentSource {
public:
    /// capacity: limited to what this GL allows in one buffer.
    FragmentList(glm::ivec2 size, std::size_t capacity, GLuint depth, const Capabilities& gl);

    std::optional<std::vector<FragmentNode>> capture(const PassInput& input, const ShaderVariant& variant,
                                                     const TexelRect& rect) override;

    /// Appends the fragments of a rectangle to empty lists. Returns how many fragments there are; only the
    /// first capacity() of them are stored.
    std::size_t append(const PassInput& input, const ShaderVariant& variant, const TexelRect& rect);

    void bind() const;
    std::size_t capacity() const { return capacity_; }

private:
    std::vector<FragmentNode> read(std::size_t count) const;

    std::size_t capacity_;
    GlTexture heads_;
    GlBuffer nodes_;
    GlFramebuffer heads_target_;  // to clear them
    GlFramebuffer target_;        // depth test only, no colours
};

}  // namespace momentscope
