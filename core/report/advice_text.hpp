// advice_text.hpp -- writes advice as sentences and as a small table.
#pragma once
#include <span>
#include <string>

#include "core/chart/advice.hpp"

namespace momentscope {

/// The bounds as text: "RMSE at most 0.01, at most 256 bits per pixel".
std::string bounds_text(const AdviceBounds& bounds);

/// The costs of a row, with the greatest known error: "RMSE 0.0031, 12.3 ms, 160 bits per pixel".
std::string cost_text(const ChartRow& row, Metric metric, const std::optional<double>& held_out);

/// The judgement as text: "meets the bounds", "too many bits", …
const char* judgement_text(Judgement judgement);

/// Why there is no winner, as a sentence that names the nearest row and says what to do.
std::string no_advice_text(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                           const HeldOutErrors& held_out, const Advice& advice);

/// Rows that explain the advice, in order of time: those that the advice names, those that failed only at
/// held-out views, the fastest that missed a bound, and the fastest that met the bounds. At most `most` in
/// addition to those that are named.
std::vector<std::size_t> evidence_of(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                                     const HeldOutErrors& held_out, const Advice& advice, std::size_t most);

/// The winner, the runner-up and what is better as lines, then the evidence as a table. The advice must have
/// a winner.
std::string advice_text(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                        const HeldOutErrors& held_out, const Advice& advice);

}  // namespace momentscope
