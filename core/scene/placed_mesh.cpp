// placed_mesh.cpp -- keeps positions in double until the centre is subtracted.
#include "core/scene/placed_mesh.hpp"

#include "core/scene/mesh_error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace momentscope {
namespace {

constexpr std::uint32_t UNUSED = std::numeric_limits<std::uint32_t>::max();
constexpr double HALF_STEP = 0x1p-24;      // half a step of floats, relative
constexpr double MIN_NORMAL = 0x1p-126;    // below it floats are as far apart as at it
constexpr double ALLOWED_ROUNDING = 1e-4;  // of the half diagonal: a tenth of a pixel of a large picture
constexpr double MIN_AREA = 1e-4;  // of the half diagonal squared: about ten pixels of a large picture
constexpr float MIN_CORE = 1e-4f;  // of the half diagonal: smaller than a pixel

/// Finds vertices with the same position and normal to the last bit, with a hash table of open addresses.
class EqualVertices {
public:
    EqualVertices(const VertexArrays& vertices, std::size_t count)
        : vertices_(vertices), table_(std::bit_ceil(2 * count + 1), UNUSED) {}

    /// An equal vertex that was asked for before, or the vertex itself.
    std::uint32_t first_like(std::uint32_t vertex) {
        const Key key = key_of(vertex);
        std::uint64_t hash = 0;
        for (const std::uint32_t part : key) hash = (hash ^ part) * 0x9E3779B97F4A7C15u;
        for (std::size_t at = (hash ^ (hash >> 32)) & (table_.size() - 1);;
             at = (at + 1) & (table_.size() - 1)) {
            if (table_[at] == UNUSED) table_[at] = vertex;
            if (table_[at] == vertex || key_of(table_[at]) == key) return table_[at];
        }
    }

private:
    using Key = std::array<std::uint32_t, 6>;

    Key key_of(std::uint32_t vertex) const {
        const aiVector3D& p = vertices_.positions[vertex];
        const aiVector3D n = vertices_.normals != nullptr ? vertices_.normals[vertex] : aiVector3D();
        const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); };  // makes 0 of -0
        return {bits(p.x), bits(p.y), bits(p.z), bits(n.x), bits(n.y), bits(n.z)};
    }

    VertexArrays vertices_;
    std::vector<std::uint32_t> table_;
};

glm::dvec3 to_double(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// The unit vector, or zero if v has no direction.
glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 1e-30 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0f);
}

/// The matrices by which positions and normals of one mesh are multiplied.
struct Transforms {
    glm::dmat4 position;
    glm::dmat3 normal;  // the transpose of the inverse, up to a positive factor
    glm::dmat3 magnitude;
    bool mirrors;

    explicit Transforms(const Placement& placement)
        : position(placement.transform * glm::dmat4(glm::dmat3(placement.unit))) {
        const glm::dmat3 linear(placement.transform);
        const double sign = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
        mirrors = sign < 0.0;
        // The cofactors, which exist also for flat transforms.
        normal = sign * glm::dmat3(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        for (int column = 0; column < 3; ++column) magnitude[column] = glm::abs(linear[column]);
    }
};

void note_rounding(PlacedMesh& placed, const glm::dvec3& local, const glm::dmat3& magnitude,
                   const Placement& placement) {
    const glm::dvec3 size = placement.unit * glm::abs(local);
    const glm::dvec3 errors = magnitude * (glm::max(size, glm::dvec3(MIN_NORMAL)) * HALF_STEP);
    const double error = placement.rounding + std::max({errors.x, errors.y, errors.z});
    if (!(error > placed.rounding)) return;
    placed.rounding = error;
    placed.coordinate = std::max({placement.coordinate, size.x, size.y, size.z});
}

/// Makes every normal a unit vector. Files contain normals of length zero and NaN. These become the mean
/// normal of the triangles around the vertex, or point up.
void repair_normals(Mesh& mesh) {
    std::vector<glm::dvec3> around(mesh.normals.size(), glm::dvec3(0.0));
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[t]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[t + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[t + 2]]);
        const glm::dvec3 area = glm::cross(b - a, c - a);
        for (std::size_t corner = 0; corner < 3; ++corner) around[mesh.indices[t + corner]] += area;
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        for (const glm::dvec3& candidate : {glm::dvec3(mesh.normals[i]), around[i], glm::dvec3(0, 1, 0)}) {
            mesh.normals[i] = unit_or_zero(candidate);
            if (mesh.normals[i] != glm::vec3(0.0f)) break;
        }
    }
}

/// The total area of all triangles.
double area_of(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[t]]);
        area += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[mesh.indices[t + 1]]) - a,
                                             glm::dvec3(mesh.positions[mesh.indices[t + 2]]) - a));
    }
    return area;
}

