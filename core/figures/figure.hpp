// figure.hpp -- the figures of the papers as settings that can be drawn again, with the claims of the papers
// about them and functions that measure whether our figures agree.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/compare/difference.hpp"
#include "core/parameters/parameters.hpp"
#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// A technique with parameters, and a scene.
struct RenderSetup {
    const char* scene;
    const char* technique;
    ParameterSettings settings = {};
};

/// One part of a figure: a picture, or a plot of the functions along a ray.
struct FigurePanel {
    std::string caption;
    RenderSetup setup;
    std::optional<ViewRay> ray = {};  // for a plot; nullopt: the ray of the picked pixel of the scene
    bool plot = false;
    bool transmittance = false;              // does a plot show T instead of absorbance?
    glm::vec4 part = glm::vec4(0, 0, 1, 1);  // part of a picture, as fractions from its upper left corner
};

/// A ray from the light through a caster that is clearly visible, with the draw call of this caster.
struct CasterRay {
    ViewRay ray;
    std::uint32_t draw = 0;
};

/// The source of pictures and pixels of setups. Code that has a GL implements it.
class RenderSource {
public:
    virtual ~RenderSource() = default;
    virtual const Image& picture(const RenderSetup& setup) = 0;
    virtual ViewRay picked_ray(const RenderSetup& setup) = 0;

    /// The rays from the light through fragments of at least half opacity, around the picked pixel of the
    /// scene. Never empty. The setup must have shadows.
    virtual std::vector<CasterRay> caster_rays(const RenderSetup& setup) = 0;

    /// The error compared with `sorted`, for the picture or for a part of it, given as fractions from its
    /// upper left corner.
    double error(const RenderSetup& setup, Metric metric = Metric::rmse, glm::vec4 part = {0, 0, 1, 1});
};

/// The result of measuring a claim.
struct ClaimResult {
    std::string claim;    // the claim of the paper, in our words
    bool agrees = false;  // do our figures show it?
    std::string numbers;
    std::string remark = "";  // why ours differ, or other notes
};

struct Figure {
    const char* id;
    const char* source;  // paper and figure
    const char* title;
    std::vector<FigurePanel> panels;
    std::vector<ClaimResult> (*measure)(RenderSource&);
};

/// All figures, in the order of the papers. Their ids are unique.
std::span<const Figure> figures();

/// The figure with this id. Throws Error, with a list of all ids, if there is none.
const Figure& require_figure(std::string_view id);

/// The section about a figure in docs/figures.md. picture: the file name of its picture.
std::string figure_section(const Figure& figure, const std::vector<ClaimResult>& results,
                           const std::string& picture);

}  // namespace momentscope
