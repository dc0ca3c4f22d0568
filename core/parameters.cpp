#include "core/parameters.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/parse_number.hpp"

namespace momentscope {

namespace {

constexpr float PI = std::numbers::pi_v<float>;

// The names of the values of a choice, such as CHOICE_NAMES<Solver>.
template <typename Choice>
constexpr bool CHOICE_NAMES = false;
#define VALUE(enumerator, text) text
#define CHOICE(type, parameter, ...) \
    template <>                      \
    constexpr std::array CHOICE_NAMES<type> = {__VA_ARGS__};
#include "core/parameter_choices.def"
#undef CHOICE
#undef VALUE

// How transparent casters may be stored: moments in floats, which may be filtered; two sizes of Fourier
// series; the ground truth; or no such casters.
std::vector<const char*> shadow_techniques() {
    std::vector<const char*> ids;
#define MOMENT_TECHNIQUE(id, basis, count, bits, key, ...) \
    if (bits == 32) ids.push_back(key);
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
    ids.insert(ids.end(), {"fourier-7", "fourier-15", "deep", "none"});
    return ids;
}
const std::vector<const char*> SHADOW_TECHNIQUES = shadow_techniques();

constexpr std::array OPAQUE_SHADOWS = {
#define OPAQUE_SHADOW(id, file, count, bits, key, ...) key,
#include "core/shadow/opaque_shadows.def"
#undef OPAQUE_SHADOW
};
constexpr float HAMBURGER_16 = 3;  // index in OPAQUE_SHADOWS

const std::array<Parameter, PARAMETER_COUNT> ROWS = {{
    {ParameterId::beta, "beta", "β", "overestimation weight", "", 0.0f, 1.0f, 0.25f, Scale::linear,
     Stage::color,
     "How much of the mass at the query depth counts as in front of it. With power moments 0 gives the "
     "lower bound, where no surface occludes itself but all appear too visible, and 1 the upper bound; with "
     "trigonometric moments these are not bounds.",
     "Münstermann et al. 2018, Section 3.2"},
    {ParameterId::theta, "theta", "θ", "wrapping zone angle", "rad", 0.0f, PI, PI / 10.0f, Scale::linear,
     Stage::moments,
     "Trigonometric moments only: the arc of the circle that holds no depths, where the end of the depth "
     "range wraps to its start. Wider is smoother and less precise in depth. Below .05 it is .05: without a zone the two ends are one point.",
     "Münstermann et al. 2018, Section 5.2"},
    {ParameterId::alpha, "alpha", "α", "moment bias", "", 0.0f, 0.1f, std::nullopt, Scale::logarithmic,
     Stage::color,
     "How far the moments are pulled towards harmless ones before reconstruction, to make up for rounding. "
     "`auto` is what the bias preset says for the technique. Less is sharper until matrices become singular.",
     "Münstermann et al. 2018, supplementary, Section 1 and Table 1"},
    {ParameterId::preset, "preset", "α*", "bias preset", "", 0.0f, 1.0f, 0.0f, Scale::choice, Stage::color,
     "What `auto` means for the moment bias: the published values of the supplementary's Table 1, or the least "
     "that the robust solver was measured to survive, which is sharper.",
     "Münstermann et al. 2018, supplementary, Table 1; Momentscope 2026, docs/bias.md",
     CHOICE_NAMES<BiasPreset>},
    {ParameterId::solver, "solver", "q(z)", "solver", "", 0.0f, 1.0f, 0.0f, Scale::choice, Stage::color,
     "How moments are reconstructed: by this project's solver, which survives nearly singular matrices, or by "
     "Algorithms 1 and 2 as published, which show what bias is for.",
     "Münstermann et al. 2018, Algorithms 1 and 2; Momentscope 2026, docs/equations.md",
     CHOICE_NAMES<Solver>},
    {ParameterId::factorisation, "factorisation", "LDL*", "factorisation", "", 0.0f, 1.0f, 0.0f,
     Scale::choice, Stage::color,
     "Where the matrix of moments is biased and factored: once per pixel between the passes, for all of its fragments, or "
     "again for every fragment, as published. The results are the same; the first is faster and stores the factor.",
     "Momentscope 2026, docs/equations.md", CHOICE_NAMES<Factorisation>},
    {ParameterId::tolerance, "tolerance", "ε", "tolerance", "", 1.0e-4f, 1.0f, 0.05f, Scale::logarithmic,
     Stage::color,
     "How uncertain the transmittance to a fragment may be: how much wider its bounds may be with four moments than with "
     "eight before more than four are spent on it. At 1 four are always enough.",
     "Momentscope 2026, docs/adaptive.md"},
    {ParameterId::accumulation, "accumulation", "Σ", "accumulation", "", 0.0f, 1.0f, 0.0f, Scale::choice,
     Stage::moments,
     "How the first pass adds up moments in floats: by blending, or by reading and writing pixels in submission "
     "order, as 16-bit moments always need it. The sums are the same.",
     "Münstermann et al. 2018, supplementary, Section 3.2 and Table 3", CHOICE_NAMES<MomentAccumulation>},
    {ParameterId::renormalize, "renormalize", "Eq. 2", "renormalisation", "", 0.0f, 1.0f, 1.0f, Scale::toggle,
     Stage::composite,
     "1 scales the transparent colour so that all weights sum to the true coverage, 0 leaves the sum as it is.",
     "Münstermann et al. 2018, Section 3.4, Equation 2"},
    {ParameterId::weight, "weight", "w", "weight", "", 0.0f, 2.0f, 0.0f, Scale::choice, Stage::moments,
     "How weighted blending guesses what is seen of a fragment: from window depth and opacity, as the authors of the "
     "moment-based paper compared; from view depth in scene units (2013); or as the G3D engine does (2016).",
     "McGuire and Bavoil 2013, Equations 7 to 10; McGuire and Mara 2017", CHOICE_NAMES<WeightFunction>},
    {ParameterId::coefficients, "coefficients", "2K+1", "Fourier coefficients", "", 0.0f, 1.0f, 0.0f,
     Scale::choice, Stage::moments, "How many real coefficients a pixel keeps. More ring in finer waves.",
     "Jansen and Bavoil 2010", CHOICE_NAMES<FourierCoefficients>},
    {ParameterId::lanczos, "lanczos", "σ", "Lanczos damping", "", 0.0f, 1.0f, 0.0f, Scale::toggle,
     Stage::color, "1 damps high frequencies, which takes most of the ringing for less precision in depth.",
     "Lanczos 1956, Section 4.6"},
    {ParameterId::nodes, "nodes", "n", "nodes", "", 2.0f, 8.0f, 4.0f, Scale::whole, Stage::moments,
     "How many steps the transmittance of a pixel may have.", "Salvi, Montgomery and Lefohn 2011, Section 3"},
    {ParameterId::layers, "layers", "k", "layers", "", 1.0f, 6.0f, 4.0f, Scale::whole, Stage::moments,
     "How many fragments a pixel keeps apart.", "Salvi and Vaidyanathan 2014"},
    {ParameterId::layer_bits, "layer-bits", "bits", "bits per number", "", 0.0f, 2.0f, 0.0f, Scale::choice,
     Stage::moments,
     "How a layer is stored: colour in half floats, depth and transmittance in 16 bits; all but depth in 8 bits; or all "
     "in floats, which rounds nothing.",
     "Münstermann et al. 2018, supplementary, Table 3", CHOICE_NAMES<LayerBits>},
    {ParameterId::samples, "pixel-samples", "S", "samples", "", 1.0f, 64.0f, 8.0f, Scale::whole,
     Stage::moments, "How many samples a pixel has. Four times as many halve the noise.",
     "Enderton et al. 2010, Section 4"},
    {ParameterId::resolution, "resolution", "1/n", "moment resolution", "", 0.0f, 3.0f, 0.0f, Scale::choice,
     Stage::moments,
     "The resolution of the moments: that of the picture, or a half, a quarter or an eighth of it in each direction, "
     "which pixels read bilinearly. A pixel's function is then a mixture of its neighbours'.",
     "Sharpe 2018, Section 4.1", CHOICE_NAMES<MomentResolution>},
    {ParameterId::read_format, "read-format", "bits", "read format", "", 0.0f, 3.0f, 0.0f, Scale::choice,
     Stage::moments,
     "What moments are converted to before the second pass reads them: nothing, 16 bits each after the transform Θ_4, "
     "or non-linearly quantised moments of 64 or 32 bits, which cannot be read at low resolution.",
     "Sharpe 2018, Section 4.2; Peters and Klein 2015; Peters 2017", CHOICE_NAMES<ReadFormat>},
    {ParameterId::moment_passes, "moment-passes", "n", "moment passes", "", 0.0f, 2.0f, 0.0f, Scale::choice,
     Stage::moments,
     "One set of moments, or a second one that knows from the first what is seen of a fragment. The paper does not say how "
     "both are put together; these are two readings: the second set of opacities as they are seen, or of the visibility.",
     "Sharpe 2018, Section 4.4", CHOICE_NAMES<MomentSets>},
    {ParameterId::depth_range, "depth-range", "z'", "depth range of moments", "", 0.0f, 1.0f, 0.0f,
     Scale::choice, Stage::moments,
     "Moments of depth in [0, 1], as published, where the bias vector does not belong, or corrected to [-1, 1].",
     "Sharpe 2018, Section 3.3", CHOICE_NAMES<DepthRange>},
    {ParameterId::order, "order", "1, 2, ...", "order of submission", "", 0.0f, 2.0f, 0.0f, Scale::choice,
     Stage::moments,
     "The order in which objects and their triangles are drawn: as the scene has them, backwards, or shuffled. What "
     "changes with it depends on order.",
     "Münstermann et al. 2018, Section 2", CHOICE_NAMES<OrderKind>},
    {ParameterId::order_seed, "order-seed", "s", "seed of the shuffled order", "", 1.0f, 1000.0f, 1.0f,
     Scale::whole, Stage::moments, "Which of the shuffled orders.", "Momentscope 2026"},
    {ParameterId::opacity, "opacity", "α_l", "opacity of mesh files", "", 0.0f, 0.99f, 0.4f, Scale::linear,
     Stage::scene,
     "Opacity of every fragment of a mesh that was loaded from a file. Built-in scenes bring their own.",
     "Münstermann et al. 2018, Section 2"},
    {ParameterId::tone_map, "tone-map", "L_d", "tone map", "", 0.0f, 2.0f, 0.0f, Scale::choice,
     Stage::display,
     "How linear colours become those of the screen and of PNG files: as they are, cut at 1; by Reinhard's c / (1 + c), "
     "which never cuts; or by a curve like that of film. EXR files and everything measured stay linear.",
     "Reinhard et al. 2002, Equation 3; Narkowicz 2016", CHOICE_NAMES<ToneMap>},
    {ParameterId::shadows, "shadows", "V", "shadows", "", 0.0f, 1.0f, 0.0f, Scale::toggle, Stage::shading,
     "1 lets surfaces receive the shadows of others from a light of the scene, 0 lights everything from beside the camera. "
     "Opaque and transparent casters have a map each; what both let through is multiplied.",
     "Münstermann et al. 2018, Section 6"},
    {ParameterId::shadow_technique, "shadow-technique", "A_s", "transparent casters", "", 0.0f,
     static_cast<float>(SHADOW_TECHNIQUES.size() - 1), 1.0f, Scale::choice, Stage::shading,
     "How a texel of the light's map stores the absorbance of transparent casters: moments in floats, Fourier opacity "
     "mapping, or all fragments sorted, the slow ground truth; or `none`, so that only opaque casters count. Moments in 16 bits are not offered: they are stored divided by "
     "b_0, and division is not linear, so they cannot be filtered.",
     "Münstermann et al. 2018, Section 6; Jansen and Bavoil 2010; Lokovic and Veach 2000", SHADOW_TECHNIQUES},
    {ParameterId::shadow_beta, "shadow-beta", "β_s", "shadow overestimation", "", 0.0f, 1.0f, 0.0f,
     Scale::linear, Stage::shading,
     "What β is for the moments of the light. At 0 transparent surfaces do not shadow themselves, but light leaks; the paper's Fig. 9 has "
     "0.5.",
     "Münstermann et al. 2018, Section 7.2"},
    {ParameterId::opaque_shadow, "opaque-shadow", "F", "opaque casters", "", 0.0f,
     static_cast<float>(OPAQUE_SHADOWS.size() - 1), HAMBURGER_16, Scale::choice, Stage::shading,
     "How the light's map of opaque casters is stored and looked up.", "Peters and Klein 2015",
     OPAQUE_SHADOWS},
    {ParameterId::shadow_size, "shadow-size", "px", "shadow map size", "texels", 16.0f, 65536.0f, 1024.0f,
     Scale::whole, Stage::shading, "Texels of a side of the light's maps. More are sharper and slower.",
     "Münstermann et al. 2018, Section 7"},
    {ParameterId::shadow_radius, "shadow-radius", "r", "shadow filter radius", "texels", 0.0f, 8.0f, 4.0f,
     Scale::whole, Stage::shading,
     "The maps are filtered by a Gaussian of 2r + 1 texels a side: 4 is the paper's 9 x 9. A texel's function is then a "
     "mixture of its neighbours'.",
     "Münstermann et al. 2018, Section 6"},
    {ParameterId::light_azimuth, "light-azimuth", "φ_L", "azimuth of the light", "rad", -PI, PI, std::nullopt,
     Scale::linear, Stage::shading,
     "Where the light stands around the scene; `auto` is the scene's own place.", "Momentscope 2026"},
    {ParameterId::light_elevation, "light-elevation", "θ_L", "elevation of the light", "rad", 0.0f, 0.5f * PI,
     std::nullopt, Scale::linear, Stage::shading,
     "How high the light stands: 0 at the horizon, π/2 overhead; `auto` is the scene's own place.",
     "Momentscope 2026"},
    {ParameterId::light_distance, "light-distance", "d_L", "distance of the light", "", 0.1f, 10000.0f,
     std::nullopt, Scale::logarithmic, Stage::shading,
     "From the centre of all casters in scene units. It must stay outside of the sphere around them, from which the depth "
     "range follows; `auto` is four radii.",
     "Momentscope 2026"},
}};

bool is_whole(const Parameter& row) {
    return row.scale == Scale::choice || row.scale == Scale::whole || row.scale == Scale::toggle;
}

}  // namespace

std::span<const Parameter> parameters() {
    return ROWS;
}

const Parameter& parameter(ParameterId id) {
    return ROWS[static_cast<std::size_t>(id)];
}

const Parameter* find_parameter(std::string_view key) {
    const auto* row =
        std::ranges::find(ROWS, key, [](const Parameter& p) { return std::string_view(p.key); });
    return row == ROWS.end() ? nullptr : row;
}

ParameterValues::ParameterValues() {
    for (const Parameter& row : ROWS) values_[static_cast<std::size_t>(row.id)] = row.default_value;
}

void ParameterValues::set(ParameterId id, std::optional<float> value) {
    const Parameter& row = parameter(id);
    const bool in_range = value && *value >= row.minimum && *value <= row.maximum;  // false if it is NaN
    const bool allowed =
        value ? in_range && (!is_whole(row) || *value == std::floor(*value)) : !row.default_value;
    if (!allowed)
        throw Error(fmt::format("The {} --{} cannot be {}; give {}.", row.name, row.key,
                                value ? fmt::format("{}", *value) : "auto", parameter_values_text(row)));
    values_[static_cast<std::size_t>(id)] = value;
}

ParameterValues values_with(const ParameterSettings& settings) {
    ParameterValues values;
    for (const auto& [id, value] : settings) values.set(id, value);
    return values;
}

std::optional<float> parse_parameter(const Parameter& row, std::string_view text) {
    if (text == "auto") return std::nullopt;
    if (row.scale == Scale::toggle && (text == "on" || text == "true")) return 1.0f;
    if (row.scale == Scale::toggle && (text == "off" || text == "false")) return 0.0f;
    const auto choice =
        std::ranges::find(row.choices, text, [](const char* name) { return std::string_view(name); });
    if (choice != row.choices.end()) return static_cast<float>(choice - row.choices.begin());
    const auto value = parse_number<float>(text);
    if (!value)
        throw Error(fmt::format("'{}' is not a value of the {} --{}; give {}.", text, row.name, row.key,
                                parameter_values_text(row)));
    return *value;
}

std::string parameter_text(const Parameter& row, std::optional<float> value) {
    if (!value) return "auto";
    if (row.choices.empty()) return fmt::format("{:g}", *value);
    return row.choices[static_cast<std::size_t>(*value)];
}

std::string parameter_values_text(const Parameter& row) {
    if (row.scale == Scale::toggle) return "on or off";
    if (row.choices.empty())
        return fmt::format("a {}number from {:g} to {:g}{}{}{}", is_whole(row) ? "whole " : "", row.minimum,
                           row.maximum, *row.unit != '\0' ? " " : "", row.unit,
                           row.default_value ? "" : ", or auto");
    std::string list;
    for (std::size_t i = 0; i < row.choices.size(); ++i)
        list += fmt::format("{}{}",
                            i == 0                        ? ""
                            : i + 1 == row.choices.size() ? " or "
                                                          : ", ",
                            row.choices[i]);
    return list;
}

}  // namespace momentscope
