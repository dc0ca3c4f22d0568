#include "core/report/advice_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace momentscope {

namespace {

constexpr std::size_t MAX_EVIDENCE = 9;

const char* symbol_of(Metric metric) {
    return metrics()[static_cast<std::size_t>(metric)].symbol;
}

// "infinite" if the picture has pixels that are infinite or NaN.
std::string error_text(double error) {
    return std::isfinite(error) ? fmt::format("{:.3g}", error) : "infinite";
}

std::string bits_text(const ChartRow& row) {
    return row.numbers->bits_with_factor ? fmt::format("{}", *row.numbers->bits_with_factor) : "grows";
}

std::string role_of(std::size_t row, const Advice& advice) {
    if (advice.winner == row) return "the advice";
    if (advice.runner_up == row) return advice.next_better == row ? "runner-up, half the error" : "runner-up";
    if (advice.next_better == row) return "half the error";
    return {};
}

// The difference to the winner, or that there is no visible one.
std::string price_text(const ChartRow& row, const ChartRow& winner) {
    const double more = row.numbers->total.median - winner.numbers->total.median;
    const double noise = 0.5 * (row.numbers->total.range + winner.numbers->total.range);
    return more > noise ? fmt::format("{:.1f} ms more", more) : "no measurable extra time";
}

std::string named(std::span<const ChartRow> rows, const AdviceBounds& bounds, const HeldOutErrors& held_out,
                  std::size_t row) {
    return fmt::format("{} ({})", rows[row].configuration,
                       cost_text(rows[row], bounds.metric, held_out[row]));
}

std::string evidence_table(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                           const HeldOutErrors& held_out, const Advice& advice) {
    const auto evidence = evidence_of(rows, bounds, held_out, advice, MAX_EVIDENCE);
    std::size_t width = 13;
    for (const std::size_t i : evidence) width = std::max(width, rows[i].configuration.size());
    std::string text = fmt::format("{:<{}}  {:>8}  {:>6}  {:>5}  {:>9}  {:>9}\n", "configuration", width,
                                   "total ms", "spread", "bits", symbol_of(bounds.metric), "elsewhere");
    for (const std::size_t i : evidence) {
        const ChartNumbers& n = *rows[i].numbers;
        const std::string role = role_of(i, advice);
        fmt::format_to(std::back_inserter(text), "{:<{}}  {:>8.1f}  {:>6.1f}  {:>5}  {:>9.3g}  {:>9}  {}\n",
                       rows[i].configuration, width, n.total.median, n.total.range, bits_text(rows[i]),
                       error_of(n, bounds.metric), held_out[i] ? error_text(*held_out[i]) : "",
                       role.empty() ? judgement_text(classify(rows[i], bounds, held_out[i])) : role);
    }
    return text;
}

}  // namespace

std::string bounds_text(const AdviceBounds& bounds) {
    std::string text = fmt::format("{} at most {:g}", symbol_of(bounds.metric), bounds.max_error);
    if (bounds.max_bits) text += fmt::format(", at most {} bits per pixel", *bounds.max_bits);
    if (bounds.max_ms) text += fmt::format(", at most {:g} ms", *bounds.max_ms);
    if (bounds.order_independent) text += ", independent of the order";
    return text;
}

std::string cost_text(const ChartRow& row, Metric metric, const std::optional<double>& held_out) {
    return fmt::format("{} {}, {:.1f} ms, {}", symbol_of(metric),
                       error_text(worst_error(row, metric, held_out)), row.numbers->total.median,
                       row.numbers->bits_with_factor ? bits_text(row) + " bits per pixel"
                                                     : "bits that grow with the layers");
}

const char* judgement_text(Judgement judgement) {
    switch (judgement) {
        case Judgement::meets:
            return "meets the bounds";
        case Judgement::unavailable:
            return "not available";
        case Judgement::ground_truth:
            return "ground truth";
        case Judgement::order_dependent:
            return "depends on the order";
        case Judgement::infinite_elsewhere:
            return "infinite pixels elsewhere";
        case Judgement::inaccurate:
            return "error too great";
        case Judgement::inaccurate_elsewhere:
            return "error too great elsewhere";
        case Judgement::too_many_bits:
            return "too many bits";
        case Judgement::too_slow:
            break;
    }
    return "too slow";
}

std::string no_advice_text(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                           const HeldOutErrors& held_out, const Advice& advice) {
    if (advice.nearest && advice.ground_truths.empty())
        return fmt::format("Nothing meets these bounds ({}), and the nearest is {}; allow more.",
                           bounds_text(bounds), named(rows, bounds, held_out, *advice.nearest));
    if (advice.ground_truths.empty())
        return "None of these configurations can be advised; allow others, or those that depend on the order.";
    std::string truths;
    for (const std::size_t i : advice.ground_truths)
        truths += fmt::format("{}{} at {:.1f} ms", truths.empty() ? "" : " and ", rows[i].configuration,
                              rows[i].numbers->total.median);
    const std::string rest = advice.nearest ? fmt::format(", and the nearest of the others is {}; allow more",
                                                          named(rows, bounds, held_out, *advice.nearest))
                                            : std::string("; allow other techniques");
    return fmt::format("Only a ground truth meets these bounds ({}), namely {}{}.", bounds_text(bounds),
                       truths, rest);
}

std::vector<std::size_t> evidence_of(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                                     const HeldOutErrors& held_out, const Advice& advice, std::size_t most) {
    std::vector<std::size_t> by_time;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].numbers) by_time.push_back(i);
    const auto time = [&](std::size_t i) { return std::pair(rows[i].numbers->total.median, i); };
    std::ranges::sort(by_time, {}, time);
    std::vector<std::size_t> shown;
    for (const auto& row : {advice.winner, advice.runner_up, advice.next_better, advice.nearest})
        if (row && std::ranges::find(shown, *row) == shown.end()) shown.push_back(*row);
    const std::size_t all = shown.size() + most;
    const auto add = [&](Judgement judgement, std::size_t count) {
        for (const std::size_t i : by_time) {
            if (shown.size() >= all || count == 0) return;
            if (classify(rows[i], bounds, held_out[i]) != judgement ||
                std::ranges::find(shown, i) != shown.end())
                continue;
            shown.push_back(i);
            --count;
        }
    };
    const std::size_t share = std::max<std::size_t>(most / 3, 1);
    add(Judgement::infinite_elsewhere, share);
    add(Judgement::inaccurate_elsewhere, share);
    for (const Judgement missed :
         {Judgement::inaccurate, Judgement::too_many_bits, Judgement::too_slow, Judgement::order_dependent})
        add(missed, std::max<std::size_t>(share / 2, 1));
    add(Judgement::meets, share);
    std::ranges::sort(shown, {}, time);
    return shown;
}

std::string advice_text(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                        const HeldOutErrors& held_out, const Advice& advice) {
    assert(advice.winner);
    const ChartRow& winner = rows[*advice.winner];
    std::string text = fmt::format("Cheapest     {}\n", named(rows, bounds, held_out, *advice.winner));
    text +=
        fmt::format("Runner-up    {}\n", advice.runner_up ? named(rows, bounds, held_out, *advice.runner_up)
                                                          : "nothing else meets the bounds");
    text += advice.next_better ? fmt::format("Next better  {}: half the error for {}\n",
                                             named(rows, bounds, held_out, *advice.next_better),
                                             price_text(rows[*advice.next_better], winner))
                               : "Next better  nothing but a ground truth has half the error\n";
    return fmt::format("{}\n{}", text, evidence_table(rows, bounds, held_out, advice));
}

}  // namespace momentscope
