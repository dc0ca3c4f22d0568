// comparison.hpp -- the metrics of picture and reference, and maps of their difference.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/compare/difference.hpp"
#include "core/support/background_work.hpp"
#include "ui/model/state.hpp"

namespace momentscope::ui {

/// Two linear pictures of the same size.
struct PicturePair {
    Image reference, picture;
};

/// The result of one metric for a pair.
struct MetricResult {
    Metric metric = Metric::rmse;
    std::vector<float> map;  // row by row
    double mean = 0;
    float least = 0, most = 0;
    glm::ivec2 worst{0};  // a pixel with the greatest difference
    long pair = 0;        // number of the pair
};

/// A map of differences for the screen: sRGB RGBA bytes, row by row from the top.
struct ComparisonMap {
    CompareMode mode = CompareMode::off;  // off: there is no map
    Metric metric = Metric::rmse;
    float gain = 1;
    long pair = 0;
    std::vector<unsigned char> rgba;
};

/// Holds the last pair of pictures and computes its metrics in a background thread, one after another,
/// because FLIP takes about a second per megapixel.
class Comparison {
public:
    /// Sets new pictures. Results of the previous pair stay until the new ones are computed.
    void set_pair(PicturePair pair);
    bool has_pair() const { return pair_ != nullptr; }
    const PicturePair& pair() const { return *pair_; }
    glm::ivec2 size() const;

    /// Takes over a finished result. Call it once per frame, whatever is shown.
    void poll();

    /// Continues with stale metrics: `first`, then the others if `all` is true.
    void work_on(Metric first, bool all);
    void stop() { work_.cancel(); }
    bool busy() const { return work_.busy(); }

    /// nullptr if there is no result yet. The result may belong to the previous pair while the new one is
    /// computed.
    const MetricResult* result(Metric metric) const;
    bool is_fresh(Metric metric) const;

    /// The mean over a part of the picture.
    double mean_of(const MetricResult& result, const PixelRegion& region);

    /// Computes the map that the state requests, unless it exists already. Returns true if the map changed.
    bool update_map(const CompareState& state);
    const ComparisonMap& map() const { return map_; }

    /// The next worst pixel within the region, or nullopt if no other pixel differs. Changing the pair, the
    /// metric or the region starts a new sequence. Needs a fresh result.
    std::optional<glm::ivec2> next_worst(Metric metric, const PixelRegion& region);

    /// The number of pixels of the current sequence so far.
    std::size_t visited() const { return visited_.size(); }

private:
    void start(Metric metric);

    std::shared_ptr<const PicturePair> pair_;  // shared with the background work
    long number_ = 0;                          // number of the pair
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

/// The value at which the colours of a false-colour picture end.
float false_color_end(const CompareState& state);

/// The pixels of a region in a picture of this size; all pixels if there is no region. Never empty.
PixelRegion pixels_of(const std::optional<PictureRegion>& region, glm::ivec2 size);

/// The rectangle between two pixels, including both.
PictureRegion region_between(glm::ivec2 one, glm::ivec2 other, glm::ivec2 size);

}  // namespace momentscope::ui
