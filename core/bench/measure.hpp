// measure.hpp -- measures the time and the error of configurations on a scene.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/chart/chart_row.hpp"
#include "core/render/renderer.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

/// Parameters that change the pictures of all techniques. All others belong to the configurations.
inline constexpr std::array CHART_PARAMETERS = {ParameterId::order, ParameterId::order_seed,
                                                ParameterId::opacity};

struct ChartSettings {
    glm::ivec2 size{640, 360};
    int repeat = 3;          // rounds; each times every configuration of a block once
    ParameterValues values;  // parameters of all pictures: the order of submission
};

/// The number of steps in which this number of configurations is measured.
std::size_t chart_steps(std::size_t configurations, const ChartSettings& settings);

/// Measures configurations on one scene. Needs a current GL context during its whole life.
class ChartBench {
public:
    /// Throws Error if the scene cannot be drawn.
    ChartBench(Scene scene, const ChartSettings& settings);
    ~ChartBench();

    /// Begins with a block of configurations. advance() then makes one of the chart_steps steps. The first
    /// step of a scene takes longest, because it draws the references. rows() are valid when finished() is
    /// true. Throws Error if the GL fails.
    void begin(std::span<const Configuration> block);
    bool finished() const { return done_ == chart_steps(block_size_, settings_); }
    /// Makes the next step. A stop is checked between pictures; after a stop, do not use the bench any more.
    void advance(const std::stop_token& stop = {});
    std::vector<ChartRow> rows() const;

    /// Makes all steps of a block and returns one row per configuration, in their order. Configurations are
    /// timed in rounds, one after another and after `unsorted`, so that noise affects all alike. `step` is
    /// called after each of the chart_steps steps. Empty if stopped. Throws Error if the GL fails.
    std::vector<ChartRow> measure(std::span<const Configuration> block, const std::stop_token& stop,
                                  const std::function<void()>& step);

    const Scene& scene() const { return scene_; }

private:
    struct Candidate;
    void prepare(Candidate& candidate, const std::stop_token& stop);
    void time(std::size_t candidate);
    void finish(Candidate& candidate, const std::stop_token& stop) const;
    View view_of(const Configuration& configuration) const;
    std::unique_ptr<Renderer> new_renderer() const;
    void draw_references(const std::stop_token& stop);
    void compare(Candidate& candidate, const std::stop_token& stop) const;
    void follow_path(Candidate& candidate, const std::stop_token& stop) const;

    Scene scene_;
    ChartSettings settings_;
    std::shared_ptr<ProgramCache> programs_ = std::make_shared<ProgramCache>();
    std::unique_ptr<Renderer> baseline_renderer_;  // `unsorted`
    Image reference_;
    std::vector<Image> path_references_;
    std::string no_reference_;           // why the references cannot be used
    std::vector<Candidate> candidates_;  // of the current block
    std::size_t block_size_ = 0;
    std::size_t done_ = 0;  // steps
    double unsorted_ = 0;   // milliseconds of `unsorted` in this round
};

}  // namespace momentscope
