#include "core/inspect/sharp_bounds.hpp"

#include <ClpSimplex.hpp>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/inspect/curve.hpp"

namespace momentscope {

namespace {

constexpr int GRID = 2049;          // depths at which masses may lie, beside those of the fragments
constexpr int FIRST_STEP = 32;      // every so many of them are there from the beginning
constexpr std::size_t MANY = 500;   // more fragments are moved to the nearest point of the grid
constexpr double TOLERANCE = 1e-9;  // of moments in [-1, 1]; CLP's own 1e-7 would act like a bias
constexpr double PRICE = 1e-7;      // by how much a mass at another depth must improve the bound to be tried
constexpr int MOST_ROUNDS = 20;
constexpr int MOST_PIVOTS = 500;  // tens are usual; CLP may cycle where moments leave almost no freedom
constexpr double APART = 1e-5;    // masses that are closer are one: their columns would be the same

double grid_depth(int k) {
    return -1 + 2.0 * k / (GRID - 1);
}

bool is_new(const std::vector<double>& depths, double depth) {
    return std::ranges::none_of(depths, [&](double other) { return std::abs(other - depth) < APART; });
}

// The moment-generating function at a depth. On the line T_j(z) for any basis: the same constraints as z^j,
// better conditioned.
Eigen::VectorXd moments_at(double depth, const Technique& technique, double theta) {
    const int count = technique.moment_count;
    if (technique.on_circle()) {
        Eigen::VectorXd moments(2 * count + 1);
        const double angle = (std::numbers::pi - 0.5 * theta) * (depth + 1);
        moments[0] = 1;
        for (int j = 1; j <= count; ++j) {
            moments[2 * j - 1] = std::cos(j * angle);
            moments[2 * j] = std::sin(j * angle);
        }
        return moments;
    }
    Eigen::VectorXd moments(count + 1);
    const double angle = std::acos(std::clamp(depth, -1.0, 1.0));
    for (int j = 0; j <= count; ++j) moments[j] = std::cos(j * angle);
    return moments;
}

/// The least mass at some depths, all masses together having the ray's moments. Masses are tried where the
/// dual solution says that they would help, which finds the best of a grid without a variable for each of its
/// points.
class MassProgram {
public:
    MassProgram(const ViewRay& ray, const Technique& technique, double theta)
        : technique_(technique), theta_(theta), grid_(GRID, moments_at(0, technique, theta).size()) {
        for (int k = 0; k < GRID; ++k) grid_.row(k) = moments_at(grid_depth(k), technique, theta);
        Eigen::VectorXd of_ray = Eigen::VectorXd::Zero(grid_.cols());
        const bool many = ray.fragments.size() > MANY;
        std::vector<double> own_depths;
        for (const Fragment& fragment : ray.fragments) {
            const double own = fragment.depth;
            const double depth =
                many ? grid_depth(static_cast<int>(std::lround(0.5 * (own + 1) * (GRID - 1)))) : own;
            const double absorbance = fragment_absorbance(fragment.opacity);
            of_ray += absorbance * moments_at(depth, technique, theta);
            total_ += absorbance;
            own_depths.push_back(depth);
        }
        if (total_ > 0) of_ray /= total_;
        solver_.setLogLevel(0);
        solver_.scaling(0);  // it magnifies the tolerance of small masses until truths are infeasible
        solver_.resize(static_cast<int>(of_ray.size()), 0);
        for (int i = 0; i < static_cast<int>(of_ray.size()); ++i)
            solver_.setRowBounds(i, of_ray[i], of_ray[i]);
        solver_.setPrimalTolerance(TOLERANCE);
        solver_.setDualTolerance(TOLERANCE);
        solver_.setMaximumIterations(MOST_PIVOTS);
        for (int k = 0; k < GRID; k += FIRST_STEP) add(grid_depth(k));
        for (const double depth : own_depths)  // each, or moments would have no solution
            if (std::ranges::find(depths_, depth) == depths_.end()) add(depth);
    }

    double total_absorbance() const { return total_; }

