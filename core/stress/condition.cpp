#include "core/stress/condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/support/error.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

using Make = decltype(Condition::make);

int nodes_of(const Technique& technique) {
    return !technique.has_moments() ? 4 : technique.moment_kernel().node_count;
}

// The function of a condition that only defines the ray.
Make of_ray(std::function<ViewRay(RandomNumbers&, const Technique&)> ray) {
    return [ray = std::move(ray)](RandomNumbers& random, const Technique& technique,
                                  const ParameterValues& base) {
        return StressCase{ray(random, technique), base};
    };
}

void add_counts(std::vector<Condition>& rows) {
    const auto count = [&](const char* id, const char* name, const char* help, auto fragments) {
        rows.push_back(
            {id, name, "fragments", help, 4, of_ray([fragments](RandomNumbers& random, const Technique& t) {
                 return random_ray(random, fragments(t));
             })});
    };
    count("one", "1", "One fragment: without bias the moment matrix is singular.",
          [](const Technique&) { return 1; });
    count("two", "2", "Two fragments: without bias the moment matrix is still singular.",
          [](const Technique&) { return 2; });
    count("nodes", "n",
          "As many fragments as the moments determine: m/2 for power moments, m for trigonometric ones.",
          [](const Technique& t) { return nodes_of(t); });
    count("nodes+1", "n+1", "One fragment more than that: still exact at the fragments' own depths.",
          [](const Technique& t) { return nodes_of(t) + 1; });
}

void add_gaps(std::vector<Condition>& rows) {
    for (int exponent = 1; exponent <= 7; ++exponent) {
        const float gap = std::pow(10.0f, -static_cast<float>(exponent));
        rows.push_back({fmt::format("gap-1e-{}", exponent), fmt::format("1e-{}", exponent),
                        "two surfaces apart by",
                        fmt::format("Two surfaces at a distance of {:g} in the depth range [-1, 1].", gap), 2,
                        of_ray([gap](RandomNumbers& random, const Technique&) {
                            const float z = random.uniform(-1, 1 - gap);
                            ViewRay ray;
                            ray.fragments.push_back(plain_fragment(z, random.uniform(0.05f, 0.95f), 0));
                            ray.fragments.push_back(plain_fragment(z + gap, random.uniform(0.05f, 0.95f), 1));
                            return ray;
                        })});
    }
}

void add_positions(std::vector<Condition>& rows) {
    rows.push_back({"ties", "ties", "depths",
                    "Six fragments at only two or three depths, so several share a depth.", 6,
                    of_ray([](RandomNumbers& random, const Technique&) {
                        ViewRay ray = random_ray(random, 6);
                        const int depths = random.whole(2, 3);
                        for (std::size_t i = 0; i < 6; ++i)
                            ray.fragments[i].depth = ray.fragments[i].view_depth =
                                ray.fragments[i % static_cast<std::size_t>(depths)].depth;
                        return ray;
                    })});
    rows.push_back({"ends", "±1", "depths", "One fragment at each end of the depth range and one between.", 3,
                    of_ray([](RandomNumbers& random, const Technique&) {
                        ViewRay ray = random_ray(random, 3);
                        ray.fragments[0].depth = ray.fragments[0].view_depth = -1;
                        ray.fragments[1].depth = ray.fragments[1].view_depth = 1;
                        return ray;
                    })});
}

void add_opacities(std::vector<Condition>& rows) {
    for (const auto& [id, opacity] : {std::pair("opacity-1/255", 1.0f / 255), std::pair("opacity-.5", 0.5f),
                                      std::pair("opacity-.999", 0.999f), std::pair("opacity-.9999", 0.9999f)})
        rows.push_back({id, std::string(id).substr(8), "opacity",
                        fmt::format("Four fragments of opacity {:.4g} at random depths.", opacity), 4,
                        of_ray([share = opacity](RandomNumbers& random, const Technique&) {
                            return random_ray(random, 4, share, share);
                        })});
}

