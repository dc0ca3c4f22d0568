#include "ui/model/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/ray/ray_json.hpp"
#include "core/support/bounded_json.hpp"
#include "core/support/error.hpp"
#include "ui/model/json_reader.hpp"
#include "ui/model/series.hpp"

namespace momentscope::ui {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* COMPARE_MODES[] = {"off", "wipe", "difference", "false_color", "uncertainty"};
constexpr const char* LENS_ZOOMS[] = {"far", "near", "values", "digits"};
constexpr const char* QUANTITIES[] = {"absorbance", "transmittance"};
constexpr const char* AXES[] = {"warped", "view"};
constexpr const char* VIEWPOINTS[] = {"eye", "transparent_casters", "opaque_casters"};
constexpr const char* THEMES[] = {"dark", "light"};

ordered_json pair_json(const glm::vec2& v) {
    return {v.x, v.y};
}
ordered_json range_json(const std::optional<Range>& range) {
    return range ? ordered_json{range->low, range->high} : ordered_json();
}
ordered_json camera_json(const std::optional<Camera>& camera) {
    if (!camera) return nullptr;
    return {{"target", {camera->target.x, camera->target.y, camera->target.z}},
            {"distance", camera->distance},
            {"azimuth", camera->azimuth},
            {"elevation", camera->elevation},
            {"field_of_view", camera->field_of_view}};
}

ordered_json plot_json(const PlotState& plot) {
    ordered_json shown = ordered_json::object();
    for (std::size_t i = 0; i < SERIES_COUNT; ++i) shown[series_rows()[i].key] = plot.shown[i];
    return {{"quantity", QUANTITIES[static_cast<std::size_t>(plot.quantity)]},
            {"depth_axis", AXES[static_cast<std::size_t>(plot.axis)]},
            {"shown", shown},
            {"depth_range", range_json(plot.depth)},
            {"value_range", range_json(plot.value)},
            {"query", plot.query ? ordered_json(*plot.query) : ordered_json()}};
}

ordered_json parameters_json(const ParameterValues& values) {
    ordered_json result = ordered_json::object();
    for (const Parameter& row : parameters())
        result[row.key] = values[row.id] && row.choices.empty()
                              ? ordered_json(*values[row.id])
                              : ordered_json(parameter_text(row, values[row.id]));
    return result;
}

ordered_json compare_json(const CompareState& compare) {
    const auto& region = compare.region;
    return {{"reference", compare.reference->id},
            {"mode", COMPARE_MODES[static_cast<std::size_t>(compare.mode)]},
            {"metric", metrics()[static_cast<std::size_t>(compare.metric)].key},
            {"gain", compare.gain},
            {"divider", compare.divider},
            {"swapped", compare.swapped},
            {"region", region ? ordered_json{region->low.x, region->low.y, region->high.x, region->high.y}
                              : ordered_json()}};
}

constexpr float FAR = 1e6f;  // beyond any scene and any absorbance

std::optional<Range> range_from(JsonReader& reader, const char* key) {
    const json* found = reader.find(key);
    if (found == nullptr || found->is_null()) return std::nullopt;
    const auto ends = reader.numbers(*found, key, 2, -FAR, FAR);
    if (!(ends[0] < ends[1])) reader.fail(key, "a range whose first number is the smaller one");
    return Range{ends[0], ends[1]};
}

const Technique& technique_from(const JsonReader& reader, const json& id, const char* key) {
    if (!id.is_string()) reader.fail(key, "the id of a technique");
    return require_technique(id.get<std::string>());
}

void read_parameters(const json& object, ParameterValues& values, std::vector<std::string>& ignored) {
    JsonReader reader(object, "parameters.", ignored);
    for (const Parameter& row : parameters()) {
        const json* found = reader.find(row.key);
        if (found == nullptr) continue;
        if (found->is_string())
            values.set(row.id, parse_parameter(row, found->get<std::string>()));
        else if (found->is_number())
            values.set(row.id, found->get<float>());
        else
            reader.fail(row.key, "a number");
    }
}

void read_plot(const json& object, PlotState& plot, std::vector<std::string>& ignored) {
    JsonReader reader(object, "plot.", ignored);
    reader.choice("quantity", plot.quantity, QUANTITIES);
    reader.choice("depth_axis", plot.axis, AXES);
    if (const json* found = reader.find("shown")) {
        JsonReader shown(*found, "plot.shown.", ignored);
        for (std::size_t i = 0; i < SERIES_COUNT; ++i) shown.flag(series_rows()[i].key, plot.shown[i]);
    }
    plot.depth = range_from(reader, "depth_range");
    plot.value = range_from(reader, "value_range");
    if (const json* found = reader.find("query"); found != nullptr && !found->is_null())
        reader.number("query", plot.query.emplace(), -1, 1);
}

std::optional<Camera> camera_from(const json& object, std::vector<std::string>& ignored) {
    if (object.is_null()) return std::nullopt;
    Camera camera;
    JsonReader reader(object, "camera.", ignored);
    if (const json* found = reader.find("target")) {
        const auto target = reader.numbers(*found, "target", 3, -FAR, FAR);
        camera.target = {target[0], target[1], target[2]};
    }
    reader.number("distance", camera.distance, 0.01f, 10'000);
    reader.number("azimuth", camera.azimuth, -FAR, FAR);
    reader.number("elevation", camera.elevation, -1.57f, 1.57f);
    reader.number("field_of_view", camera.field_of_view, 0.01f, 3);
    return camera;
}

void read_count(JsonReader& reader, const char* key, const char* what, std::optional<std::size_t>& index) {
    const json* found = reader.find(key);
    if (found == nullptr || found->is_null()) return;
    if (!found->is_number_unsigned()) reader.fail(key, what);
    index = found->get<std::size_t>();
}

void read_places(JsonReader& reader, ExplorerState& state) {
    if (const json* found = reader.find("picked"); found != nullptr && !found->is_null()) {
        const auto place = reader.numbers(*found, "picked", 2, 0, 1);
        state.picked = glm::vec2(place[0], place[1]);
    }
    if (const json* found = reader.find("pins")) {
        if (!found->is_array() || found->size() > MAX_PINS)
            reader.fail("pins", fmt::format("a list of at most {} places", MAX_PINS));
        for (const json& entry : *found) {
            const auto place = reader.numbers(entry, "pins", 2, 0, 1);
            state.pins.emplace_back(place[0], place[1]);
        }
    }
    read_count(reader, "marked", "null or the number of a fragment", state.marked);
    reader.choice("viewpoint", state.viewpoint, VIEWPOINTS);
    read_count(reader, "receiver", "null or the number of a fragment", state.receiver);
}

void read_compare(const json& object, CompareState& compare, std::vector<std::string>& ignored) {
    JsonReader reader(object, "compare.", ignored);
    if (const json* found = reader.find("reference"))
        compare.reference = &technique_from(reader, *found, "reference");
    reader.choice("mode", compare.mode, COMPARE_MODES);
    std::string metric = metrics()[static_cast<std::size_t>(compare.metric)].key;
    reader.text("metric", metric);
    compare.metric = require_metric(metric).id;
    reader.number("gain", compare.gain, MIN_GAIN, MAX_GAIN);
    reader.number("divider", compare.divider, MIN_DIVIDER, MAX_DIVIDER);
    reader.flag("swapped", compare.swapped);
    if (const json* found = reader.find("region"); found != nullptr && !found->is_null()) {
        const auto ends = reader.numbers(*found, "region", 4, 0, 1);
        if (!(ends[0] < ends[2] && ends[1] < ends[3]))
            reader.fail("region", "left, top, right and bottom of a rectangle");
        compare.region = {glm::vec2(ends[0], ends[1]), glm::vec2(ends[2], ends[3])};
    }
}

void read_techniques(JsonReader& reader, ExplorerState& state) {
    if (const json* found = reader.find("technique"))
        state.technique = &technique_from(reader, *found, "technique");
    if (const json* found = reader.find("compared")) {
        if (!found->is_array() || found->size() > techniques().size())
            reader.fail("compared", "a list of ids of techniques");
        for (const json& entry : *found) state.compared.push_back(&technique_from(reader, entry, "compared"));
    }
}

void read_panel(JsonReader& reader, Panel& panel) {
    std::array<const char*, PANELS.size()> keys{};
    std::ranges::transform(PANELS, keys.begin(), &PanelRow::key);
    reader.choice("panel", panel, keys);
}

json parse(const std::string& text) {
    try {
        return parse_bounded_json(text, {.bytes = MAX_SESSION_BYTES});
    } catch (const Error& error) {
        throw Error(fmt::format("The session cannot be read: {}", error.what()));
    }
}

}  // namespace

ordered_json session_to_json(const ExplorerState& state) {
    ordered_json compared = ordered_json::array();
    for (const Technique* technique : state.compared) compared.push_back(technique->id);
    ordered_json pins = ordered_json::array();
    for (const glm::vec2& pin : state.pins) pins.push_back(pair_json(pin));
    return {{"momentscope_session", SESSION_VERSION},
            {"scene", state.scene},
            {"ray", state.ray ? ordered_json(ray_to_json(*state.ray)) : ordered_json()},
            {"technique", state.technique->id},
            {"compared", compared},
            {"parameters", parameters_json(state.parameters)},
            {"viewpoint", VIEWPOINTS[static_cast<std::size_t>(state.viewpoint)]},
            {"receiver", state.receiver ? ordered_json(*state.receiver) : ordered_json()},
            {"compare", compare_json(state.compare)},
            {"camera", camera_json(state.camera)},
            {"picked", state.picked ? pair_json(*state.picked) : ordered_json()},
            {"pins", pins},
            {"marked", state.marked ? ordered_json(*state.marked) : ordered_json()},
            {"plot", plot_json(state.plot)},
            {"panel", PANELS[static_cast<std::size_t>(state.panel)].key},
            {"lens", state.lens},
            {"lens_zoom", LENS_ZOOMS[static_cast<std::size_t>(state.lens_zoom)]},
            {"failures", state.failures},
            {"card", state.card},
            {"step", state.step},
            {"hint", state.hint},
            {"answer", state.answer},
            {"theme", THEMES[static_cast<std::size_t>(state.theme)]},
            {"scene_share", state.scene_share},
            {"plot_share", state.plot_share}};
}

std::optional<json> session_value(const ExplorerState& state, const std::string& pointer) {
    try {
        const json session(session_to_json(state));
        const json::json_pointer place(pointer);
        return session.contains(place) ? std::optional(session[place]) : std::nullopt;
    } catch (const json::exception&) {  // it is not a pointer
        return std::nullopt;
    }
}

Session session_from_json(const std::string& text) {
    const json root = parse(text);
    Session session;
    ExplorerState& state = session.state;
    JsonReader reader(root, "", session.ignored);
    const json* version = reader.find("momentscope_session");
    if (version == nullptr || !version->is_number_integer())
        throw Error("This file is not a session of Momentscope; choose one that Momentscope saved.");
    if (version->get<long long>() != SESSION_VERSION)
        throw Error(fmt::format(
            "This session has version {}, but this Momentscope reads version {}; open it with the "
            "Momentscope that saved it.",
            version->get<long long>(), SESSION_VERSION));
    reader.text("scene", state.scene);
    if (const json* ray = reader.find("ray"); ray != nullptr && !ray->is_null())
        state.ray = ray_from_value(*ray);
    read_techniques(reader, state);
    if (const json* found = reader.find("parameters"))
        read_parameters(*found, state.parameters, session.ignored);
    if (const json* found = reader.find("compare")) read_compare(*found, state.compare, session.ignored);
    if (const json* found = reader.find("camera")) state.camera = camera_from(*found, session.ignored);
    read_places(reader, state);
    if (const json* found = reader.find("plot")) read_plot(*found, state.plot, session.ignored);
    read_panel(reader, state.panel);
    reader.flag("lens", state.lens);
    reader.choice("lens_zoom", state.lens_zoom, LENS_ZOOMS);
    reader.flag("failures", state.failures);
    reader.text("card", state.card);
    std::optional<std::size_t> step;
    read_count(reader, "step", "the number of a step", step);
    state.step = step.value_or(0);
    reader.flag("hint", state.hint);
    reader.flag("answer", state.answer);
    reader.choice("theme", state.theme, THEMES);
    reader.number("scene_share", state.scene_share, 0.2f, 0.8f);
    reader.number("plot_share", state.plot_share, 0.2f, 0.8f);
    return session;
}

}  // namespace momentscope::ui
