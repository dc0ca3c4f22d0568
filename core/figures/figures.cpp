// figures.cpp -- the registry of figures. Pictures show our own scenes and not copies of the assets of the
// papers. So the order of techniques can be compared, but not the numbers.
#include <numbers>

#include "core/figures/claims.hpp"

namespace momentscope {

namespace {

using enum ParameterId;

FigurePanel picture(std::string caption, RenderSetup setup) {
    return {.caption = std::move(caption), .setup = std::move(setup)};
}

constexpr glm::vec4 MIDDLE(0.35f, 0.15f, 0.65f, 0.45f);  // where the spheres meet

FigurePanel detail(std::string caption, RenderSetup setup, const glm::vec4& part) {
    return {.caption = std::move(caption), .setup = std::move(setup), .part = part};
}

FigurePanel plot(std::string caption, RenderSetup setup, std::optional<ViewRay> ray = {},
                 bool transmittance = false) {
    return {std::move(caption), std::move(setup), std::move(ray), true, transmittance};
}

std::vector<Figure> make_figures() {
    return {
        {"fig2",
         "Münstermann et al. 2018, Fig. 2",
         "Overestimation in a cloud",
         {plot("absorbance, six power moments", {"cloud", "power6-32"}),
          plot("transmittance", {"cloud", "power6-32"}, std::nullopt, true)},
         measure_overestimation},
        {"fig3",
         "Münstermann et al. 2018, Fig. 3",
         "Ideal cases",
         {plot("power4-32, two sheets", {"", "power4-32"}, even_sheets(2)),
          plot("power6-32, three sheets", {"", "power6-32"}, even_sheets(3)),
          plot("power8-32, four sheets", {"", "power8-32"}, even_sheets(4)),
          plot("trig2-32, two sheets", {"", "trig2-32"}, even_sheets(2)),
          plot("trig3-32, three sheets", {"", "trig3-32"}, even_sheets(3)),
          plot("trig4-32, four sheets", {"", "trig4-32"}, even_sheets(4))},
         measure_ideal},
        {"fig4",
         "Münstermann et al. 2018, Fig. 4",
         "The wrapping zone",
         {plot("θ = .01π", {"", "trig3-32", {{theta, 0.01f * std::numbers::pi_v<float>}}}, uneven_sheets()),
          plot("θ = .1π", {"", "trig3-32"}, uneven_sheets()),
          plot("θ = .4π", {"", "trig3-32", {{theta, 0.4f * std::numbers::pi_v<float>}}}, uneven_sheets())},
         measure_wrapping},
        {"fig5",
         "Münstermann et al. 2018, Fig. 1 and 5 and Section 7.1",
         "A ship in fog",
         {picture("sorted", {"ship", "sorted"}), picture("wboit", {"ship", "wboit"}),
          picture("mlab, 4 layers", {"ship", "mlab"}), picture("power4-16, 80 bits", {"ship", "power4-16"}),
          picture("power6-32, 224 bits", {"ship", "power6-32"}),
          picture("trig3-32, 224 bits", {"ship", "trig3-32"})},
         measure_ship},
        {"fig6",
         "Münstermann et al. 2018, Fig. 6",
         "Teapots behind curtains",
         {picture("sorted", {"teapots", "sorted"}), picture("at, 4 nodes", {"teapots", "at"}),
          picture("wboit", {"teapots", "wboit"}), picture("mlab, 4 layers", {"teapots", "mlab"}),
          picture("power4-32", {"teapots", "power4-32"}),
          picture("power6-16, 112 bits", {"teapots", "power6-16"})},
         measure_teapots},
        {"fig7",
         "Münstermann et al. 2018, Fig. 7",
         "Alpha-mapped foliage",
         {picture("sorted", {"foliage", "sorted"}),
          picture("power6-32, without renormalisation", {"foliage", "power6-32", {{renormalize, 0}}}),
          picture("power6-32, with renormalisation", {"foliage", "power6-32"})},
         measure_foliage},
        {"fig8",
         "Münstermann et al. 2018, Fig. 8",
         "Intersecting spheres",
         {detail("power4-16", {"spheres", "power4-16"}, MIDDLE),
          detail("trig3-16", {"spheres", "trig3-16"}, MIDDLE),
          detail("power6-32", {"spheres", "power6-32"}, MIDDLE),
          detail("trig4-32", {"spheres", "trig4-32"}, MIDDLE),
          detail("mlab, 4 layers", {"spheres", "mlab"}, MIDDLE),
          detail("sorted", {"spheres", "sorted"}, MIDDLE)},
         measure_spheres},
        {"fig9",
         "Münstermann et al. 2018, Fig. 9",
         "Shadows in a cloud",
         {picture("Fourier, 7 coefficients", shadow_setup("fourier-7", 0)),
          picture("Fourier, 15 coefficients", shadow_setup("fourier-15", 0)),
          picture("deep shadow map (truth)", shadow_setup("deep", 0)),
          picture("4 power moments, β = 0.5", shadow_setup("power4-32", 0.5f)),
          picture("6 power moments, β = 0.5", shadow_setup("power6-32", 0.5f)),
          picture("6 power moments, β = 0", shadow_setup("power6-32", 0))},
         measure_cloud_shadows},
        {"supp1",
         "Münstermann et al. 2018, supplementary, Fig. 1",
         "Eight power moments",
         {picture("cloud", {"cloud", "power8-32"}), picture("smoke", {"smoke", "power8-32"}),
          picture("spheres", {"spheres", "power8-32"}), picture("teapots", {"teapots", "power8-32"})},
         measure_eight},
        {"supp2",
         "Münstermann et al. 2018, supplementary, Fig. 2",
         "The ship with further variants",
         {picture("power6-32, 224 bits", {"ship", "power6-32"}),
          picture("power8-32, 288 bits", {"ship", "power8-32"}),
          picture("trig3-32, 224 bits", {"ship", "trig3-32"}), picture("sorted", {"ship", "sorted"})},
         measure_variants},
        {"sharpe1",
         "Sharpe 2018, Fig. 1",
         "Grass and bottles in smoke",
         {picture("wboit", {"smoke", "wboit"}), picture("mt, β = .25", {"smoke", "mt"}),
          picture("mt, two passes, β = 0", {"smoke", "mt", {{beta, 0}, {moment_passes, TWO_PASSES}}}),
          picture("sorted", {"smoke", "sorted"})},
         measure_smoke},
        {"sharpe2",
         "Sharpe 2018, Fig. 2",
         "One and two moment passes along a ray",
         {plot("three samples: mt, β = 0", {"", "mt", {{beta, 0}}}, even_sheets(3), true),
          plot("three samples: two passes", {"", "mt", {{beta, 0}, {moment_passes, TWO_PASSES}}},
               even_sheets(3), true),
          plot("six samples: mt, β = 0", {"", "mt", {{beta, 0}}}, even_sheets(6), true),
          plot("six samples: two passes", {"", "mt", {{beta, 0}, {moment_passes, TWO_PASSES}}},
               even_sheets(6), true)},
         measure_samples},
        {"sharpe3",
         "Sharpe 2018, Fig. 3",
         "Moments at an eighth of the resolution",
         {picture("mt at full resolution", {"smoke", "mt"}),
          picture("mt at 1/8", {"smoke", "mt", {{resolution, 3}}}), picture("sorted", {"smoke", "sorted"})},
         measure_low},
    };
}

}  // namespace

std::span<const Figure> figures() {
    static const std::vector<Figure> rows = make_figures();
    return rows;
}

}  // namespace momentscope
