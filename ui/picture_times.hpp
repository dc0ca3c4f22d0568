// picture_times.hpp -- how long the next picture takes, which nobody knows but from others of its kind.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/render/view.hpp"

namespace momentscope::ui {

/// What the time of a picture depends on, beside its size.
struct PictureKind {
    std::string scene;
    const Technique* technique = nullptr;
    std::vector<std::optional<float>> choices =
        {};                                // of parameters without a continuous range: their programs
    Stage stage = Stage::nothing;          // from which it is drawn
    const Technique* reference = nullptr;  // drawn beside it, or null
    Stage reference_stage = Stage::nothing;
    bool failures = false;  // marked anew
    friend auto operator<=>(const PictureKind&, const PictureKind&) = default;
};

class PictureTimes {
public:
    /// Milliseconds, as the last picture of the kind took for each of its pixels; nullopt when there was
    /// none.
    std::optional<double> expected(const PictureKind& kind, glm::ivec2 size) const {
        const auto found = per_pixel_.find(kind);
        if (found == per_pixel_.end()) return std::nullopt;
        return found->second * pixels(size);
    }

    void took(const PictureKind& kind, glm::ivec2 size, double milliseconds) {
        per_pixel_[kind] = milliseconds / pixels(size);
    }

private:
    static double pixels(glm::ivec2 size) {
        return static_cast<double>(size.x) * static_cast<double>(size.y);
    }

    std::map<PictureKind, double> per_pixel_;
};

}  // namespace momentscope::ui
