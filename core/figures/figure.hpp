// figure.hpp -- figures of the papers as settings that can be replayed, with what the papers claim about them
// and functions that measure whether ours agree.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/compare/difference.hpp"
#include "core/parameters.hpp"
#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// A technique with parameters, on a scene.
struct RenderSetup {
    const char* scene;
    const char* technique;
    ParameterSettings settings = {};
};

/// One part of a figure: a picture, or the functions along a ray.
struct FigurePanel {
    std::string caption;
    RenderSetup setup;
    std::optional<ViewRay> ray = {};  // of a plot; nullopt: of the setup's scene at its picked pixel
    bool plot = false;
    bool transmittance = false;              // what a plot shows instead of absorbance
    glm::vec4 part = glm::vec4(0, 0, 1, 1);  // of a picture, as fractions from its upper left corner
};

/// What lies between the light and a caster that stands out, with the draw call of that caster.
struct CasterRay {
    ViewRay ray;
    std::uint32_t draw = 0;
};

/// Pictures and pixels of setups. Whoever has a GL implements it.
class RenderSource {
public:
    virtual ~RenderSource() = default;
    virtual const Image& picture(const RenderSetup& setup) = 0;
    virtual ViewRay picked_ray(const RenderSetup& setup) = 0;

    /// Around the scene's picked pixel, the light's rays through fragments of at least half opacity. Never
    /// empty. The setup has shadows.
    virtual std::vector<CasterRay> caster_rays(const RenderSetup& setup) = 0;

    /// Against `sorted`, of the picture or a part of it given by fractions from its upper left corner.
    double error(const RenderSetup& setup, Metric metric = Metric::rmse, glm::vec4 part = {0, 0, 1, 1});
};

/// What was measured of a claim.
struct ClaimResult {
    std::string claim;    // of the paper, in our words
    bool agrees = false;  // do ours show it?
    std::string numbers;
    std::string remark = "";  // why ours differ, or what else is worth knowing
};

struct Figure {
    const char* id;
    const char* source;  // paper and figure
    const char* title;
    std::vector<FigurePanel> panels;
    std::vector<ClaimResult> (*measure)(RenderSource&);
};

/// All figures, in the order of the papers; ids are unique.
std::span<const Figure> figures();

/// Throws Error that lists the ids.
const Figure& require_figure(std::string_view id);

/// A figure's section of docs/figures.md. picture: the file beside it.
std::string figure_section(const Figure& figure, const std::vector<ClaimResult>& results,
                           const std::string& picture);

}  // namespace momentscope
