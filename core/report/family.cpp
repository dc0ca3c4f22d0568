#include "core/report/family.hpp"

#include <algorithm>

namespace momentscope {

namespace {

constexpr glm::vec3 rgb(unsigned hex) {
    return {static_cast<float>(hex >> 16 & 0xFF) / 255, static_cast<float>(hex >> 8 & 0xFF) / 255,
            static_cast<float>(hex & 0xFF) / 255};
}

bool has_interval(const Technique& technique, MomentInterval interval) {
    return technique.has_moments() && technique.moments().estimation &&
           technique.moments().estimation->interval == interval;
}

const Family ROWS[] = {
    {"moments and ends", rgb(0x5B3FB5), MarkShape::triangle_right,
     [](const Technique& t) { return has_interval(t, MomentInterval::scene); }},
    {"moments of the own interval", rgb(0x5B3FB5), MarkShape::triangle_left,
     [](const Technique& t) { return has_interval(t, MomentInterval::pixel); }},
    {"power moments", rgb(0x0072B2), MarkShape::circle,
     [](const Technique& t) { return t.is_of(BasisFamily::power); }},
    {"trigonometric moments", rgb(0xD55E00), MarkShape::square,
     [](const Technique& t) { return t.is_of(BasisFamily::trigonometric); }},
    {"Chebyshev moments", rgb(0x009E73), MarkShape::diamond,
     [](const Technique& t) { return t.is_of(BasisFamily::chebyshev); }},
    {"Moment Transparency", rgb(0xA84C80), MarkShape::triangle_up,
     [](const Technique& t) {
         return t.has_pixel_states() && t.pixel_state_kernel().accumulate_second_pass != nullptr;
     }},
    {"ground truth", rgb(0x16181C), MarkShape::cross, [](const Technique& t) { return t.is_truth(); }},
    {"in order, bounded memory", rgb(0x8A6D00), MarkShape::triangle_down,
     [](const Technique& t) { return needs_order(t); }},
    {"other functions of depth", rgb(0x2E8FC9), MarkShape::bar,
     [](const Technique& t) { return t.has_pixel_states() && !t.pixel_state_kernel().holds_colors; }},
    {"one pass", rgb(0x6B7280), MarkShape::pillar, [](const Technique&) { return true; }},
};

}  // namespace

std::span<const Family> families() {
    return ROWS;
}

const Family& family_of(const Technique& technique) {
    return *std::ranges::find_if(ROWS, [&](const Family& family) { return family.holds(technique); });
}

}  // namespace momentscope
