#include "core/inspect/drawn_fragments.hpp"

#include <algorithm>
#include <set>

#include "core/inspect/pixel_state_curve.hpp"

namespace momentscope {

std::vector<bool> drawn_flags(const ViewRay& ray, const Technique& technique) {
    std::vector<bool> drawn(ray.fragments.size(), true);
    if (!technique.is_truth() || technique.truth().way != GroundTruth::Way::peeling) return drawn;
    const bool known = ray.near_plane > 0 && ray.far_plane > ray.near_plane;
    std::set<float> taken;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Fragment& fragment = ray.fragments[i];
        drawn[i] =
            taken.insert(known ? pixel_state_fragment(ray, fragment).window_depth : fragment.depth).second;
    }
    return drawn;
}

ViewRay drawn_fragments(const ViewRay& ray, const Technique& technique) {
    const std::vector<bool> drawn = drawn_flags(ray, technique);
    ViewRay result = ray;
    result.fragments.clear();
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (drawn[i]) result.fragments.push_back(ray.fragments[i]);
    return result;
}

bool has_ties(const ViewRay& ray) {
    std::vector<float> depths = own_depths(ray);
    std::ranges::sort(depths);
    return std::ranges::adjacent_find(depths) != depths.end();
}

}  // namespace momentscope
