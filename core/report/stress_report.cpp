#include "core/report/stress_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/ray/ray_json.hpp"
#include "core/report/page_files.hpp"
#include "core/support/json_text.hpp"
#include "core/support/markup.hpp"

namespace momentscope {

namespace {

// The ray as JSON; empty for more than 64 fragments, because ten thousand would dominate the file.
std::string ray_text(const ViewRay& ray) {
    return ray.fragments.size() > 64 ? "" : json_text(ray_to_json(ray));
}

std::string heading(const std::vector<StressCell>& cells, std::size_t columns) {
    std::string groups;
    std::string names;
    for (std::size_t i = 0; i < columns;) {
        const std::string& group = cells[i].condition->group;
        std::size_t end = i;
        while (end < columns && cells[end].condition->group == group) ++end;
        groups += fmt::format("<th class=group colspan={}>{}</th>", end - i, markup_escaped(group));
        i = end;
    }
    for (std::size_t i = 0; i < columns; ++i)
        names += fmt::format("<th title=\"{}\">{}</th>", markup_escaped(cells[i].condition->help),
                             markup_escaped(cells[i].condition->name));
    return fmt::format("<tr><th></th>{}</tr>\n<tr><th></th>{}</tr>\n", groups, names);
}

}  // namespace

glm::vec3 failure_color(double rate) {
    // Colours with a lightness of 25, 60, 85, 55 and 30 %: blue, teal, yellow, orange, dark red.
    static constexpr std::array<glm::vec3, 5> STOPS = {
        glm::vec3(0.10f, 0.22f, 0.42f), glm::vec3(0.25f, 0.60f, 0.62f), glm::vec3(0.96f, 0.86f, 0.40f),
        glm::vec3(0.88f, 0.45f, 0.14f), glm::vec3(0.55f, 0.06f, 0.10f)};
    if (!(rate > 0)) return STOPS[0];
    // A rate of 1e-4 has the second colour; each decade more has the next one.
    const double place = std::clamp(std::log10(rate) + 5.0, 1.0, 4.0);
    const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), STOPS.size() - 2);
    return glm::mix(STOPS[below], STOPS[below + 1], static_cast<float>(place - static_cast<double>(below)));
}

std::string rate_text(double rate) {
    if (!(rate > 0)) return "0";
    if (rate >= 0.0095) return fmt::format("{:.0f}%", 100 * rate);
    if (rate >= 0.00095) return fmt::format("{:.1f}%", 100 * rate);
    return fmt::format("{:.0e}", rate);
}

std::string cell_sentence(const StressCell& cell) {
    const auto share = [](long count, long of) {
        return of == 0 ? std::string("0") : rate_text(static_cast<double>(count) / static_cast<double>(of));
    };
    return fmt::format(
        "{} of {} queries fail ({} not finite, {} outside [0, b0], {} off by more than {}). Error of T against the exact result: "
        "mean {:.1e}, 99 % {:.1e}, worst {:.1e}; against the truth: mean {:.1e}. Pivots were raised to the floor in {} of "
        "the rays, and sums were clamped in {} of the queries. The order matters in {} of the rays, the curve falls in {} "
        "of the rays, and the truth is outside the bounds in {} of the queries.",
        cell.failures(), cell.queries, cell.not_numbers, cell.outside, cell.inaccurate, FAILED_ERROR,
        cell.mean, cell.percentile_99, cell.worst, cell.mean_from_truth, share(cell.floored, cell.rays),
        share(cell.clamped, cell.queries), share(cell.order_dependent, cell.rays),
        share(cell.non_monotone, cell.rays), share(cell.truth_outside, cell.queries));
}

std::string stress_title(const StressOptions& options) {
    const auto text = [&](ParameterId id) { return parameter_text(parameter(id), options.values[id]); };
    return fmt::format(
        "Share of queries that fail (not finite, outside [0, b₀], or T off by more than {}): solver {}, bias preset "
        "{}, β = {}, up to {} rays per cell, seed {}",
        FAILED_ERROR, text(ParameterId::solver), text(ParameterId::preset), text(ParameterId::beta),
        options.rays, options.seed);
}

std::string stress_to_csv(const std::vector<StressCell>& cells) {
    std::string text =
        "technique,condition,rays,queries,not_numbers,outside,off,failure_rate,floored,clamped,non_monotone,"
        "truth_outside,order_dependent,mean,percentile_99,worst,mean_from_truth,worst_ray\n";
    for (const StressCell& c : cells)
        text += fmt::format("{},{},{},{},{},{},{},{:.6g},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{}\n",
                            c.technique->id, c.condition->id, c.rays, c.queries, c.not_numbers, c.outside,
                            c.inaccurate, c.failure_rate(), c.floored, c.clamped, c.non_monotone,
                            c.truth_outside, c.order_dependent, c.mean, c.percentile_99, c.worst,
                            c.mean_from_truth, csv_quoted(ray_text(c.worst_case.ray)));
    return text;
}

