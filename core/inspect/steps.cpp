#include "core/inspect/steps.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/inspect/fragment_estimates.hpp"

namespace momentscope {

namespace {

// Entry E[u_i conj(u_j)] for the functions u_k of the basis.
std::complex<double> matrix_entry(const Technique& technique, const MomentVector& normalised, int i, int j) {
    const auto moment = [&](int k) {
        return k == 0 ? 1.0 : static_cast<double>(normalised.b[static_cast<std::size_t>(k - 1)]);
    };
    if (technique.is_of(BasisFamily::chebyshev)) return 0.5 * (moment(i + j) + moment(std::abs(i - j)));
    if (technique.is_of(BasisFamily::power)) return moment(i + j);
    if (i == j) return 1.0;
    const auto k = static_cast<std::size_t>(2 * (std::abs(i - j) - 1));
    const std::complex<double> b(static_cast<double>(normalised.b[k]),
                                 static_cast<double>(normalised.b[k + 1]));
    return i > j ? b : std::conj(b);
}

MomentMatrix matrix_of(const Technique& technique, const MomentVector& normalised) {
    const int order = technique.moment_kernel().node_count + 1;
    Eigen::MatrixXcd matrix(order, order);
    MomentMatrix result;
    result.order = static_cast<std::size_t>(order);
    for (int i = 0; i < order; ++i)
        for (int j = 0; j < order; ++j) {
            matrix(i, j) = matrix_entry(technique, normalised, i, j);
            result.entry.push_back({matrix(i, j).real(), matrix(i, j).imag()});
        }
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
    result.smallest_eigenvalue = values(0);
    result.condition = values(order - 1) / values(0);
    return result;
}

MomentVector normalised(const MomentVector& moments, int floats) {
    MomentVector result{1, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(floats); ++i)
        result.b[i] = moments.b[i] / moments.b0;
    return result;
}

// The estimate of a fragment at the query.
void add_fragment(Steps& steps, const Curve& curve, const Fragment& fragment) {
    ViewRay alone;
    alone.fragments = {fragment};
    constexpr std::size_t FIRST[] = {0};
    const FragmentEstimate estimate =
        fragment_estimates(alone, curve.moments, *curve.technique, curve.parameters, FIRST).front();
    steps.own = fragment_absorbance(fragment.opacity);
    steps.end = ray_end(fragment.depth, curve.moments);
    steps.lower = estimate.lower;
    steps.upper = estimate.upper;
    steps.transmittance = estimate.transmittance;
    const float t = estimate.transmittance;
    steps.absorbance = t > 0 ? 0 - std::log(t) : estimate.upper;  // no -0
}

}  // namespace

const Fragment* fragment_at(const ViewRay& ray, float depth) {
    const auto found = std::ranges::find(ray.fragments, depth, &Fragment::depth);
    return found == ray.fragments.end() ? nullptr : &*found;
}

Steps reconstruction_steps(const Curve& curve, float query, const Fragment* fragment) {
    Steps result;
    result.technique = curve.technique;
    result.parameters = curve.parameters;
    result.query = query;
    if (curve.technique == nullptr || !curve.technique->has_moments() || !(curve.moments.b0 > 0))
        return result;
    const MomentKernel& kernel = curve.technique->moment_kernel();
    const auto nodes = static_cast<std::size_t>(kernel.node_count);
    const ReconstructionSteps steps = kernel.steps(curve.moments, settings_of(curve.parameters), query);
    result.empty = false;
    result.stored = curve.moments;
    result.normalised = normalised(kernel.moments_of(curve.moments), kernel.moment_floats);
    result.biased = steps.biased;
    result.before = matrix_of(*curve.technique, result.normalised);
    result.after = matrix_of(*curve.technique, result.biased);
    result.pivots.assign(steps.pivots.begin(), steps.pivots.begin() + static_cast<std::ptrdiff_t>(nodes + 1));
    result.floored_pivots = steps.floored_pivots;
    result.kernel.assign(steps.kernel.begin(), steps.kernel.begin() + static_cast<std::ptrdiff_t>(nodes + 1));
    const double per_depth = std::numbers::pi - 0.5 * static_cast<double>(curve.parameters.theta);
    result.with_ends = steps.with_ends;
    for (std::size_t l = 0; l + (steps.with_ends ? 1 : 0) < nodes; ++l) {
        const float depth = node_depth(steps.t[l], steps.depth, curve);
        result.nodes.push_back({steps.t[l], depth, (static_cast<double>(depth) + 1) * per_depth,
                                steps.weight[l], steps.value[l]});
    }
    if (steps.with_ends) {
        result.nodes.push_back({-1 / (1 + steps.depth), scene_depth(-1, curve), 0, steps.near_weight, 1});
        result.nodes.push_back({1 / (1 - steps.depth), scene_depth(1, curve), 0, steps.far_weight, 0});
    }
    result.query_weight = steps.query_weight;
    result.in_front = steps.in_front;
    result.fraction = steps.fraction;
    result.absorbance = steps.absorbance;
    if (!curve.parameters.is_published())
        kernel.evaluate(curve.moments, settings_of(curve.parameters), {&query, 1},
                        {{&result.absorbance, 1}, {&result.lower, 1}, {&result.upper, 1}});
    result.transmittance = transmittance(result.absorbance);
    if (fragment != nullptr && !curve.parameters.is_published()) add_fragment(result, curve, *fragment);
    return result;
}

}  // namespace momentscope
