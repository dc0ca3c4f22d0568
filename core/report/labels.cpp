#include "core/report/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace momentscope {

namespace {

constexpr float GAP = 13;        // between a point and its label
constexpr float MARK_SIZE = 16;  // about a point; its own mark may be there
constexpr std::array DISTANCES = {GAP, 20.0f, 30.0f, 44.0f, 62.0f, 84.0f, 110.0f};
constexpr int DIRECTIONS = 16;
const glm::vec3 LEADER(0.62f, 0.65f, 0.69f);

bool is_free(const Box& box, const std::vector<Box>& taken) {
    return std::ranges::none_of(taken, [&](const Box& other) { return box.overlaps(other); });
}

// True if a line from a point to its label crosses no box. The point itself does not count.
bool is_free_line(glm::vec2 from, glm::vec2 to, const std::vector<Box>& taken) {
    const float length = glm::length(to - from);
    constexpr float STEP = 3;
    const int steps = static_cast<int>(std::ceil((length - MARK_SIZE) / STEP));
    for (int i = 0; i < steps; ++i) {
        const glm::vec2 at = glm::mix(from, to, (MARK_SIZE + STEP * static_cast<float>(i)) / length);
        if (!is_free({at - 0.5f, at + 0.5f}, taken)) return false;
    }
    return true;
}

// The box of a label in a direction from a point; its nearest edge is at this distance. To the left or right,
// the text ends or begins there.
Box box_at(const glm::vec2& point, const glm::vec2& extent, float angle, float distance) {
    const glm::vec2 direction(std::cos(angle), std::sin(angle));
    const glm::vec2 anchor = point + distance * direction;
    const float share = 0.5f - 0.5f * std::clamp(direction.x * 2.0f, -1.0f, 1.0f);
    const glm::vec2 low(anchor.x - share * extent.x, anchor.y + 0.5f * (direction.y - 1) * extent.y);
    return {low, low + extent};
}

struct Place {
    Box box;
    bool far;
};

std::optional<Place> find_place(const Label& label, const glm::vec2& extent, const std::vector<Box>& taken,
                                const Box& bounds) {
    for (const float distance : DISTANCES)
        for (int i = 0; i < DIRECTIONS; ++i) {
            // To the right first, then alternately above and below.
            const int step = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
            const float angle =
                2 * std::numbers::pi_v<float> * static_cast<float>(step) / static_cast<float>(DIRECTIONS);
            const Box box = box_at(label.at, extent, angle, distance);
            const bool inside = box.low.x >= bounds.low.x && box.low.y >= bounds.low.y &&
                                box.high.x <= bounds.high.x && box.high.y <= bounds.high.y;
            const glm::vec2 end = glm::clamp(label.at, box.low, box.high);
            if (inside && is_free(box, taken) && is_free_line(label.at, end, taken))
                return Place{box, distance > GAP};
        }
    return std::nullopt;
}

}  // namespace

void place_labels(Drawing& drawing, const std::vector<Label>& labels, std::vector<Box> taken,
                  const Box& bounds, float size) {
    for (const Label& label : labels) {
        const glm::vec2 extent(text_width(label.text, size) * (label.bold ? 1.12f : 1.0f), 1.15f * size);
        const auto place = find_place(label, extent, taken, bounds);
        if (!place) continue;
        if (place->far)
            drawing.lines.push_back(
                {{label.at, glm::clamp(label.at, place->box.low, place->box.high)}, LEADER, 0.8f});
        drawing.texts.push_back({{place->box.low.x, 0.5f * (place->box.low.y + place->box.high.y)},
                                 label.text,
                                 size,
                                 label.color,
                                 label.bold});
        taken.push_back(place->box);
    }
}

}  // namespace momentscope