RunTable stress_table(const std::vector<StressCell>& cells, const StressOptions& options) {
    constexpr int SCHEMA = 1;  // increases when columns or their meaning change
    const auto joined = [](const auto& rows) {
        std::string text;
        for (const auto* row : rows) text += fmt::format("{}{}", text.empty() ? "" : " ", row->id);
        return text;
    };
    std::string changed;
    for (const Parameter& row : parameters())
        if (options.values[row.id] != row.default_value)
            changed += fmt::format("{}{}={}", changed.empty() ? "" : " ", row.key,
                                   parameter_text(row, options.values[row.id]));
    RunTable table;
    table.settings = begin_settings("stress", SCHEMA, options.techniques.size() * options.conditions.size(),
                                    options.shard);
    table.settings.insert(table.settings.end(), {{"rays", fmt::format("{}", options.rays)},
                                                 {"seed", fmt::format("{}", options.seed)},
                                                 {"techniques", joined(options.techniques)},
                                                 {"conditions", joined(options.conditions)},
                                                 {"parameters", changed.empty() ? "standard" : changed}});
    const std::string text = stress_to_csv(cells);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        (begin == 0 ? table.columns : table.rows.emplace_back()) = text.substr(begin, end - begin);
        begin = end + 1;
    }
    return table;
}

std::string stress_to_html(const std::vector<StressCell>& cells, const StressOptions& options) {
    const std::size_t columns = options.conditions.size();
    std::string map = heading(cells, columns);
    std::string details;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const StressCell& cell = cells[i];
        if (i % columns == 0)
            map += fmt::format("<tr><th class=technique title=\"{}\">{}</th>",
                               markup_escaped(cell.technique->name), cell.technique->id);
        const glm::vec3 color = failure_color(cell.failure_rate());
        const bool dark = 0.3f * color.r + 0.6f * color.g + 0.1f * color.b < 0.5f;
        map += fmt::format("<td style=\"background:{};color:{}\" title=\"{}\"><a href=\"#c{}\">{}</a></td>",
                           css_color(color), dark ? "#fff" : "#111", markup_escaped(cell_sentence(cell)), i,
                           rate_text(cell.failure_rate()));
        if (i % columns == columns - 1) map += "</tr>\n";
        if (cell.failures() == 0) continue;
        details +=
            fmt::format("<li id=c{}><b>{}, {} {}</b>: {} {}<br><code>{}</code></li>\n", i, cell.technique->id,
                        markup_escaped(cell.condition->group), markup_escaped(cell.condition->name),
                        markup_escaped(cell.condition->help), markup_escaped(cell_sentence(cell)),
                        markup_escaped(ray_text(cell.worst_case.ray)));
    }
    const auto& files = page_files();
    return fmt::format(fmt::runtime(files.at("stress.html")), fmt::arg("style", files.at("stress.css")),
                       fmt::arg("title", stress_title(options)), fmt::arg("map", map),
                       fmt::arg("details", details.empty() ? "<li>None.</li>" : details));
}

std::string stress_to_text(const std::vector<StressCell>& cells) {
    std::string text = fmt::format("{:<11}{:>10}{:>10}{:>10}{:>10}{:>11}{:>11}  {}\n", "technique", "queries",
                                   "NaN", "outside", "off", "mean", "worst", "worst conditions");
    for (std::size_t begin = 0; begin < cells.size();) {
        std::size_t end = begin;
        StressCell sum;
        std::vector<const StressCell*> failing;
        for (; end < cells.size() && cells[end].technique == cells[begin].technique; ++end) {
            const StressCell& cell = cells[end];
            sum.queries += cell.queries;
            sum.not_numbers += cell.not_numbers;
            sum.outside += cell.outside;
            sum.inaccurate += cell.inaccurate;
            sum.mean += cell.mean * static_cast<double>(cell.queries);
            sum.worst = std::max(sum.worst, cell.worst);
            if (cell.failures() > 0) failing.push_back(&cell);
        }
        std::ranges::sort(failing, std::greater(), &StressCell::failure_rate);
        std::string worst;
        for (std::size_t i = 0; i < std::min<std::size_t>(failing.size(), 3); ++i)
            worst += fmt::format("{}{} {}", i == 0 ? "" : ", ", failing[i]->condition->id,
                                 rate_text(failing[i]->failure_rate()));
        text += fmt::format("{:<11}{:>10}{:>10}{:>10}{:>10}{:>11.1e}{:>11.1e}  {}\n",
                            cells[begin].technique->id, sum.queries, sum.not_numbers, sum.outside,
                            sum.inaccurate, sum.mean / static_cast<double>(std::max(sum.queries, 1L)),
                            sum.worst, worst.empty() ? "none fails" : worst);
        begin = end;
    }
    return text;
}

}  // namespace momentscope
