// picture_times.hpp -- predicts the time of the next picture from earlier pictures of the same kind.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/render/view.hpp"

namespace momentscope::ui {

/// What the time of a picture depends on, besides its size.
struct PictureKind {
    std::string scene;
    const Technique* technique = nullptr;
    std::vector<std::optional<float>> choices = {};  // values of discrete parameters, which select programs
    Stage stage = Stage::nothing;                    // first stage that is drawn
    const Technique* reference = nullptr;            // reference that is drawn, too, or null
    Stage reference_stage = Stage::nothing;
    bool failures = false;     // failures are marked again
    bool uncertainty = false;  // what the moments leave open is measured again
    friend auto operator<=>(const PictureKind&, const PictureKind&) = default;
};

class PictureTimes {
public:
    /// The expected milliseconds, from the time per pixel of the last picture of this kind; nullopt if there
    /// was none.
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