void add_overdraw(std::vector<Condition>& rows) {
    for (const int count : {10, 100, 1000, 10'000})
        rows.push_back(
            {fmt::format("overdraw-{}", count), fmt::format("{}", count), "overdraw",
             fmt::format("{} thin fragments at random depths, submitted in random order.", count), count,
             of_ray([count](RandomNumbers& random, const Technique&) { return thin_ray(random, count); })});
}

void add_layers(std::vector<Condition>& rows) {
    for (const int count : {10, 100, 1000})
        rows.push_back(
            {fmt::format("layers-{}", count), fmt::format("{}", count), "in 2 layers",
             fmt::format(
                 "{} thin fragments in two layers, each as thick as 1 % of the depth range: nearly two surfaces.",
                 count),
             count, of_ray([count](RandomNumbers& random, const Technique&) {
                 return layered_ray(random, count);
             })});
}

// Surfaces that are spread evenly over the logarithm of view depth, as in a landscape.
ViewRay landscape(RandomNumbers& random, float factor, bool logarithmic) {
    ViewRay ray = random_ray(random, 5);
    if (logarithmic) ray.warp = {DepthWarp::Kind::logarithmic, 1.0f, factor};
    for (Fragment& fragment : ray.fragments) {
        const float view_depth = std::pow(factor, random.uniform(0, 1));
        fragment.view_depth = logarithmic ? view_depth : 2 * (view_depth - 1) / (factor - 1) - 1;
        fragment.depth = logarithmic ? to_depth(view_depth, ray.warp) : fragment.view_depth;
    }
    return ray;
}

void add_ranges(std::vector<Condition>& rows) {
    for (const bool logarithmic : {true, false})
        for (int exponent = 1; exponent <= 6; ++exponent) {
            const float factor = std::pow(10.0f, static_cast<float>(exponent));
            rows.push_back(
                {fmt::format("{}-1e{}", logarithmic ? "log" : "linear", exponent),
                 fmt::format("1e{}", exponent), logarithmic ? "depth range, warped" : "depth range, linear",
                 fmt::format("Five surfaces between the view depths 1 and {:g}, {} logarithmic warp.", factor,
                             logarithmic ? "with the" : "without the"),
                 5, of_ray([factor, logarithmic](RandomNumbers& random, const Technique&) {
                     return landscape(random, factor, logarithmic);
                 })});
        }
}

void add_wrapping_zones(std::vector<Condition>& rows) {
    for (const float theta : {0.0f, 0.1f, 0.314159f, 1.0f})
        rows.push_back(
            {fmt::format("theta-{:.2g}", theta), fmt::format("{:.2g}", theta), "θ, fragments beside the zone",
             fmt::format("Four fragments within 5 % of the ends of the depth range, θ = {:.2g}.", theta), 4,
             [theta](RandomNumbers& random, const Technique&, const ParameterValues& base) {
                 StressCase result{random_ray(random, 4), base};
                 for (std::size_t i = 0; i < 4; ++i) {
                     const float near = random.uniform(0.95f, 1.0f);
                     Fragment& fragment = result.ray.fragments[i];
                     fragment.depth = fragment.view_depth = i % 2 == 0 ? near : -near;
                 }
                 result.values.set(ParameterId::theta, theta);
                 return result;
             }});
}

void add_biases(std::vector<Condition>& rows) {
    for (const float factor : {0.0f, 0.001f, 0.01f, 0.1f, 1.0f, 10.0f, 100.0f})
        rows.push_back(
            {fmt::format("alpha-{:g}", factor), fmt::format("{:g}", factor), "α times Table 1",
             fmt::format("Two to five fragments with {:g} times the moment bias of Table 1.", factor), 4,
             [factor](RandomNumbers& random, const Technique& technique, const ParameterValues& base) {
                 StressCase result{random_ray(random, random.whole(2, 5)), base};
                 const float most = parameter(ParameterId::alpha).maximum;
                 result.values.set(ParameterId::alpha,
                                   std::min(factor * technique.moments().recommended_bias, most));
                 return result;
             }});
}

std::vector<Condition> make_rows() {
    std::vector<Condition> rows;
    add_counts(rows);
    add_gaps(rows);
    add_positions(rows);
    add_opacities(rows);
    add_overdraw(rows);
    add_layers(rows);
    add_ranges(rows);
    add_wrapping_zones(rows);
    add_biases(rows);
    return rows;
}

}  // namespace

std::span<const Condition> conditions() {
    static const std::vector<Condition> rows = make_rows();
    return rows;
}

const Condition& require_condition(std::string_view id) {
    const auto rows = conditions();
    const auto row = std::ranges::find(rows, id, &Condition::id);
    if (row != rows.end()) return *row;
    std::string ids;
    for (const Condition& condition : rows) ids += fmt::format("{}{}", ids.empty() ? "" : ", ", condition.id);
    throw Error(fmt::format("There is no condition '{}'; use one of {}.", id, ids));
}

}  // namespace momentscope
