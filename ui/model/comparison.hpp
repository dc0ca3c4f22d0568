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

/// A number for each pixel of a picture.
struct PixelNumbers {
    std::vector<float> map = {};  // row by row
    double mean = 0;
    float least = 0, most = 0;
    long of = 0;  // number of the pair of pictures, or of the picture
};

/// The result of one metric for a pair.
struct MetricResult : PixelNumbers {
    Metric metric = Metric::rmse;
    glm::ivec2 worst{0};  // a pixel with the greatest difference
};

/// A map for the screen: sRGB RGBA bytes, row by row from the top.
struct ComparisonMap {
    CompareMode mode = CompareMode::off;  // off: there is no map
    Metric metric = Metric::rmse;
    float gain = 1;
    long of = 0;  // as in PixelNumbers
    glm::ivec2 size{0};
    std::vector<float> numbers = {};  // of the false colours; empty for differences
    std::vector<unsigned char> rgba = {};
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

    /// Sets how much of each pixel's luminance the bounds of the picture leave open.
    void set_uncertainty(std::vector<float> map, glm::ivec2 size);

    /// nullptr before set_uncertainty.
    const PixelNumbers* uncertainty() const { return uncertainty_ ? &*uncertainty_ : nullptr; }

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
    const PixelNumbers* false_color_numbers(const CompareState& state) const;

    std::shared_ptr<const PicturePair> pair_;  // shared with the background work
    long number_ = 0;                          // number of the pair
    std::array<std::optional<MetricResult>, METRIC_COUNT> results_;
    BackgroundWork<std::optional<MetricResult>> work_;
    ComparisonMap map_;
    std::optional<PixelNumbers> uncertainty_;
    glm::ivec2 uncertainty_size_{0};

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

/// The number at which the colours of a false-colour picture end: of the chosen metric, or of the
/// uncertainty.
float false_color_end(const CompareState& state);

/// The pixels of a region in a picture of this size; all pixels if there is no region. Never empty.
PixelRegion pixels_of(const std::optional<PictureRegion>& region, glm::ivec2 size);

/// The rectangle between two pixels, including both.
PictureRegion region_between(glm::ivec2 one, glm::ivec2 other, glm::ivec2 size);

}  // namespace momentscope::ui
