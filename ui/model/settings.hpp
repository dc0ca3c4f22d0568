// settings.hpp -- what the program remembers of its window, besides the state: it is kept for the next start,
// but is no part of a session.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ui/model/state.hpp"

namespace momentscope::ui {

constexpr float MIN_TEXT_SCALE = 0.5f, MAX_TEXT_SCALE = 4;

struct Settings {
    ThemeKind theme = ThemeKind::dark;
    float text_scale = 1;
    glm::ivec2 window{0, 0};  // its size in pixels; 0: as the command line says
    bool expert = true;       // are all parameters shown?
    bool moves = true;        // while presenting, do states move into each other?
    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Those of somebody who has never used the program.
inline constexpr Settings NEW_USER = {.expert = false};

/// Parameters that the window shows only to experts.
inline constexpr std::array EXPERT_PARAMETERS = {
    ParameterId::preset,   ParameterId::solver,     ParameterId::factorisation, ParameterId::accumulation,
    ParameterId::estimate, ParameterId::ends,       ParameterId::interval,      ParameterId::renormalize,
    ParameterId::order,    ParameterId::order_seed, ParameterId::tone_map};

constexpr std::uintmax_t MAX_SETTINGS_BYTES = 64U << 10;

nlohmann::ordered_json settings_to_json(const Settings& settings);

/// Throws Error if the text does not hold settings. Missing keys are standard.
Settings settings_from_json(const std::string& text);

}  // namespace momentscope::ui