/// True if all vertices, except a tenth of them at either end, lie within a region that is smaller than a
/// pixel.
bool is_mostly_a_speck(const Mesh& mesh) {
    constexpr std::size_t FEWEST = 16;
    const std::size_t count = mesh.positions.size();
    if (count < FEWEST) return false;
    std::vector<float> values(count);
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::transform(mesh.positions, values.begin(), [&](const glm::vec3& p) { return p[axis]; });
        const auto low = values.begin() + static_cast<std::ptrdiff_t>(count / 10);
        const auto high = values.begin() + static_cast<std::ptrdiff_t>(count - 1 - count / 10);
        std::ranges::nth_element(values, low);
        const float lowest = *low;
        std::ranges::nth_element(values, high);
        if (*high - lowest > MIN_CORE) return false;
    }
    return true;
}

void warn_of_nothing(std::vector<std::string>& warnings, const Mesh& mesh,
                     const std::filesystem::path& path) {
    if (area_of(mesh) < MIN_AREA)
        warnings.push_back(mesh_sentence(
            path,
            "shows almost nothing, because all its triangles are thin or small compared with its extent; "
            "remove vertices that lie far away and check that it is a surface."));
    else if (is_mostly_a_speck(mesh))
        warnings.push_back(mesh_sentence(
            path,
            "shows most of its vertices within less than a pixel, because some others lie far away; remove those."));
}

}  // namespace

void append_mesh(PlacedMesh& placed, const aiMesh& mesh, const VertexArrays& vertices,
                 const Placement& placement) {
    const Transforms transforms(placement);
    EqualVertices equal(vertices, mesh.mNumVertices);
    std::vector<std::uint32_t> renumbered(mesh.mNumVertices, UNUSED);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) {
            ++placed.not_shown;
            continue;
        }
        for (unsigned corner = 0; corner < 3; ++corner) {
            // A reflection turns counter-clockwise triangles into clockwise ones. Swapping two corners undoes
            // this.
            const std::uint32_t vertex =
                equal.first_like(face.mIndices[transforms.mirrors ? 2 - corner : corner]);
            std::uint32_t& index = renumbered[vertex];
            if (index == UNUSED) {
                index = static_cast<std::uint32_t>(placed.positions.size());
                const glm::dvec3 local = to_double(vertices.positions[vertex]);
                placed.positions.emplace_back(transforms.position * glm::dvec4(local, 1.0));
                placed.normals.push_back(
                    vertices.normals != nullptr
                        ? unit_or_zero(transforms.normal * to_double(vertices.normals[vertex]))
                        : glm::vec3(0.0f));
                note_rounding(placed, local, transforms.magnitude, placement);
            }
            placed.indices.push_back(index);
        }
    }
}

void warn_of_rounding(std::vector<std::string>& warnings, const std::filesystem::path& path,
                      double coordinate, double rounding, double half_diagonal) {
    if (rounding > ALLOWED_ROUNDING * half_diagonal)
        warnings.push_back(mesh_sentence(
            path,
            fmt::format(
                "has coordinates as large as {:.10g}, where numbers lie {:.2g} apart, but a half diagonal of "
                "only {:.4g}, so its shape is rounded; move it to the origin, or scale it up "
                "if it is tiny, and export it again.",
                coordinate, 2.0 * rounding, half_diagonal)));
}

LoadedMesh centered_mesh(PlacedMesh placed, const std::filesystem::path& path) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const glm::dvec3& p : placed.positions) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            refuse_mesh(
                path,
                "has a vertex with an infinite or NaN coordinate; repair the mesh and export it again.");
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec3 half = 0.5 * high - 0.5 * low;
    const double half_diagonal = std::hypot(half.x, half.y, half.z);
    if (!std::isfinite(half_diagonal))
        refuse_mesh(path, "is larger than any number can be; scale it down and export it again.");
    if (!(half_diagonal > 0.0)) refuse_mesh(path, "has all its triangles in one point; export it again.");

    LoadedMesh loaded{{{}, std::move(placed.normals), std::move(placed.indices)}};
    const glm::dvec3 center = 0.5 * low + 0.5 * high;
    loaded.mesh.positions.reserve(placed.positions.size());
    for (const glm::dvec3& p : placed.positions)
        loaded.mesh.positions.emplace_back((p - center) / half_diagonal);
    repair_normals(loaded.mesh);

    warn_of_rounding(loaded.warnings, path, placed.coordinate, placed.rounding, half_diagonal);
    warn_of_nothing(loaded.warnings, loaded.mesh, path);
    return loaded;
}

}  // namespace momentscope
