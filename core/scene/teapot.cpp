// teapot.cpp -- tessellates the teapot of Newell: bicubic patches, analytic normals, closed seams.
#include "core/scene/shapes.hpp"
#include "core/scene/teapot_patches.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <map>

namespace momentscope {
namespace {

/// The four cubic Bernstein polynomials and their derivatives at one parameter.
struct Bernstein {
    std::array<double, 4> value;
    std::array<double, 4> slope;
};

Bernstein bernstein(double t) {
    const double s = 1.0 - t;
    return {{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t},
            {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t}};
}

/// The sum of the control points of the patch, weighted by row[i] * column[j].
glm::dvec3 blend(int patch, const std::array<double, 4>& row, const std::array<double, 4>& column) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j)
            sum += row[i] * column[j] * TEAPOT_POINTS[TEAPOT_PATCHES[patch][4 * i + j]];
    }
    return sum;
}

/// The outward unit normal, in the coordinates of Newell, at the point with these weights.
glm::dvec3 patch_normal(int patch, const Bernstein& row, const Bernstein& column) {
    const glm::dvec3 along = blend(patch, row.slope, column.value);
    glm::dvec3 around = blend(patch, row.value, column.slope);
    // At the top of the knob and in the middle of the base, all control points of row 0 are one point, so
    // `around` is 0 there. Nearby it is the row parameter times the mixed second derivative, which therefore
    // gives the direction of the limit.
    if (glm::length(around) < 1e-9) around = blend(patch, row.slope, column.slope);
    return glm::normalize(glm::cross(around, along));
}

/// Neighbouring patches evaluate their common edge from opposite ends, so the results differ by rounding.
/// This would leave cracks, where a pixel would miss a fragment. So equal points become one vertex.
class Welder {
public:
    explicit Welder(Mesh& mesh) : mesh_(mesh) {}

    std::uint32_t add(const glm::dvec3& position, const glm::dvec3& normal) {
        std::vector<std::uint32_t>& here = places_[key(position)];
        for (const std::uint32_t vertex : here) {
            // At a crease (the edge of the base) there are two vertices, but at the same position.
            if (glm::dot(glm::dvec3(mesh_.normals[vertex]), normal) > 0.999) return vertex;
        }
        const auto vertex = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(here.empty() ? glm::vec3(position) : mesh_.positions[here.front()]);
        mesh_.normals.push_back(glm::vec3(normal));
        here.push_back(vertex);
        return vertex;
    }

private:
    using Key = std::array<long, 3>;

    // A grid that is much finer than any tessellation and much coarser than rounding in double.
    static Key key(const glm::dvec3& p) {
        constexpr double CELLS = 1 << 20;
        return {std::lround(p.x * CELLS), std::lround(p.y * CELLS), std::lround(p.z * CELLS)};
    }

    Mesh& mesh_;
    std::map<Key, std::vector<std::uint32_t>> places_;
};

/// Appends a triangle, unless it has shrunk to a line at a pole.
void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void add_patch(Mesh& mesh, Welder& welder, int patch, int divisions) {
    const int side = divisions + 1;
    std::vector<std::uint32_t> grid;
    for (int i = 0; i < side; ++i) {
        const Bernstein row = bernstein(double(i) / divisions);
        for (int j = 0; j < side; ++j) {
            const Bernstein column = bernstein(double(j) / divisions);
            const glm::dvec3 p = 0.5 * blend(patch, row.value, column.value);
            const glm::dvec3 n = patch_normal(patch, row, column);
            grid.push_back(welder.add({p.x, p.z, -p.y}, {n.x, n.z, -n.y}));  // z up -> y up
        }
    }
    const auto at = [&](int i, int j) {
        return grid[static_cast<std::size_t>(i) * static_cast<std::size_t>(side) +
                    static_cast<std::size_t>(j)];
    };
    for (int i = 0; i < divisions; ++i) {
        for (int j = 0; j < divisions; ++j) {
            add_triangle(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1));
            add_triangle(mesh, at(i, j), at(i + 1, j + 1), at(i + 1, j));
        }
    }
}

}  // namespace

Mesh make_teapot(int divisions) {
    assert(divisions >= 1);
    Mesh mesh;
    Welder welder(mesh);
    for (int patch = 0; patch < TEAPOT_PATCH_COUNT; ++patch) add_patch(mesh, welder, patch, divisions);
    return mesh;
}

}  // namespace momentscope
