#include "core/shadow/cast_ray.hpp"

#include <algorithm>
#include <cmath>
#define GLM_ENABLE_EXPERIMENTAL  // of intersectRayTriangle
#include <glm/gtx/intersect.hpp>
#include <limits>

#include "core/ray/view_ray.hpp"

namespace momentscope {

namespace {

// The map sampled as the GL samples level 0: bilinear and repeated.
float sampled(const AlphaMap& map, const glm::vec2& place) {
    const auto at = [&](int x, int y) {
        const int column = ((x % map.width) + map.width) % map.width,
                  row = ((y % map.height) + map.height) % map.height;
        return static_cast<float>(map.bytes[static_cast<std::size_t>(row * map.width + column)]) / 255.0f;
    };
    const glm::vec2 texel = place * glm::vec2(map.width, map.height) - 0.5f;
    const glm::vec2 below = glm::floor(texel);
    const glm::vec2 part = texel - below;
    const glm::ivec2 corner(below);
    return glm::mix(glm::mix(at(corner.x, corner.y), at(corner.x + 1, corner.y), part.x),
                    glm::mix(at(corner.x, corner.y + 1), at(corner.x + 1, corner.y + 1), part.x), part.y);
}

bool may_meet(const Mesh& mesh, const glm::vec3& from, const glm::vec3& direction) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 center = 0.5f * (low + high);
    const float radius = 1.001f * glm::distance(low, center);
    const glm::vec3 to_center = center - from;
    const glm::vec3 across =
        to_center - direction * (glm::dot(to_center, direction) / glm::dot(direction, direction));
    return glm::dot(across, across) <= radius * radius;
}

}  // namespace

CastLight cast_light(const Scene& scene, const glm::vec3& from, const glm::vec3& to, float slack) {
    CastLight result;
    const float length = glm::distance(from, to);
    for (const Object& object : scene.objects) {
        if (object.opaque() && !object.casts_shadow) continue;
        const glm::mat4 back = glm::inverse(object.model);
        const glm::vec3 origin(back * glm::vec4(from, 1)), direction(back * glm::vec4(to - from, 0));
        const Mesh& mesh = scene.meshes[object.mesh];
        if (mesh.positions.empty() || !may_meet(mesh, origin, direction)) continue;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const std::uint32_t* corner = &mesh.indices[i];
            glm::vec2 place;
            float distance = 0;  // as a fraction of the way from `from` to `to`
            if (!glm::intersectRayTriangle(origin, direction, mesh.positions[corner[0]],
                                           mesh.positions[corner[1]], mesh.positions[corner[2]], place,
                                           distance))
                continue;
            if (distance * length < slack || distance > 1) continue;
            if (object.opaque()) {
                result.shadowed = true;
                continue;
            }
            float opacity = object.opacity;
            if (object.alpha_map) {
                const auto& uv = mesh.texture_coordinates;
                opacity *= sampled(scene.alpha_maps[*object.alpha_map],
                                   (1 - place.x - place.y) * uv[corner[0]] + place.x * uv[corner[1]] +
                                       place.y * uv[corner[2]]);
            }
            result.transmittance *= std::exp(-static_cast<double>(fragment_absorbance(opacity)));
        }
    }
    return result;
}

}  // namespace momentscope
