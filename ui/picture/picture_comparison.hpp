// picture_comparison.hpp -- picture against reference: which passes, numbers and maps are stale.
#pragma once
#include "core/gl/handle.hpp"
#include "ui/model/comparison.hpp"
#include "ui/model/update.hpp"
#include "ui/picture/picture.hpp"
#include "ui/picture/reference_picture.hpp"

namespace momentscope::ui {

/// Is there another technique to compare the picture with?
bool has_comparison(const ExplorerState& state);

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

    /// The reference is drawn only if it is shown, compared with or needed for the worst pixel.
    bool wants_reference(const ExplorerState& state) const;

    /// The scene has changed.
    void forget_reference() { reference_.forget(); }
    const ReferencePicture& reference() const { return reference_; }

    /// Takes over finished numbers. Call it once per frame, whatever is shown.
    void poll() { numbers_.poll(); }

    /// Draws and computes what is stale after a change of the picture. This may pick another pixel. Throws
    /// Error if the GL fails.
    void update(const Update& update, const PictureChange& change, const Renderer& renderer,
                const Scene& scene);

    /// There is no picture: stops the work.
    void stop();

    Comparison& numbers() { return numbers_; }
    const Comparison& numbers() const { return numbers_; }

    /// The map of differences as a texture; 0 if there is none.
    GLuint map_texture() const { return numbers_.map().mode == CompareMode::off ? 0 : GLuint(map_texture_); }

private:
    void pick_next_worst(const Update& update);

    ReferencePicture reference_;
    Comparison numbers_;
    GlTexture map_texture_;
    bool flipped_ = false;
    bool pair_stale_ = true;  // picture or reference changed since the last comparison
    bool worst_wanted_ = false;
};

}  // namespace momentscope::ui
