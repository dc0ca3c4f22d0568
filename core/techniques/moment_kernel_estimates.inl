// moment_kernel_estimates.inl -- the other functions of a MomentKernel, which are compiled once: sums, steps,
// and what is known of fragments beyond the published estimate. Include it after moment_kernel_functions.inl.
MomentVector from_shared(const g::Moments& moments) {
    MomentVector vector;
    vector.b0 = moments.b0;
    std::copy_n(moments.b, MOMENT_FLOATS, vector.b.begin());
    return vector;
}

g::Ends ends_of(const MomentVector& vector) {
    return g::make_ends(vector.near_step, vector.far_step);
}

std::array<float, MAX_BASIS_FLOATS> stored_basis(float parameter) {
    static_assert(BASIS_FLOATS <= MAX_BASIS_FLOATS);
    std::array<float, MAX_BASIS_FLOATS> result{};
    const g::StoredBasis stored = g::packed_basis(g::make_basis(parameter));
    std::copy_n(stored.x, BASIS_FLOATS, result.begin());
    return result;
}

float moment_depth(const MomentVector& stored, float depth, const ReconstructionSettings& settings) {
    return settings.interval == MomentInterval::pixel ? g::depth_in_interval(depth, ends_of(stored)) : depth;
}

void add_fragment(MomentVector& stored, float depth, float absorbance,
                  const ReconstructionSettings& settings) {
    const g::Moments fragment =
        g::fragment_moments(moment_depth(stored, depth, settings), absorbance, basis_of(settings));
    const MomentVector sum = from_shared(g::with_fragment(to_shared(stored), fragment));
    stored.b0 = sum.b0;
    stored.b = sum.b;
}

void add_ends(MomentVector& stored, float depth, float absorbance) {
    const g::Ends ends = g::with_ends(ends_of(stored), g::fragment_ends(depth, absorbance));
    stored.near_step = ends.near;
    stored.far_step = ends.far;
}

MomentVector moments_of(const MomentVector& stored) {
    return from_shared(unpacked(stored));
}

/// A pixel, factored for many queries.
struct FactoredPixel {
    g::Factor whole;
    g::Factor inner;  // only for sharp bounds
    g::Basis basis;
    g::Ends ends;
    float b0;
    bool sharp;
};

#ifdef SHARP_BOUNDS
constexpr int SHARP_INNER_FLOATS = INNER_FLOATS;

g::Factor factored_inner(const g::BiasedMoments& biased) {
    return g::factor_inner(biased);
}

g::QueryMasses sharp_masses(const FactoredPixel& pixel, float depth) {
    return g::sharp_masses(pixel.whole, pixel.inner, pixel.basis, depth);
}
#else
constexpr int SHARP_INNER_FLOATS = 0;

g::Factor factored_inner(const g::BiasedMoments&) {
    return {};
}

g::QueryMasses sharp_masses(const FactoredPixel&, float) {
    return {};
}
#endif

FactoredPixel factored_pixel(const MomentVector& vector, const ReconstructionSettings& settings) {
    FactoredPixel pixel;
    const g::BiasedMoments biased = g::biased_moments(unpacked(vector), settings.bias);
    pixel.whole = g::factor_moments(biased);
    pixel.sharp = SHARP_INNER_FLOATS > 0 && settings.interval == MomentInterval::pixel;
    if (pixel.sharp) pixel.inner = factored_inner(biased);
    pixel.basis = basis_of(settings);
    pixel.ends = ends_of(vector);
    pixel.b0 = vector.b0;
    return pixel;
}

g::QueryMasses masses_at(const FactoredPixel& pixel, float moment_depth) {
    if (pixel.sharp) return sharp_masses(pixel, moment_depth);
    return g::query_masses(g::reconstruct(pixel.whole, pixel.basis, moment_depth));
}

g::FragmentEstimate estimate_of(const FactoredPixel& pixel, const MomentVector& vector,
                                const ReconstructionSettings& settings, float depth, float own, int end) {
    const g::QueryMasses masses = g::masses_at_end(masses_at(pixel, moment_depth(vector, depth, settings)),
                                                   end, settings.interval == MomentInterval::pixel);
    return g::estimate_at(masses, pixel.b0, own, end, static_cast<int>(settings.estimate),
                          settings.overestimation);
}

// Curves that are not published ones. They are not as fast.
void evaluate_estimates(const MomentVector& vector, const ReconstructionSettings& settings,
                        std::span<const float> depths, const AbsorbanceCurves& curves) {
    const FactoredPixel pixel = factored_pixel(vector, settings);
    const bool bounded = !g::ends_unknown(pixel.ends);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const float depth = depths[i];
        if (bounded && (depth < g::near_depth(pixel.ends) || depth > g::far_depth(pixel.ends))) {
            const float all = depth < g::near_depth(pixel.ends) ? 0.0f : pixel.b0;
            curves.reconstructed[i] = curves.beta0[i] = curves.beta1[i] = all;
            continue;
        }
        const g::FragmentEstimate at = estimate_of(pixel, vector, settings, depth, 0.0f, g::AT_NO_END);
        curves.reconstructed[i] =
            g::estimated_absorbance(at, static_cast<int>(settings.estimate), settings.overestimation);
        curves.beta0[i] = at.lower;
        curves.beta1[i] = at.upper;
    }
}

