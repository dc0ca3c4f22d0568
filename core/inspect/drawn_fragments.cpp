#include "core/inspect/drawn_fragments.hpp"

#include <algorithm>
#include <set>

#include "core/inspect/method_pixel.hpp"

namespace momentscope {

ViewRay drawn_fragments(const ViewRay& ray, const Technique& technique) {
    if (technique.path != RenderPath::peeling) return ray;
    const bool known = ray.near_plane > 0 && ray.far_plane > ray.near_plane;
    ViewRay drawn = ray;
    std::set<float> taken;
    std::erase_if(drawn.fragments, [&](const Fragment& fragment) {
        return !taken.insert(known ? method_fragment(ray, fragment).window_depth : fragment.depth).second;
    });
    return drawn;
}

bool has_ties(const ViewRay& ray) {
    std::vector<float> depths = own_depths(ray);
    std::ranges::sort(depths);
    return std::ranges::adjacent_find(depths) != depths.end();
}

}  // namespace momentscope
