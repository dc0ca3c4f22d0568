#include "core/inspect/circle_bounds.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/inspect/linear_program.hpp"
#include "core/support/parallel_for.hpp"

namespace momentscope {

namespace {

constexpr int GRID = 2049;      // possible depths of masses, in addition to those of the fragments
constexpr int FIRST_STEP = 32;  // a program begins with every 32nd of these depths
constexpr std::size_t MAX_EXACT_FRAGMENTS = 500;  // if there are more, they are moved to the grid
constexpr double TOLERANCE = 1e-9;        // of moments in [-1, 1]; the default of CLP, 1e-7, acts like a bias
constexpr double MIN_IMPROVEMENT = 1e-7;  // a depth is tried if a mass there improves the bound by this much
constexpr int MAX_ROUNDS = 20;
constexpr int MAX_PIVOTS = 500;  // tens are usual; CLP may cycle if moments almost determine the truth
constexpr double MIN_SEPARATION = 1e-5;  // closer masses count as one: their columns would be equal
constexpr std::size_t QUERIES = 16;      // per program, because it grows with each query

double grid_depth(int k) {
    return -1 + 2.0 * k / (GRID - 1);
}

// The moments of a mass of 1 at a depth.
Eigen::VectorXd moments_at(double depth, int count, double theta) {
    Eigen::VectorXd moments(2 * count + 1);
    const double angle = (std::numbers::pi - 0.5 * theta) * (depth + 1);
    moments[0] = 1;
    for (int j = 1; j <= count; ++j) {
        moments[2 * j - 1] = std::cos(j * angle);
        moments[2 * j] = std::sin(j * angle);
    }
    return moments;
}

std::span<const double> numbers_of(const Eigen::VectorXd& vector) {
    return {vector.data(), static_cast<std::size_t>(vector.size())};
}

/// A program with one equation for each moment.
LinearProgram program_of(const Eigen::VectorXd& moments) {
    LinearProgram program(numbers_of(moments), TOLERANCE);
    program.set_max_pivots(MAX_PIVOTS);
    return program;
}

/// What all linear programs of a ray have in common.
struct Candidates {
    int count;
    double theta;
    std::vector<double> depths;   // possible depths of masses, ascending: grid and fragments
    Eigen::MatrixXd moments;      // one row for each of these depths
    std::vector<double> support;  // some depths at which masses have the moments of the ray
    Eigen::VectorXd of_ray;       // moments of the ray, divided by b0
    double total = 0;             // b0
};

// Masses at a few of the depths of the fragments have the moments of all fragments (Carathéodory). Returns
// these depths, or all if CLP finds no solution.
std::vector<double> support_of(const std::vector<double>& own, const Candidates& candidates) {
    LinearProgram program = program_of(candidates.of_ray);
    for (const double depth : own)
        program.add_column(numbers_of(moments_at(depth, candidates.count, candidates.theta)), 0);
    if (!program.primal()) return own;
    std::vector<double> support;
    for (std::size_t k = 0; k < own.size(); ++k)
        if (program.variables()[k] > 0) support.push_back(own[k]);
    return support;
}

Candidates candidates_of(const ViewRay& ray, int count, double theta) {
    Candidates result{count, theta, {}, {}, {}, Eigen::VectorXd::Zero(2 * count + 1)};
    std::vector<double> own;
    const bool many = ray.fragments.size() > MAX_EXACT_FRAGMENTS;
    for (const Fragment& fragment : ray.fragments) {
        const double exactly = fragment.depth;
        const double depth =
            many ? grid_depth(static_cast<int>(std::lround(0.5 * (exactly + 1) * (GRID - 1)))) : exactly;
        const double absorbance = fragment_absorbance(fragment.opacity);
        result.of_ray += absorbance * moments_at(depth, count, theta);
        result.total += absorbance;
        own.push_back(depth);
    }
    if (result.total > 0) result.of_ray /= result.total;
    std::ranges::sort(own);
    own.erase(std::unique(own.begin(), own.end()), own.end());
    for (int k = 0; k < GRID; ++k) result.depths.push_back(grid_depth(k));
    result.depths.insert(result.depths.end(), own.begin(), own.end());
    std::ranges::sort(result.depths);
    result.depths.erase(std::unique(result.depths.begin(), result.depths.end()), result.depths.end());
    result.moments.resize(static_cast<Eigen::Index>(result.depths.size()), 2 * count + 1);
    for (std::size_t k = 0; k < result.depths.size(); ++k)
        result.moments.row(static_cast<Eigen::Index>(k)) = moments_at(result.depths[k], count, theta);
    result.support = support_of(own, result);
    return result;
}

/// Finds the least mass at some depths among all distributions with the moments of the ray. Only some
/// candidate depths are variables of the program. A depth is added if the dual solution says that a mass
/// there would help. This finds the best of all candidates.
class MassProgram {
public:
    explicit MassProgram(const Candidates& candidates)
        : candidates_(candidates), program_(program_of(candidates.of_ray)) {
        for (int k = 0; k < GRID; k += FIRST_STEP) add(grid_depth(k));
        for (const double depth : candidates.support)  // all, or the program would have no solution
            if (std::ranges::find(depths_, depth) == depths_.end()) add(depth);
    }

