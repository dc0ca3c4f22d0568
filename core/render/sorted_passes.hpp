// sorted_passes.hpp -- ground truth: all fragments of each pixel, sorted.
#pragma once
#include "core/render/fragment_list.hpp"

namespace momentscope {

class SortedPasses : public Transparency {
public:
    /// The GL must have storage.
    SortedPasses(glm::ivec2 size, GLuint depth, const Capabilities& gl);
    void draw_moments(const PassInput&) override {}
    void draw_color(const PassInput&) override {}

    /// Captures and composites the picture in bands of as many rows as the list can hold. So memory is
    /// bounded, whatever the number of fragments.
    void draw_composite(const PassInput& input, GLuint target) override;

private:
    FragmentList list_;
};

}  // namespace momentscope
