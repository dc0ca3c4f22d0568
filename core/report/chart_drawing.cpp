#include "core/report/chart_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/report/family.hpp"
#include "core/report/labels.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

namespace {

const glm::vec2 MIN_SIZE(300, 180);
constexpr float LEFT = 76, RIGHT = 16, BOTTOM = 56;  // margins of the plot
constexpr float CLOSE_BOTTOM = 42;                   // without a title
constexpr float LEGEND_LINE = 20, LEGEND_TOP = 14;   // without a title
constexpr float STRIP = 30;                          // at the bottom, for errors too small for the axis
constexpr float RADIUS = 5;
constexpr float FONT = 11, AXIS_FONT = 12, TITLE_FONT = 17;
constexpr double MAX_ERROR = 1e30;  // greatest error of an axis and its ticks
constexpr double MIN_SHARE = 4e-3;  // share of the greatest error; smaller errors go to the strip
const glm::vec3 TEXT(0.13f, 0.15f, 0.18f), WEAK(0.42f, 0.45f, 0.50f), GRID(0.90f, 0.91f, 0.93f),
    AXIS(0.55f, 0.58f, 0.62f), FRONT(0.13f, 0.15f, 0.18f);

/// Maps a value to a coordinate by its logarithm.
struct LogAxis {
    double least, most;
    float from, to;
    float at(double value) const {
        const double share = std::log(value / least) / std::log(most / least);
        return from + static_cast<float>(share) * (to - from);
    }
};

struct Point {
    std::size_t row;
    glm::vec2 at;
    const Family* family;
    bool all_default;  // all parameters have their default values
};

/// 1, 2 and 5 times the powers of ten within a range; for more than three decades only the powers. None if an
/// end of the range has no logarithm.
std::vector<double> ticks_of(double least, double most) {
    std::vector<double> ticks;
    if (!(least > 0 && std::isfinite(least) && std::isfinite(most))) return ticks;
    const bool wide = most / least > 1000;
    const int last = static_cast<int>(std::floor(std::log10(most)));
    for (int decade = static_cast<int>(std::floor(std::log10(least))); decade <= last; ++decade)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double tick = std::pow(10, decade) * factor;
            if (tick >= least * 0.999 && tick <= most * 1.001 && (factor < 1.5 || !wide))
                ticks.push_back(tick);
        }
    return ticks;
}

/// The time at which a row is drawn: at least 1e-3, so that it has a logarithm.
double drawn_time(const ChartRow& row) {
    return std::max(row.numbers->total.median, 1e-3);
}

/// Rows without a place on the axes are not drawn.
bool is_drawn(const ChartRow& row, Metric metric) {
    return row.numbers && std::isfinite(row.numbers->total.median) &&
           std::isfinite(error_of(*row.numbers, metric));
}

const Family& family_of_row(const ChartRow& row) {
    const std::string& text = row.configuration;
    const Technique* technique = find_technique(std::string_view(text).substr(0, text.find(':')));
    return technique != nullptr ? family_of(*technique) : families().back();
}

class Plot {
public:
    Plot(std::span<const ChartRow> rows, Metric metric, const ChartLayout& layout)
        : rows_(rows), metric_(metric), title_(layout.title), size_(glm::max(layout.size, MIN_SIZE)) {
        plot_ = {{LEFT, 0}, {size_.x - RIGHT, size_.y - (title_ ? BOTTOM : CLOSE_BOTTOM)}};
        std::vector<double> times, errors;
        for (const ChartRow& row : rows) {
            if (!is_drawn(row, metric)) continue;
            times.push_back(drawn_time(row));
            errors.push_back(std::min(error_of(*row.numbers, metric), MAX_ERROR));
        }
        if (times.empty()) return;
        double most = 1e-6;
        for (const double error : errors) most = std::max(most, error);
        double least = most;
        for (const double error : errors)
            if (error >= most * MIN_SHARE) least = std::min(least, error);
        const auto [shortest, longest] = std::ranges::minmax(times);
        plot_.low.y = (layout.legend ? draw_legend() : LEGEND_TOP - LEGEND_LINE) + 36;
        time_ = {0.8 * shortest, 1.3 * longest, plot_.low.x, plot_.high.x};
        error_ = {0.75 * least, 1.3 * most, plot_.high.y - STRIP, plot_.low.y};
        for (std::size_t i = 0; i < rows.size(); ++i) add_point(i);
    }

