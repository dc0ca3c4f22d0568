// flip.hpp -- LDR-FLIP (Andersson et al. 2020): how different two pictures look if one switches between them.
#pragma once
#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/image/image.hpp"

namespace momentscope {

/// The pixels per degree of a 0.7 m wide display with 3840 pixels across, seen from 0.7 m.
constexpr double PIXELS_PER_DEGREE = 67.0206432;

/// FLIP in parts, which may run in any order and at the same time.
class FlipParts {
public:
    /// Both pictures are linear RGB of the same size and are clamped to [0, 1].
    FlipParts(const Image& reference, const Image& test);
    ~FlipParts();
    std::size_t count() const;
    void run(std::size_t part);
    /// The difference of each pixel, in [0, 1], row by row. All parts must have run.
    std::vector<float> map() const;

private:
    struct Seen;
    std::size_t bands_;       // of rows
    std::vector<Seen> seen_;  // the reference, the other picture
};

/// The same at once. Empty if stopped.
std::vector<float> flip_map(const Image& reference, const Image& test, const std::stop_token& stop = {});

}  // namespace momentscope
