// scene.hpp -- a scene: triangle meshes, opaque or transparent, with a camera, a light and a background.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/image/alpha_map.hpp"

namespace momentscope {

/// Triangles with one unit normal per vertex. indices.size() is a multiple of 3, and every index is less than
/// positions.size(). normals.size() == positions.size(). There are as many texture coordinates as positions,
/// or none.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec2> texture_coordinates = {};  // (0, 0): lower left corner of the map
};

/// One draw call: a mesh placed in the world with one material.
struct Object {
    std::uint32_t mesh = 0;                       // index into Scene::meshes
    glm::mat4 model = glm::mat4(1);               // rigid or uniformly scaled, so normals need no inverse
    glm::vec3 color = glm::vec3(1);               // linear RGB albedo, >= 0
    float opacity = 1.0f;                         // alpha_l, in [0, 1]; 1 without a map: opaque
    std::optional<std::uint32_t> alpha_map = {};  // index into Scene::alpha_maps; multiplies opacity
    bool casts_shadow = true;                     // an endless ground only receives shadows
    bool opaque() const { return opacity >= 1.0f && !alpha_map; }
};

/// A point light. The angles are as in Camera and give its direction from the centre of the casters.
struct Light {
    float azimuth = -0.7f;
    float elevation = 0.9f;  // in [0, pi / 2]
    friend bool operator==(const Light&, const Light&) = default;
};

/// A pinhole camera that orbits `target`. Angles in radians; y is up.
struct Camera {
    glm::vec3 target = glm::vec3(0);
    float distance = 5.0f;       // scene units, > 0
    float azimuth = 0.0f;        // 0 looks along -z
    float elevation = 0.0f;      // in (-pi/2, pi/2); positive looks down
    float field_of_view = 0.8f;  // vertical, in radians
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Everything that is drawn. Objects are submitted in the order of `objects`.
struct Scene {
    std::string id;  // id in the registry, or file name
    std::vector<Mesh> meshes;
    std::vector<AlphaMap> alpha_maps;
    std::vector<Object> objects;
    Camera camera;
    Light light;
    glm::vec3 background = glm::vec3(0.8f);  // linear RGB
    glm::vec2 picked = glm::vec2(0.5f);      // pixel to pick at first, as a fraction of the
                                             // picture, from its upper left corner
    std::vector<std::string> warnings;       // a sentence for all that is not shown as it was meant
};

struct Sphere {
    glm::vec3 center = glm::vec3(0);
    float radius = 0.0f;
};

/// A sphere around all vertices of all transparent objects in world space (paper, Section 3.3). It is
/// conservative, not the smallest. The radius is 0 if nothing is transparent.
Sphere transparent_bounds(const Scene& scene);

/// The same around everything that casts shadows, opaque or transparent.
Sphere caster_bounds(const Scene& scene);

}  // namespace momentscope