    Drawing draw(const std::string& times) {
        drawing_.size = size_;
        draw_titles(times);
        if (points_.empty()) {
            drawing_.texts.push_back(
                {{plot_.low.x + 20, plot_.low.y + 40}, "Nothing could be drawn here.", AXIS_FONT, TEXT});
            return drawing_;
        }
        draw_axes();
        draw_unsorted();
        draw_front();
        for (const Point& point : points_)
            drawing_.marks.push_back({point.at, point.family->shape, point.family->color, RADIUS, point.row});
        draw_labels();
        return drawing_;
    }

private:
    void add_point(std::size_t i) {
        if (!is_drawn(rows_[i], metric_)) return;
        const double error = error_of(*rows_[i].numbers, metric_);
        const double shown = error < error_.most ? error : error_.most;  // at the top if infinite or NaN
        const float y = shown < error_.least ? plot_.high.y - 0.5f * STRIP : error_.at(shown);
        const std::string& text = rows_[i].configuration;
        points_.push_back({i,
                           {time_.at(drawn_time(rows_[i])), y},
                           &family_of_row(rows_[i]),
                           text.find(':') == std::string::npos});
    }

    const Point* point_of(std::size_t row) const {
        const auto found = std::ranges::find(points_, row, &Point::row);
        return found == points_.end() ? nullptr : &*found;
    }

    void add_line(std::vector<glm::vec2> points, const glm::vec3& color, float width, bool dashed = false) {
        drawing_.lines.push_back({std::move(points), color, width, dashed});
    }

    void draw_titles(const std::string& times) {
        const MetricRow& metric = metrics()[static_cast<std::size_t>(metric_)];
        const std::string scene = rows_.empty() ? "" : rows_.front().scene;
        if (title_)
            drawing_.texts.push_back(
                {{16, 24}, fmt::format("Speed against accuracy: {}", scene), TITLE_FONT, TEXT, true});
        drawing_.texts.push_back(
            {{16, plot_.low.y - 12}, fmt::format("{} against sorted", metric.symbol), AXIS_FONT, TEXT, true});
        const std::string axis =
            fmt::format("total time of the transparent passes [ms]{}{}", times.empty() ? "" : ", ", times);
        drawing_.texts.push_back(
            {{plot_.high.x - text_width(axis, AXIS_FONT) * 1.1f, size_.y - 14}, axis, AXIS_FONT, TEXT, true});
    }

    void draw_axes() {
        for (const double tick : ticks_of(time_.least, time_.most)) {
            const float x = time_.at(tick);
            add_line({{x, plot_.low.y}, {x, plot_.high.y}}, GRID, 1);
            const std::string text = fmt::format("{:g}", tick);
            drawing_.texts.push_back(
                {{x - 0.45f * text_width(text, AXIS_FONT), plot_.high.y + 14}, text, AXIS_FONT, WEAK});
        }
        for (const double tick : ticks_of(error_.least, error_.most)) {
            const float y = error_.at(tick);
            add_line({{plot_.low.x, y}, {plot_.high.x, y}}, GRID, 1);
            right_aligned(fmt::format("{:g}", tick), y);
        }
        add_line({{plot_.low.x, plot_.high.y - STRIP}, {plot_.high.x, plot_.high.y - STRIP}}, AXIS, 1);
        add_line({{plot_.low.x, plot_.low.y}, {plot_.low.x, plot_.high.y}, plot_.high}, AXIS, 1);
        right_aligned(fmt::format("< {:.1g}", error_.least), plot_.high.y - 0.5f * STRIP);
    }

    void right_aligned(const std::string& text, float y) {
        drawing_.texts.push_back({{plot_.low.x - 6 - text_width(text, AXIS_FONT), y}, text, AXIS_FONT, WEAK});
    }