    /// The minimum of the sum of cost(depth) * mass, over masses with sum 1. Starts where the last query
    /// ended, because neighbouring queries differ in few pivots. `at`: a depth where the cost jumps. nullopt
    /// if CLP fails.
    template <typename Cost>
    std::optional<double> least(double at, const Cost& cost) {
        if (is_new(at)) add(at);
        std::vector<double> costs;
        for (const double depth : depths_) costs.push_back(cost(depth));
        program_.set_costs(costs);
        for (int round = 0; round < MAX_ROUNDS; ++round) {
            if (!solve()) return std::nullopt;
            if (!add_what_helps(cost)) break;
        }
        return program_.cost();
    }

private:
    // If the moments almost determine the truth, CLP may not find a way from the last basis. It may still
    // find one without a basis.
    bool solve() {
        if (program_.primal()) return true;
        program_.forget_basis();
        if (program_.primal()) return true;
        program_.forget_basis();
        return program_.dual();
    }

    bool is_new(double depth) const {
        return std::ranges::none_of(depths_,
                                    [&](double other) { return std::abs(other - depth) < MIN_SEPARATION; });
    }

    void add(double depth, double cost = 0) {
        program_.add_column(numbers_of(moments_at(depth, candidates_.count, candidates_.theta)), cost);
        depths_.push_back(depth);
    }

    // Adds those candidates whose reduced cost is negative and less than that of their neighbours.
    template <typename Cost>
    bool add_what_helps(const Cost& cost) {
        const Eigen::Map<const Eigen::VectorXd> dual(program_.duals().data(), candidates_.moments.cols());
        const std::vector<double>& depths = candidates_.depths;
        const Eigen::VectorXd value = candidates_.moments * dual;
        const auto reduced = [&](std::size_t k) {
            return cost(depths[k]) - value[static_cast<Eigen::Index>(k)];
        };
        bool added = false;
        for (std::size_t k = 0; k < depths.size(); ++k) {
            const double here = reduced(k);
            if (here > -MIN_IMPROVEMENT) continue;
            const bool least =
                (k == 0 || here <= reduced(k - 1)) && (k + 1 == depths.size() || here < reduced(k + 1));
            if (!least) continue;
            add(depths[k], cost(depths[k]));
            added = true;
        }
        return added;
    }

    const Candidates& candidates_;
    std::vector<double> depths_;  // of the masses tried so far; each is a column of the program
    LinearProgram program_;
};

enum class Bound { lower, upper };

std::optional<std::vector<float>> bounds_of(Bound bound, const Candidates& candidates,
                                            std::span<const float> depths, const std::stop_token& stop) {
    const double sign = bound == Bound::lower ? 1 : -1;
    std::vector<float> bounds;
    std::optional<MassProgram> program;
    for (const float depth : depths) {
        if (stop.stop_requested()) return std::nullopt;
        if (bounds.size() % QUERIES == 0) program.emplace(candidates);
        const double at = depth;
        const auto share = program->least(at, [&](double x) {
            const bool counts = bound == Bound::lower ? x < at : x <= at;
            return counts ? sign : 0.0;
        });
        if (!share) return std::nullopt;
        bounds.push_back(static_cast<float>(candidates.total * std::clamp(sign * *share, 0.0, 1.0)));
    }
    return bounds;
}

}  // namespace

std::optional<SharpBounds> circle_bounds(const ViewRay& ray, int count, double theta,
                                         std::span<const float> depths, const std::stop_token& stop) {
    const Candidates candidates = candidates_of(ray, count, theta);
    std::optional<std::vector<float>> lower, upper;
    parallel_for(2, [&](std::size_t i) {
        (i == 0 ? lower : upper) = bounds_of(i == 0 ? Bound::lower : Bound::upper, candidates, depths, stop);
    });
    if (!lower || !upper) return std::nullopt;
    return SharpBounds{{depths.begin(), depths.end()}, std::move(*lower), std::move(*upper)};
}

}  // namespace momentscope
