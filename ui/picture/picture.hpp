// picture.hpp -- the picture of the state: the full one, or a draft while the mouse drags.
#pragma once
#include "ui/model/update.hpp"
#include "ui/picture/draft_picture.hpp"

namespace momentscope::ui {

/// From the picture that is shown to the one that is wanted.
struct PictureChange {
    View before;  // technique is null if nothing was shown
    View now;
    Stage stage;  // the first one that runs again

    /// Can the fragments of a pixel differ from before? After the opaque pass they depend only on their
    /// order, on the light, and on what low-resolution moments mix.
    bool changes_fragments() const;
};

/// What the mouse does in this frame.
struct Pointer {
    bool held = false;  // is a button down?
    float seconds = 0;  // since the last frame
};

class Picture {
public:
    /// most_milliseconds: while the mouse drags, a picture that takes longer is replaced by a draft.
    Picture(Renderer& renderer, double most_milliseconds);

    Renderer& renderer() const { return renderer_; }

    /// Sets another scene. Throws Error if the GL has no room for it; then the last scene stays.
    void set_scene(const Scene& scene);

    /// Sets other objects of the same meshes.
    void set_objects(const Scene& scene);

    /// The next picture is drawn from the first stage on.
    void forget() { shown_.technique = nullptr; }

    PictureChange change_to(const View& view) const;

    /// True while the mouse drags and the picture takes too long, until the mouse rests.
    bool wants_draft(const PictureChange& change, Pointer pointer);

    /// Returns true if the draft was drawn again. Throws Error if the GL fails.
    bool draw_draft(const View& view);
    DraftPicture& draft() { return draft_; }

    /// Is a draft shown? The full picture replaces it when the view has not changed for 0.2 s or the mouse
    /// button is released.
    bool shows_draft() const { return draft_view_.technique != nullptr; }

    /// Draws the full picture, and tells which passes ran. Throws Error if the view cannot be drawn.
    void draw(const PictureChange& change, FrameReport& report);

private:
    Renderer& renderer_;
    View shown_;  // technique is null if nothing is shown
    DraftPicture draft_;
    View draft_view_;  // technique is null if the full picture is shown
    double most_milliseconds_;
    float still_seconds_ = 0;  // since the draft's view last changed
};

}  // namespace momentscope::ui
