// sharp_bounds_work.hpp -- the sharp bounds of the plot. They take many linear programs, so a background
// thread computes them.
#pragma once
#include <optional>

#include "core/support/background_work.hpp"
#include "ui/model/measurement.hpp"
#include "ui/model/status.hpp"

namespace momentscope::ui {

class SharpBoundsWork {
public:
    /// Call it once per frame with what is measured and the number of its ray (PickedRay::number). Returns
    /// the bounds that the plot shows from now on, which may be none; nullopt: the same as before. Bounds for
    /// another ray, function or part of the axis are not shown.
    std::optional<SharpBounds> update(const PlotState& plot, const Measurement& measurement, long ray,
                                      Status& status);

    bool busy() const { return work_.busy(); }

private:
    struct Input {  // what the bounds depend on
        long ray;
        const Technique* technique;
        float theta;
        Range depths;
        friend bool operator==(const Input&, const Input&) = default;
    };

    BackgroundWork<std::optional<SharpBounds>> work_;
    std::optional<Input> asked_;  // of the last request; nullopt: none is shown or on its way
};

}  // namespace momentscope::ui
