#include "core/inspect/step_texts.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string_view>

namespace momentscope {

namespace {

std::string list(std::string_view format, const auto& values, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += fmt::format("{}{}", i == 0 ? "" : ", ", fmt::format(fmt::runtime(format), values[i]));
    return text;
}

std::string matrix_numbers(const char* name, const MomentMatrix& matrix) {
    const std::string condition = matrix.smallest_eigenvalue > 0
                                      ? fmt::format("{:.2e}", matrix.condition)
                                      : std::string("none: it is not positive definite");
    return fmt::format("{}: smallest eigenvalue {:.3e}, condition {}", name, matrix.smallest_eigenvalue,
                       condition);
}

std::size_t moment_floats(const Steps& steps) {
    return static_cast<std::size_t>(steps.technique->moment_kernel().moment_floats);
}

StepText normalise_text(const Steps& s) {
    return {"1  Normalise",
            fmt::format(
                "Divide what the pixel stores by its total absorbance b₀ = {:.6g}, so that it describes a "
                "distribution of mass 1 (Section 3.1).",
                s.stored.b0),
            fmt::format("b/b₀ = 1, {}", list("{:.6f}", s.normalised.b, moment_floats(s)))};
}

StepText bias_text(const Steps& s) {
    return {"2  Bias",
            fmt::format("Pull the moments a little, α = {:.2e}, towards those of a harmless distribution, "
                        "(1 − α) b + α b*, to make up for rounding (supplementary, Section 1).",
                        s.parameters.alpha),
            fmt::format("b = 1, {}", list("{:.6f}", s.biased.b, moment_floats(s)))};
}

StepText matrix_text(const Steps& s) {
    const bool circle = s.technique->on_circle();
    const bool chebyshev = s.technique->is_of(BasisFamily::chebyshev);
    const char* name = circle ? "Toeplitz matrix" : chebyshev ? "Gram matrix" : "Hankel matrix";
    const char* entry = circle ? "b_{i−j}" : chebyshev ? "(b_{i+j} + b_{|i−j|}) / 2" : "b_{i+j}";
    return {
        fmt::format("3  {}", name),
        fmt::format(
            "Entry i, j is {}. With fewer surfaces than rows, its smallest eigenvalue is zero except for rounding; "
            "bias keeps it above zero (Algorithm {}).",
            entry, circle ? 2 : 1),
        matrix_numbers("before bias", s.before) + "\n" + matrix_numbers("after bias", s.after)};
}

StepText factor_text(const Steps& s) {
    const std::string floors =
        s.floored_pivots > 0 ? fmt::format("; {} raised to the floor 6e-8", s.floored_pivots) : "";
    return {
        "4  Factor",
        "Cholesky's elimination gives the pivots h_k, which are the norms of the orthogonal polynomials p_k. The smaller "
        "the last pivot is, the better the moments determine where the surfaces are (docs/equations.md).",
        fmt::format("h = {}{}", list("{:.4e}", s.pivots, s.pivots.size()), floors)};
}

StepText kernel_text(const Steps& s) {
    const bool circle = s.technique->on_circle();
    const std::vector<float> below(s.kernel.begin() + 1, s.kernel.end());
    return {
        "5  Kernel polynomial",
        fmt::format(
            "K(z_f, z) = Σ p_k(z_f) p_k(z)/h_k, called q in Algorithm {}, as a polynomial in t = {}, which is "
            "infinite at the query itself.",
            circle ? 2 : 1, circle ? "cot((φ − φ_f)/2)" : "1/(z − z_f)"),
        fmt::format("1/w₀ = {:.6g}; coefficients below the leading 1: {}", s.kernel[0],
                    list("{:.5g}", below, below.size()))};
}

StepText roots_text(const Steps& s) {
    const bool circle = s.technique->on_circle();
    const std::string zone = fmt::format("; the wrapping zone lies beyond φ = 2π − θ = {:.4f}",
                                         2 * std::numbers::pi - static_cast<double>(s.parameters.theta));
    std::string roots;
    for (const StepNode& node : s.nodes)
        roots += fmt::format("{}t = {:<12.5g} z = {:<10.5g}{}", roots.empty() ? "" : "\n", node.t, node.depth,
                             circle ? fmt::format(" φ = {:.4f}", node.phase) : "");
    if (s.with_ends)
        return {
            "6  Roots",
            "A root of this polynomial lies beyond an end of the ray, where there can be no mass. So both ends become "
            "nodes. The others are the roots for the measure (1 − z²) dμ, which has no mass at the ends.",
            roots};
    return {"6  Roots",
            fmt::format("Its roots are the nodes, the places of the other masses of the canonical "
                        "representation{} (Algorithm {}).",
                        circle ? zone : "", circle ? 2 : 1),
            roots};
}

StepText weights_text(const Steps& s) {
    std::string weights = fmt::format("w₀ = {:.6f} at the query z_f = {:.5g}", s.query_weight, s.query);
    for (const StepNode& node : s.nodes)
        weights +=
            fmt::format("\nw = {:.6f} at z = {:<10.5g} v = {:.4f}", node.weight, node.depth, node.value);
    return {
        "7  Weights and values",
        s.technique->on_circle()
            ? "Each mass is 1/K at its node. v is 1 in front of the query, 0 behind, and a ramp of ψ in the "
              "wrapping zone (Equation 6)."
            : "Each mass is 1/K at its node. v is 1 in front of the query and 0 behind (Equation 4).",
        weights};
}

// How A follows from the bounds.
std::string rule_text(const Steps& s) {
    constexpr const char* AT_END =
        "The fragment lies in the step of the {} end and is taken to be alone there, so A = {}.";
    const std::string together =
        s.end == RayEnd::both ? "All fragments lie in one step, which moments cannot tell apart. " : "";
    if (s.end == RayEnd::near) return fmt::format(AT_END, "near", "L");
    if (s.end == RayEnd::far) return fmt::format(AT_END, "far", "U");
    switch (s.parameters.estimation.estimate) {
        case Estimate::expected:
            return together +
                   "Nothing says where, so T is the mean over all A between them, (e^−L − e^−U) / (U − L).";
        case Estimate::own_beta:
            break;
        case Estimate::beta:
            if (s.end == RayEnd::none)
                return fmt::format("As published, A = L + β w₀ b₀ with β = {:.3g}.", s.parameters.beta);
    }
    return together + fmt::format("A = L + β (U − L) with β = {:.3g}.", s.parameters.beta);
}

// The result of an estimate that is not the published one.
StepText bounds_text(const Steps& s) {
    const std::string own =
        s.own > 0 ? fmt::format(", without the fragment's own a = {:.6g}", s.own) : std::string();
    return {"8  Result",
            fmt::format("The absorbance in front lies between L, the masses in front, and U = L + w₀ b₀{} "
                        "(docs/less_error.md). {}",
                        own, rule_text(s)),
            fmt::format("w₀ b₀ = {:.6g}\nL = {:.6g}, U = {:.6g}\nT = {:.9g}\nA = −ln T = {:.9g}",
                        s.query_weight * s.stored.b0, s.lower, s.upper, s.transmittance, s.absorbance)};
}

StepText result_text(const Steps& s) {
    if (!s.parameters.is_published()) return bounds_text(s);
    return {
        "8  Result",
        fmt::format(
            "Add the masses in front and the share β = {:.3g} of the mass at the query. w₀ b₀ = {:.5g} is "
            "the gap between {}.",
            s.parameters.beta, s.query_weight * s.stored.b0,
            s.technique->has_bounds() ? "the bounds" : "β = 0 and β = 1"),
        fmt::format("Σ w v = {:.6f}, + β w₀ = {:.6f}\nA = b₀ × that = {:.9g}\nT = exp(−A) = {:.9g}",
                    s.in_front, s.fraction, s.absorbance, s.transmittance)};
}

}  // namespace

std::vector<StepText> step_texts(const Steps& s) {
    if (s.empty) return {};
    return {normalise_text(s), bias_text(s),  matrix_text(s),  factor_text(s),
            kernel_text(s),    roots_text(s), weights_text(s), result_text(s)};
}

std::string steps_to_text(const Steps& steps) {
    if (steps.technique != nullptr && steps.empty)
        return fmt::format("{}: nothing to reconstruct here.\n", steps.technique->id);
    std::string text = fmt::format("{}, query depth {:.6g}\n", steps.technique->id, steps.query);
    for (const StepText& step : step_texts(steps)) {
        text += fmt::format("\n{}\n    {}\n", step.title, step.sentence);
        std::string line;
        for (const char letter : step.numbers + "\n") {
            if (letter == '\n') {
                text += "        " + line + "\n";
                line.clear();
            } else {
                line += letter;
            }
        }
    }
    return text + "\n";
}

}  // namespace momentscope
