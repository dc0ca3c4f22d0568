// gpu_check.hpp -- checks what this GL draws against C++, technique by technique.
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/gl/gl_info.hpp"
#include "core/gl/program.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Whether a technique was checked: yes; no, because this GL lacks what it needs; no, because drawing it
/// failed; or no, because the time was over.
enum class CheckState { checked, unavailable, failed, not_reached };

/// What one technique does on this GL.
struct TechniqueCheck {
    const Technique* technique = nullptr;
    CheckState state = CheckState::checked;
    std::string why_not;       // a sentence; empty if it was checked
    long fragments = 0;        // whose T was compared
    long different = 0;        // of these, whose bits differ from those of C++
    double worst = 0;          // the largest difference of T; NaN or infinite if one is
    double picture_error = 0;  // the largest difference of a pixel from the composition of C++, in linear RGB
    double first_pass = 0, second_pass = 0;  // milliseconds
};

struct GpuCheck {
    GlInfo gl;
    std::vector<TechniqueCheck> techniques;
    double seconds = 0;

    /// The sums and the greatest errors of all techniques that were checked.
    TechniqueCheck sum() const;

    /// How many techniques are in this state.
    long count(CheckState state) const;

    /// True if T has the bits of C++ everywhere.
    bool has_same_bits() const { return sum().different == 0; }

    /// True if nothing failed, all bits are the same, and no picture is further off than rounding explains.
    bool passed() const;
};

/// What is drawn, and how long at most. Techniques that are not reached say so in why_not.
struct GpuCheckPlan {
    std::vector<const Technique*> techniques;
    std::chrono::seconds limit{55};
};

/// A picture may be this far from the composition of C++, because colours are summed in half floats
/// (docs/tolerances.md).
constexpr double PICTURE_TOLERANCE = 0.01;

/// Checks on the scene teapots with these programs, whose capabilities decide what runs. `step` is called
/// after each technique. Needs a current context. Stops early if asked to.
GpuCheck check_gpu(const GpuCheckPlan& plan, const std::shared_ptr<ProgramCache>& programs,
                   const std::stop_token& stop, const std::function<void()>& step);

/// All techniques.
GpuCheckPlan full_gpu_check();

}  // namespace momentscope
