#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstdio>
#include <map>
#include <memory>

#include "app/command.hpp"
#include "app/figure_picture.hpp"
#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/figures/figure.hpp"
#include "core/render/view_from_light.hpp"
#include "core/scene/camera.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "core/support/reachable.hpp"
#include "ui/widgets/theme.hpp"

namespace momentscope {

namespace {

constexpr glm::ivec2 SIZE(480, 270);
constexpr const char* INTRODUCTION =
    "# The papers' figures, with our scenes\n\n"
    "Written by `momentscope figure all -o docs/figures`. Each figure is drawn with fixed settings. The table below it lists "
    "what the paper says about its figure and what was measured for ours. Our scenes are not copies of the papers' assets, so "
    "only the order of techniques can agree, not the numbers. Errors are root mean squares of linear colour at 480x270 "
    "against `sorted` unless a row says something else. A row that ranks techniques agrees if its numbers fall from left to "
    "right.\n\n";

/// Draws every setup only once.
class RenderedShots : public RenderSource {
public:
    const Image& picture(const RenderSetup& setup) override {
        std::string key = fmt::format("{} {}", setup.scene, setup.technique);
        for (const auto& [id, value] : setup.settings) key += fmt::format(" {}={}", parameter(id).key, value);
        const auto found = pictures_.find(key);
        if (found != pictures_.end()) return found->second;
        draw(setup);
        return pictures_.emplace(key, renderer_.read_picture()).first->second;
    }

    ViewRay picked_ray(const RenderSetup& setup) override {
        draw(setup);
        return renderer_.capture_pixel(picked_pixel(scene_, SIZE)).ray;
    }

    std::vector<CasterRay> caster_rays(const RenderSetup& setup) override {
        draw(setup);
        constexpr int STEPS = 2, STEP = 10;  // pixels
        const glm::ivec2 middle = picked_pixel(scene_, SIZE);
        std::vector<CasterRay> rays;
        for (int y = -STEPS; y <= STEPS; ++y)
            for (int x = -STEPS; x <= STEPS; ++x) {
                const glm::ivec2 pixel = middle + STEP * glm::ivec2(x, y);
                const PixelCapture eye = renderer_.capture_pixel(pixel);
                const auto& fragments = eye.ray.fragments;
                const auto caster = std::ranges::max_element(fragments, {}, &Fragment::opacity);
                if (caster == fragments.end() || caster->opacity < 0.5f) continue;
                auto light = view_from_light(renderer_, pixel, eye,
                                             static_cast<std::size_t>(caster - fragments.begin()));
                rays.push_back({std::move(light->ray), caster->draw});
            }
        assert(!rays.empty() && "nothing stands out at the scene's picked pixel");
        return rays;
    }

private:
    void draw(const RenderSetup& setup) {
        if (scene_.id != setup.scene) {
            scene_ = load_scene(setup.scene, *parameter(ParameterId::opacity).default_value);
            renderer_.set_scene(scene_);
        }
        renderer_.render(
            {scene_.camera, SIZE, &require_technique(setup.technique), values_with(setup.settings)});
    }

    Renderer renderer_;
    Scene scene_;
    std::map<std::string, Image> pictures_;
};

std::string text_of(const Figure& figure, const std::vector<ClaimResult>& results) {
    std::string text = fmt::format("{}: {} ({})\n", figure.id, figure.title, figure.source);
    for (const ClaimResult& result : results)
        text += fmt::format("  {} {}: {}\n", result.agrees ? "agrees       " : "DOES NOT AGREE", result.claim,
                            result.numbers);
    return text;
}

class FigureCommand : public ParsedCommand {
public:
    explicit FigureCommand(CLI::App& app) : ParsedCommand(app) {
        app.add_option("figure", figure_, "id of a figure (momentscope list figures), or all")->required();
        app.add_option("-o,--output", output_, "folder for the pictures [figures]");
        add_gl(app);
    }

    void run() const override {
        const std::vector<const Figure*> chosen = this->chosen();
        const std::filesystem::path folder = made_folder();
        std::atomic<std::size_t> done = 0;
        Progress progress("Drawing figures", [&] {
            if (done == 0)
                return std::string(
                    "Drawing figures was stopped before the first picture; nothing was written.");
            return fmt::format(
                "Drawing figures was stopped; {} of {} pictures are in '{}', but the page was not written.",
                done.load(), chosen.size(), folder.string());
        });
        const auto context = make_headless_context(MAX_FIGURE_SIZE);
        RenderedShots setups;
        GuiSession gui(nullptr, FIGURE_SCALE);
        ui::apply_style(ui::ThemeKind::light, FIGURE_SCALE);
        std::string page = INTRODUCTION;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            progress.show(i, chosen.size());
            progress.require_finished();
            const Figure& figure = *chosen[i];
            const std::string name = fmt::format("{}.png", figure.id);
            write_figure_picture(gui, figure, setups, folder / name);
            const std::vector<ClaimResult> results = figure.measure(setups);
            page += figure_section(figure, results, fmt::format("{}/{}", folder.filename().string(), name)) +
                    "\n";
            print(text_of(figure, results));
            std::fflush(stdout);  // finished results are visible even if the rest fails
            ++done;
        }
        progress.show(chosen.size(), chosen.size());
        if (figure_ == "all") write_file(page, std::filesystem::path(folder).concat(".md"));
    }

private:
    std::vector<const Figure*> chosen() const {
        if (figure_ != "all") return {&require_figure(figure_)};
        std::vector<const Figure*> all;
        for (const Figure& figure : figures()) all.push_back(&figure);
        return all;
    }

    std::filesystem::path made_folder() const {
        std::filesystem::path folder = absolute_path(output_).lexically_normal();
        if (!folder.has_filename()) folder = folder.parent_path();  // the name ends in a slash
        std::error_code code;
        std::filesystem::create_directories(folder, code);
        if (code)
            throw Error(fmt::format("The folder '{}' cannot be created: {}; give another -o.",
                                    folder.string(), code.message()));
        return folder;
    }

    std::string figure_;
    std::string output_ = "figures";
};

}  // namespace

std::unique_ptr<ParsedCommand> add_figure(CLI::App& app) {
    return std::make_unique<FigureCommand>(app);
}

}  // namespace momentscope
