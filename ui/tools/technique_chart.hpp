// technique_chart.hpp -- charts the techniques on the scene and recommends one of them; the Chart tab.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/report/drawing.hpp"
#include "ui/model/state.hpp"
#include "ui/model/status.hpp"
#include "ui/tools/chart_measurement.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

class TechniqueChart {
public:
    /// Starts to measure the scene with the settings of the panel's controls.
    void start(const Scene& scene, const ExplorerState& state, Status& status);
    void cancel() { measurement_.cancel(); }

    /// Draws some of the pictures that remain to be measured. Call it once per frame, whichever tab is open.
    void work(const ExplorerState& state, Status& status);

    /// Are there pictures left to draw?
    bool busy() const { return measurement_.busy() || checking_; }
    bool measuring() const { return measurement_.busy(); }

    /// Returns true if the user wants to save the chart. Clicks change technique and parameters.
    bool draw(const Ui& ui, const Scene& scene, ExplorerState& state, Status& status);

    /// Writes a .csv, .html, .svg or .md file. Throws Error.
    void write(const std::filesystem::path& path, const GlInfo& gl) const;

    const ChartMeasurement& measurement() const { return measurement_; }
    const std::optional<Advice>& advice() const { return advice_; }

private:
    bool is_stale(const ExplorerState& state) const;
    void update_advice();
    bool draw_controls(const Ui& ui, const Scene& scene, const ExplorerState& state, Status& status);
    void draw_sizes(const Ui& ui);
    void draw_bounds(const Ui& ui);
    void draw_error_bound(const Ui& ui, float right);  // right: right end of the space, in screen coordinates
    void draw_bits_bound(const Ui& ui, float right);
    void draw_advice(const Ui& ui, bool stale, ExplorerState& state);
    void draw_row(const Ui& ui, const char* name, std::optional<std::size_t> row, const char* otherwise,
                  bool stale, ExplorerState& state);
    void draw_chart(const Ui& ui, bool stale, ExplorerState& state);
    void update_drawing(glm::vec2 size);
    void use(std::size_t row, ExplorerState& state) const;
    std::string numbers_of(std::size_t row) const;

    ChartMeasurement measurement_;
    std::size_t size_ = 1;  // index into the sizes that the panel offers
    bool standards_only_ = false;
    AdviceBounds bounds_;
    bool bounds_bits_ = false;
    int bits_ = 256;
    std::optional<Advice> advice_;  // based on the rows so far; nullopt if there are none
    bool checking_ = false;         // errors at held-out views

    struct Drawn {
        std::size_t rows = 0;
        Metric metric = Metric::rmse;
        glm::vec2 size{0};
        friend bool operator==(const Drawn&, const Drawn&) = default;
    };
    Drawn drawn_;
    Drawing drawing_;
};

}  // namespace momentscope::ui
