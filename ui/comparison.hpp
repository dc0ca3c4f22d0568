// comparison.hpp -- what the metrics say about the picture and its reference, and how that looks.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/compare/difference.hpp"
#include "core/gl/handle.hpp"
#include "ui/background_work.hpp"
#include "ui/state.hpp"

namespace momentscope::ui {

/// Linear pictures of the same size.
struct PicturePair {
    Image reference, picture;
};

/// What one metric says about a pair.
struct MetricResult {
    Metric metric = Metric::rmse;
    std::vector<float> map;  // row by row
    double mean = 0;
    float least = 0, most = 0;
    glm::ivec2 worst{0};  // a pixel with the greatest difference
    long pair = 0;        // the number of the pair
};

/// A map of differences for the screen: sRGB RGBA bytes, row by row from the top.
struct ComparisonMap {
    CompareMode mode = CompareMode::off;  // off: there is none
    Metric metric = Metric::rmse;
    float gain = 1;
    long pair = 0;
    std::vector<unsigned char> rgba;
    GlTexture texture;
};

/// Knows the last pair, and works on its metrics beside the window, one after another, since FLIP takes about
/// a second per megapixel.
class Comparison {
public:
    /// Other pictures: what is known of the last ones stays until it is known of these.
    void set_pair(PicturePair pair);
    bool has_pair() const { return pair_ != nullptr; }
    const PicturePair& pair() const { return *pair_; }
    glm::ivec2 size() const;

    /// Takes what has ended. Once per frame, whatever is shown.
    void poll();

    /// Goes on with what is stale: `first`, then the others if `all`.
    void work_on(Metric first, bool all);
    void stop() { work_.cancel(); }
    bool busy() const { return work_.busy(); }

    /// nullptr when nothing is known yet. It may be of the last pair, while this one's is computed.
    const MetricResult* result(Metric metric) const;
    bool is_fresh(Metric metric) const;

    /// Of a part of the picture, from the result.
    double mean_of(const MetricResult& result, const PixelRegion& region);

    /// Computes the map that the state asks for, unless that is the one there is. True when it changed.
    bool update_map(const CompareState& state);
    const ComparisonMap& map() const { return map_; }

    /// The next worst pixel within the region; nullopt when no other differs. Those it gave before are
    /// forgotten with the pair, the metric or the region. Needs a fresh result.
    std::optional<glm::ivec2> next_worst(Metric metric, const PixelRegion& region);

    /// How many it gave since.
    std::size_t visited() const { return visited_.size(); }

private:
    void start(Metric metric);

    std::shared_ptr<const PicturePair> pair_;  // shared with the work
    long number_ = 0;                          // of the pair
    std::array<std::optional<MetricResult>, METRIC_COUNT> results_;
    BackgroundWork<std::optional<MetricResult>> work_;
    ComparisonMap map_;

    struct RegionMean {
        long pair = 0;
        PixelRegion region;
        double mean = 0;
    };
    std::array<RegionMean, METRIC_COUNT> region_means_;

    std::vector<glm::ivec2> visited_;
    long visited_pair_ = 0;
    Metric visited_metric_ = Metric::rmse;
    PixelRegion visited_region_;
};

/// Where the colours of a false-colour picture end.
float false_color_end(const CompareState& state);

/// The pixels of a region of a picture of that size; all of them for none. Never empty.
PixelRegion pixels_of(const std::optional<PictureRegion>& region, glm::ivec2 size);

/// The rectangle between two pixels, both within it.
PictureRegion region_between(glm::ivec2 one, glm::ivec2 other, glm::ivec2 size);

}  // namespace momentscope::ui
