// scene.hpp -- what is drawn: triangle meshes, opaque or transparent, a camera and a background.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/image/alpha_map.hpp"

namespace momentscope {

/// Triangles with one unit normal per vertex. indices.size() is a multiple of 3, every index is
/// < positions.size(), and normals.size() == positions.size(). Texture coordinates are as many or none.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec2> texture_coordinates = {};  // (0, 0) is a map's lower left corner
};

/// One draw call: a mesh placed in the world with one material.
struct Object {
    std::uint32_t mesh = 0;          // index into Scene::meshes
    glm::mat4 model = glm::mat4(1);  // rigid or uniformly scaled, so that normals need no inverse
    glm::vec3 color = glm::vec3(1);  // linear RGB albedo, >= 0
    float opacity = 1.0f;            // alpha_l in [0, 1]; 1 without a map is drawn in the opaque pass
    std::optional<std::uint32_t> alpha_map = {};  // index into Scene::alpha_maps; opacity is multiplied by it
    bool casts_shadow = true;                     // a ground that goes on for ever only receives
    bool opaque() const { return opacity >= 1.0f && !alpha_map; }
};

/// A point that lights the scene, seen from the centre of its casters: angles as of Camera.
struct Light {
    float azimuth = -0.7f;
    float elevation = 0.9f;  // [0, pi / 2]
    friend bool operator==(const Light&, const Light&) = default;
};

/// A pinhole camera that orbits `target`. Angles in radians; y is up.
struct Camera {
    glm::vec3 target = glm::vec3(0);
    float distance = 5.0f;       // scene units, > 0
    float azimuth = 0.0f;        // 0 looks along -z
    float elevation = 0.0f;      // (-pi/2, pi/2), positive looks down
    float field_of_view = 0.8f;  // vertical, radians
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Everything that is drawn. Objects are submitted in the order in which they stand here.
struct Scene {
    std::string id;  // registry id or file name
    std::vector<Mesh> meshes;
    std::vector<AlphaMap> alpha_maps;
    std::vector<Object> objects;
    Camera camera;
    Light light;
    glm::vec3 background = glm::vec3(0.8f);  // linear RGB
    glm::vec2 picked = glm::vec2(0.5f);      // the pixel worth seeing first, as a fraction of
                                             // the picture, from its upper left corner
    std::vector<std::string> warnings;  // a sentence for everything that is shown otherwise than it was meant
};

struct Sphere {
    glm::vec3 center = glm::vec3(0);
    float radius = 0.0f;
};

/// A sphere around every vertex of every transparent object in world space (Section 3.3 of the
/// paper). Conservative, not the smallest; radius 0 when nothing is transparent.
Sphere transparent_bounds(const Scene& scene);

/// The same around everything that casts shadows, opaque or transparent.
Sphere caster_bounds(const Scene& scene);

}  // namespace momentscope
