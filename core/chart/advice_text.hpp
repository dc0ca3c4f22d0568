// advice_text.hpp -- advice in sentences and as a small table.
#pragma once
#include <span>
#include <string>

#include "core/chart/advice.hpp"

namespace momentscope {

/// "RMSE at most 0.01, at most 256 bits per pixel".
std::string bounds_text(const AdviceBounds& bounds);

/// "RMSE 0.0031, 12.3 ms, 160 bits per pixel": the greatest error that is known.
std::string cost_text(const ChartRow& row, Metric metric, const std::optional<double>& held_out);

/// "meets the bounds", "too many bits", …
const char* judgement_text(Judgement judgement);

/// Why there is no winner, as a sentence that names the nearest row and says what to do.
std::string no_advice_text(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                           const HeldOutErrors& held_out, const Advice& advice);

/// Rows that show why the advice is as it is, by growing time: those that it names, those that failed at
/// views that are held out alone, the fastest that missed a bound, and the fastest that met them; at most
/// `most` beside those that are named.
std::vector<std::size_t> evidence_of(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                                     const HeldOutErrors& held_out, const Advice& advice, std::size_t most);

/// Winner, runner-up and what is better as lines, then the evidence as a table in columns. There is a
/// winner.
std::string advice_text(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                        const HeldOutErrors& held_out, const Advice& advice);

}  // namespace momentscope