    void draw_unsorted() {
        const auto row = std::ranges::find(rows_, "unsorted", &ChartRow::configuration);
        if (row == rows_.end() || !is_drawn(*row, metric_)) return;
        const float x = time_.at(drawn_time(*row));
        add_line({{x, plot_.low.y}, {x, plot_.high.y}}, AXIS, 1.2f, true);
        taken_.push_back({{x - 1, plot_.low.y}, {x + 1, plot_.high.y}});
    }

    // Draws the Pareto front as a staircase behind the marks. No measured row lies to its lower left.
    void draw_front() {
        std::vector<glm::vec2> stairs;
        for (const std::size_t row : front_of(rows_, metric_)) {
            const glm::vec2 at = point_of(row)->at;
            if (!stairs.empty()) stairs.emplace_back(at.x, stairs.back().y);
            stairs.push_back(at);
            drawing_.marks.push_back({at, MarkShape::ring, FRONT, RADIUS + 4, Drawing::NO_ROW});
            taken_.push_back({at - (RADIUS + 4), at + (RADIUS + 4)});
        }
        for (std::size_t i = 1; i < stairs.size(); ++i)
            taken_.push_back(
                {glm::min(stairs[i - 1], stairs[i]) - 1.0f, glm::max(stairs[i - 1], stairs[i]) + 1.0f});
        if (!stairs.empty()) add_line(stairs, FRONT, 1.6f);
    }

    // Draws the legend in lines as wide as the drawing. Returns the height of the last line.
    float draw_legend() {
        glm::vec2 at(16, title_ ? 48 : LEGEND_TOP);
        const auto name = [&](const char* text) {
            drawing_.texts.push_back({at + glm::vec2(18, 0), text, FONT, TEXT});
            at.x += 18 + text_width(text, FONT) + 12;
        };
        const auto make_room = [&](const char* text) {
            if (at.x + 18 + text_width(text, FONT) > size_.x) at = {16, at.y + LEGEND_LINE};
        };
        for (const Family& family : families()) {
            const auto is_of = [&](const ChartRow& row) {
                return row.numbers && &family_of_row(row) == &family;
            };
            if (std::ranges::none_of(rows_, is_of)) continue;
            make_room(family.name);
            drawing_.marks.push_back(
                {at + glm::vec2(6, 0), family.shape, family.color, RADIUS, Drawing::NO_ROW});
            name(family.name);
        }
        make_room("Pareto front");
        drawing_.marks.push_back({at + glm::vec2(6, 0), MarkShape::ring, FRONT, RADIUS + 2, Drawing::NO_ROW});
        name("Pareto front");
        make_room("time of unsorted");
        add_line({at - glm::vec2(2, 0), at + glm::vec2(14, 0)}, AXIS, 1.2f, true);
        name("time of unsorted");
        return at.y;
    }

    // Labels rows of the front first, then techniques with default values, then their variants.
    void draw_labels() {
        const std::vector<std::size_t> front = front_of(rows_, metric_);
        std::vector<Label> labels;
        for (const Point& point : points_) taken_.push_back({point.at - RADIUS, point.at + RADIUS});
        for (int rank = 0; rank < 3; ++rank)
            for (const Point& point : points_) {
                const bool on_front = std::ranges::find(front, point.row) != front.end();
                if (rank == (on_front ? 0 : point.all_default ? 1 : 2))
                    labels.push_back({point.at, short_name(rows_[point.row].configuration),
                                      0.85f * point.family->color, on_front});
            }
        place_labels(drawing_, labels, taken_, {plot_.low + 2.0f, plot_.high - 2.0f}, FONT);
    }

    std::span<const ChartRow> rows_;
    Metric metric_;
    bool title_;
    glm::vec2 size_;
    Box plot_;
    LogAxis time_{}, error_{};
    std::vector<Point> points_;
    std::vector<Box> taken_;  // places without labels
    Drawing drawing_;
};

}  // namespace

Drawing chart_drawing(std::span<const ChartRow> rows, Metric metric, const std::string& times,
                      const ChartLayout& layout) {
    return Plot(rows, metric, layout).draw(times);
}

}  // namespace momentscope
