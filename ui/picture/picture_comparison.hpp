// picture_comparison.hpp -- picture against reference, and what the picture leaves open: which passes,
// numbers and maps are stale.
#pragma once
#include "core/gl/handle.hpp"
#include "ui/model/comparison.hpp"
#include "ui/model/update.hpp"
#include "ui/picture/picture.hpp"
#include "ui/picture/reference_picture.hpp"

namespace momentscope::ui {

/// Is there another technique to compare the picture with?
bool has_comparison(const ExplorerState& state);

/// Is the picture shown whose colours tell what the moments leave open?
bool shows_uncertainty(const ExplorerState& state);

/// The picture of the reference for a view.
View reference_view(const ExplorerState& state, const View& view);

class PictureComparison {
public:
    /// Shows the reference in the picture's place while `on`.
    void flip(bool on) { flipped_ = on; }
    bool flipped() const { return flipped_; }

    /// Picks the next worst pixel as soon as it is known.
    void want_worst() { worst_wanted_ = true; }
    void forget_worst() { worst_wanted_ = false; }
    bool wants_worst() const { return worst_wanted_; }

    /// The picture's error is needed, although no tab shows it.
    void want_error(bool wanted) { error_wanted_ = wanted; }

    /// The reference is drawn only if it is shown, compared with or needed for the worst pixel.
    bool wants_reference(const ExplorerState& state) const;

    /// The scene has changed.
    void forget_reference() { reference_.forget(); }
    const ReferencePicture& reference() const { return reference_; }

    /// Takes over finished numbers. Call it once per frame, whatever is shown.
    void poll() { numbers_.poll(); }

    /// Draws and computes what is stale after a change of the picture. This may pick another pixel. Throws
    /// Error if the GL fails.
    void update(const Update& update, const PictureChange& change, Renderer& renderer, const Scene& scene);

    /// There is no picture: stops the work.
    void stop();

    Comparison& numbers() { return numbers_; }
    const Comparison& numbers() const { return numbers_; }

    /// Will update measure what the moments leave open, after a change whose first stage is this one?
    bool measures_uncertainty(const ExplorerState& state, Stage stage) const {
        return shows_uncertainty(state) && (uncertainty_stale_ || stage <= Stage::color);
    }

    /// The map as a texture; 0 if there is none.
    GLuint map_texture() const { return numbers_.map().mode == CompareMode::off ? 0 : GLuint(map_texture_); }

private:
    void update_uncertainty(const Update& update, glm::ivec2 size, Renderer& renderer);
    void update_map(const Update& update);
    void pick_next_worst(const Update& update);

    ReferencePicture reference_;
    Comparison numbers_;
    GlTexture map_texture_;
    bool flipped_ = false;
    bool pair_stale_ = true;         // picture or reference changed since the last comparison
    bool uncertainty_stale_ = true;  // the picture changed since it was measured
    bool worst_wanted_ = false;
    bool error_wanted_ = false;
};

}  // namespace momentscope::ui
