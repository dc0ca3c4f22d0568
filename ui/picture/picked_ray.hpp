// picked_ray.hpp -- the ray of the picked pixel: when its fragments are captured again, and what is computed
// from them again.
#pragma once
#include "ui/model/measurement.hpp"
#include "ui/picture/picture.hpp"

namespace momentscope::ui {

class PickedRay {
public:
    const Measurement& measurement() const { return measurement_; }

    /// Has nothing been measured yet?
    bool empty() const { return measurement_.curve.technique == nullptr; }

    /// Changes whenever fragments are captured.
    long number() const { return number_; }

    /// Captures the picked pixel and the pins of the full picture where they are stale, and measures.
    void update(const Update& update, const PictureChange& change, Renderer& renderer, const Scene& scene);

    /// The same for a draft: `drawn` says whether it was drawn again. The plot stays exact because it uses
    /// all fragments at the picked place. While the camera moves, that place is accurate to a pixel of the
    /// draft.
    void update_draft(const Update& update, const PictureChange& change, DraftPicture& draft, bool drawn,
                      const Scene& scene);

    /// The same for a view ray without a scene. Returns true if it is another one than before.
    bool update_ray(const Update& update);

    /// Captures the T of the second pass for each fragment, if it is not known.
    void require_transmittances(Renderer& renderer);

    void set_sharp_bounds(SharpBounds bounds) { measurement_.sharp = std::move(bounds); }

private:
    void capture(const Update& update, const PictureChange& change, Renderer& renderer, const Scene& scene);
    void capture_pins(const Update& update, const PictureChange& change, Renderer& renderer,
                      const Scene& scene);
    void see_from_light(const Update& update, Renderer& renderer);
    void measure(const Update& update, bool captured);

    Measurement measurement_;
    long number_ = 0;
    bool transmittance_stale_ = true;
    bool breakdown_stale_ = true;
    bool of_draft_ = false;  // the captured fragments are from a draft
};

}  // namespace momentscope::ui
