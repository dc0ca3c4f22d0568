// measure.hpp -- what configurations cost on a scene, and how wrong their pictures are.
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

/// Those that change the pictures of all techniques; the others stand in the configurations.
inline constexpr std::array CHART_PARAMETERS = {ParameterId::order, ParameterId::order_seed,
                                                ParameterId::opacity};

struct ChartSettings {
    glm::ivec2 size{640, 360};
    int repeat = 3;          // rounds in which every configuration of a block is timed once
    ParameterValues values;  // those of the picture: the order of submission
};

/// In how many steps so many configurations are measured.
std::size_t chart_steps(std::size_t configurations, const ChartSettings& settings);

/// Measures one scene. Needs a current GL context as long as it lives.
class ChartBench {
public:
    /// Throws Error when the scene cannot be drawn.
    ChartBench(Scene scene, const ChartSettings& settings);
    ~ChartBench();

    /// Begins with a block of configurations, of which one picture at a time is drawn: advance() makes one of
    /// the chart_steps steps, of which the first of a scene takes the longest, since it draws the references.
    /// The rows are there once it is finished. Throws Error when the GL fails.
    void begin(std::span<const Configuration> block);
    bool finished() const { return done_ == chart_steps(block_size_, settings_); }
    /// After a stop, which is looked for between pictures, the bench must not go on.
    void advance(const std::stop_token& stop = {});
    std::vector<ChartRow> rows() const;

    /// All steps of a block: a row per configuration, in their order. They are timed in rounds, one after the
    /// other and after `unsorted`, so that noise hits all alike. `step` is called after every one of
    /// chart_steps steps. Empty when it was stopped. Throws Error when the GL fails.
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
    std::string no_reference_;           // why pictures cannot be compared with the references
    std::vector<Candidate> candidates_;  // the block
    std::size_t block_size_ = 0;
    std::size_t done_ = 0;  // steps
    double unsorted_ = 0;   // milliseconds in this round
};

}  // namespace momentscope