FragmentEstimate from_shared(const g::FragmentEstimate& estimate) {
    return {estimate.lower, estimate.upper, estimate.transmittance, estimate.spread};
}

void estimates(const MomentVector& vector, const ReconstructionSettings& settings,
               std::span<const float> depths, std::span<const float> own,
               std::span<FragmentEstimate> results) {
    const g::Moments moments = unpacked(vector);
    if (g::is_empty(moments)) {
        std::ranges::fill(results, FragmentEstimate());
        return;
    }
    if (settings.solver == Solver::textbook) {
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const float fraction = textbook(moments, settings, settings.overestimation, depths[i]);
            results[i] = from_shared(g::estimate_at(g::make_masses(fraction, 0.0f), vector.b0, own[i],
                                                    g::AT_NO_END, g::ESTIMATE_BETA, 0.0f));
        }
        return;
    }
    const FactoredPixel pixel = factored_pixel(vector, settings);
    for (std::size_t i = 0; i < depths.size(); ++i)
        results[i] = from_shared(
            estimate_of(pixel, vector, settings, depths[i], own[i], g::end_at(depths[i], pixel.ends)));
}

float fraction_of_pixel(const MomentVector& vector, const ReconstructionSettings& settings, float depth) {
    const FactoredPixel pixel = factored_pixel(vector, settings);
    const g::QueryMasses masses = masses_at(pixel, moment_depth(vector, depth, settings));
    return masses.in_front + settings.overestimation * masses.at_query;
}

#ifdef SHARP_BOUNDS
// Replaces the representation by that with both ends as nodes, if the first has nodes beyond an end.
void add_end_representation(ReconstructionSteps& result, const g::BiasedMoments& biased,
                            const g::Factor& factor, const g::Basis& basis) {
    const g::Kernel kernel = g::kernel_polynomial(g::query_at(result.depth, factor, basis), factor);
    if (g::all_nodes_inside(kernel, result.depth)) return;
    const g::EndRepresentation ends =
        g::representation_with_ends(g::factor_inner(biased), basis, factor.a[0], result.depth);
    result.with_ends = true;
    result.near_weight = ends.near;
    result.far_weight = ends.far;
    result.query_weight = ends.query_weight;
    result.in_front = ends.in_front;
    result.t = {};
    result.weight = {};
    result.value = {};
    for (std::size_t l = 0; l + 1 < ROOT_COUNT; ++l) {
        result.t[l] = ends.t[l];
        result.weight[l] = ends.weight[l];
        result.value[l] = ends.t[l] < 0 ? 1.0f : 0.0f;
    }
}
#else
void add_end_representation(ReconstructionSteps&, const g::BiasedMoments&, const g::Factor&,
                            const g::Basis&) {}
#endif

ReconstructionSteps steps(const MomentVector& vector, const ReconstructionSettings& settings, float depth) {
    ReconstructionSteps result;
    if (g::is_empty(to_shared(vector))) return result;
    result.depth = moment_depth(vector, depth, settings);
    const g::Basis basis = basis_of(settings);
    const g::BiasedMoments biased = g::biased_moments(unpacked(vector), settings.bias);
    const g::Factor factor = g::factor_moments(biased);
    const g::Kernel kernel = g::kernel_polynomial(g::query_at(result.depth, factor, basis), factor);
    const g::Reconstruction at_depth = g::reconstruct(factor, basis, result.depth);
    result.biased.b0 = 1;
    for (std::size_t i = 0; i < MOMENT_FLOATS; ++i)
        result.biased.b[i] = (biased.b[i] + biased.bias_delta[i]) / biased.b0;
    for (std::size_t k = 0; k < ORDER; ++k) result.pivots[k] = 1.0f / factor.inverse_h[k];
    result.floored_pivots = factor.floored;
    result.query_weight = at_depth.query_weight;
    result.in_front = at_depth.in_front;
    result.kernel[0] = kernel.at_query;
    std::copy_n(kernel.in_t.e, ROOT_COUNT, result.kernel.begin() + 1);
    std::copy_n(at_depth.t, ROOT_COUNT, result.t.begin());
    std::copy_n(at_depth.weight, ROOT_COUNT, result.weight.begin());
    std::copy_n(at_depth.value, ROOT_COUNT, result.value.begin());
    if (settings.interval == MomentInterval::pixel) add_end_representation(result, biased, factor, basis);
    result.fraction = result.in_front + settings.overestimation * result.query_weight;
    result.absorbance = vector.b0 * g::number_in_unit_range(result.fraction);
    return result;
}

constexpr MomentKernel KERNEL = {.moment_floats = MOMENT_FLOATS,
                                 .node_count = ROOT_COUNT,
                                 .factor_floats = FACTOR_FLOATS,
                                 .inner_floats = SHARP_INNER_FLOATS,
                                 .bits = MOMENT_BITS,
                                 .has_textbook = HAS_TEXTBOOK,
                                 .basis = stored_basis,
                                 .add_fragment = add_fragment,
                                 .add_ends = add_ends,
                                 .moment_depth = moment_depth,
                                 .moments_of = moments_of,
                                 .evaluate = evaluate,
                                 .fraction = fraction,
                                 .fractions = fractions,
                                 .estimates = estimates,
                                 .steps = steps};