    /// min of the sum of cost(depth) * mass, the masses summing to 1. Starts where the last query ended:
    /// neighbouring ones differ in few pivots. `at` is a depth where cost jumps. nullopt if CLP fails.
    template <typename Cost>
    std::optional<double> least(double at, const Cost& cost) {
        if (is_new(depths_, at)) add(at);
        for (std::size_t k = 0; k < depths_.size(); ++k)
            solver_.setObjectiveCoefficient(static_cast<int>(k), cost(depths_[k]));
        for (int round = 0; round < MOST_ROUNDS; ++round) {
            if (!solve()) return std::nullopt;
            if (!add_what_helps(cost)) break;
        }
        return solver_.objectiveValue();
    }

private:
    // Where moments leave almost no freedom, the last basis may lead nowhere; no basis at all may then do.
    bool solve() {
        solver_.primal();
        if (solver_.isProvenOptimal()) return true;
        solver_.allSlackBasis(true);
        solver_.primal();
        if (solver_.isProvenOptimal()) return true;
        solver_.allSlackBasis(true);
        solver_.dual();
        return solver_.isProvenOptimal();
    }

    void add(double depth, double cost = 0) {
        const Eigen::VectorXd column = moments_at(depth, technique_, theta_);
        std::vector<int> rows(static_cast<std::size_t>(column.size()));
        std::iota(rows.begin(), rows.end(), 0);
        solver_.addColumn(static_cast<int>(rows.size()), rows.data(), column.data(), 0,
                          std::numeric_limits<double>::max(), cost);
        depths_.push_back(depth);
    }

    // Adds the grid's points whose reduced cost is negative and least among their neighbours.
    template <typename Cost>
    bool add_what_helps(const Cost& cost) {
        const Eigen::Map<const Eigen::VectorXd> dual(solver_.dualRowSolution(), grid_.cols());
        Eigen::VectorXd reduced = -(grid_ * dual);
        for (int k = 0; k < GRID; ++k) reduced[k] += cost(grid_depth(k));
        bool added = false;
        for (int k = 0; k < GRID; ++k) {
            const bool least =
                (k == 0 || reduced[k] <= reduced[k - 1]) && (k == GRID - 1 || reduced[k] < reduced[k + 1]);
            if (!least || reduced[k] > -PRICE) continue;
            add(grid_depth(k), cost(grid_depth(k)));
            added = true;
        }
        return added;
    }

    const Technique& technique_;
    double theta_;
    Eigen::MatrixXd grid_;        // a row of moments for each of its depths
    double total_ = 0;            // b0
    std::vector<double> depths_;  // of the masses tried so far; a column of the program each
    ClpSimplex solver_;
};

// m/2 surfaces, or on the circle m, are the only distribution with their moments (Section 4.1).
bool determined(const ViewRay& ray, const Technique& technique) {
    const auto most =
        static_cast<std::size_t>(technique.on_circle() ? technique.moment_count : technique.moment_count / 2);
    std::vector<double> surfaces;
    for (const Fragment& fragment : ray.fragments) {
        const double depth = fragment.depth;
        if (fragment.opacity > 0 && is_new(surfaces, depth)) surfaces.push_back(depth);
        if (surfaces.size() > most) return false;
    }
    return true;
}

SharpBounds of_truth(const ViewRay& ray, std::span<const float> depths) {
    SharpBounds bounds;
    bounds.depth.assign(depths.begin(), depths.end());
    const std::vector<double> in_front = true_absorbance(ray, depths);
    bounds.lower.assign(in_front.begin(), in_front.end());
    bounds.upper = bounds.lower;
    for (std::size_t i = 0; i < depths.size(); ++i)
        for (const Fragment& fragment : ray.fragments)
            bounds.upper[i] += fragment.depth == depths[i] ? fragment_absorbance(fragment.opacity) : 0;
    return bounds;
}

}  // namespace

std::optional<SharpBounds> sharp_bounds(const ViewRay& ray, const Technique& technique,
                                        const ResolvedParameters& parameters, std::span<const float> depths,
                                        std::stop_token stop) {
    SharpBounds bounds;
    if (technique.kernel == nullptr || !(total_absorbance(ray) > 0)) return bounds;
    if (determined(ray, technique)) return of_truth(ray, depths);
    bounds.depth.assign(depths.begin(), depths.end());
    MassProgram program(ray, technique, parameters.theta);
    const auto bound = [&](std::vector<float>& to, double sign, const auto& counts) {
        for (const float depth : depths) {
            if (stop.stop_requested()) return false;
            const double at = depth;
            const auto share = program.least(at, [&](double x) { return counts(x, at) ? sign : 0.0; });
            if (!share) return false;
            to.push_back(
                static_cast<float>(program.total_absorbance() * std::clamp(sign * *share, 0.0, 1.0)));
        }
        return true;
    };
    if (!bound(bounds.lower, 1, std::less<>()) || !bound(bounds.upper, -1, std::less_equal<>()))
        return std::nullopt;
    return bounds;
}

}  // namespace momentscope
