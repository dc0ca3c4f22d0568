#include "core/ray/ray_json.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/support/bounded_json.hpp"
#include "core/support/error.hpp"
#include "core/support/input_file.hpp"

namespace momentscope {

namespace {

using nlohmann::json;

json parse_ray(const std::string& text) {
    try {
        return parse_bounded_json(text, {.bytes = MAX_RAY_FILE_BYTES});
    } catch (const Error& error) {
        throw Error(fmt::format("The view ray cannot be read: {}", error.what()));
    }
}

float number(const json& object, const char* key, const std::string& where) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number())
        throw Error(fmt::format("The view ray's {} needs a number \"{}\".", where, key));
    const auto value = found->get<double>();
    if (!std::isfinite(static_cast<float>(value)))
        throw Error(fmt::format("The view ray's {} has a \"{}\" that is not a finite number.", where, key));
    return static_cast<float>(value);
}

// Without this check, a misspelt key would be ignored silently.
void require_known_keys(const json& object, std::initializer_list<std::string_view> known,
                        const std::string& where) {
    for (const auto& [key, value] : object.items()) {
        if (std::ranges::find(known, key) != known.end()) continue;
        std::string keys;
        for (const std::string_view one : known)
            keys += fmt::format("{}\"{}\"", keys.empty() ? "" : ", ", one);
        throw Error(
            fmt::format("The view ray's {} has a \"{}\", which means nothing; use {}.", where, key, keys));
    }
}

// If the ratio of the depths is less than 1.0001, their logarithms are the same float.
bool is_depth_range(float low, float high) {
    return low >= 1e-30f && high >= 1.0001f * low;
}

DepthWarp warp_from(const json& root) {
    DepthWarp warp;
    const auto found = root.find("warp");
    if (found == root.end() || found->is_null()) return warp;
    if (!found->is_object() || !found->contains("kind") || !(*found)["kind"].is_string())
        throw Error("The view ray's warp needs a \"kind\": \"none\", \"log\" or \"linear\".");
    const auto kind = (*found)["kind"].get<std::string>();
    if (kind == "none") {
        require_known_keys(*found, {"kind"}, "warp of the kind none");
        return warp;
    }
    if (kind != "log" && kind != "linear")
        throw Error(
            fmt::format("The view ray's warp kind is '{}'; use \"none\", \"log\" or \"linear\".", kind));
    require_known_keys(*found, {"kind", "z_min", "z_max"}, "warp");
    warp = {kind == "log" ? DepthWarp::Kind::logarithmic : DepthWarp::Kind::linear,
            number(*found, "z_min", "warp"), number(*found, "z_max", "warp")};
    if (!is_depth_range(warp.z_min, warp.z_max))
        throw Error(
            "The view ray's warp needs a z_min above 0 (1e-30 at least), and a z_max of at least 1.0001 z_min.");
    return warp;
}

glm::vec3 color_from(const json& entry, const std::string& where) {
    const auto found = entry.find("color");
    if (found == entry.end()) return glm::vec3(1);
    glm::vec3 color;
    const bool triple = found->is_array() && found->size() == 3;
    for (int c = 0; c < 3; ++c) {
        const double value = triple && (*found)[static_cast<std::size_t>(c)].is_number()
                                 ? (*found)[static_cast<std::size_t>(c)].get<double>()
                                 : -1.0;
        if (!(value >= 0 && value <= 65504))
            throw Error(
                fmt::format("The view ray's {} needs a \"color\" of three numbers from 0 to 65504.", where));
        color[c] = static_cast<float>(value);
    }
    return color;
}

std::uint32_t seed_from(const json& entry, std::uint32_t default_value, const std::string& where) {
    const auto found = entry.find("seed");
    if (found == entry.end()) return default_value;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > 0xffffffffU)
        throw Error(
            fmt::format("The view ray's {} needs a \"seed\" that is a whole number below 2^32.", where));
    return found->get<std::uint32_t>();
}

Fragment fragment_from(const json& entry, std::size_t index, const DepthWarp& warp) {
    const std::string where = fmt::format("fragment {}", index);
    if (!entry.is_object()) throw Error(fmt::format("The view ray's {} must be an object.", where));
    require_known_keys(entry, {"depth", "opacity", "color", "seed", "threshold"}, where);
    Fragment fragment;
    fragment.view_depth = number(entry, "depth", where);
    if (const auto opacity = entry.find("opacity"); opacity != entry.end() && opacity->is_array())
        throw Error(fmt::format(
            "The view ray's {} has a list as \"opacity\"; give one number, the same for all colours.",
            where));
    fragment.opacity = number(entry, "opacity", where);
    fragment.color = color_from(entry, where);
    fragment.draw = static_cast<std::uint32_t>(index);
    fragment.seed = seed_from(entry, fragment_seed(0, fragment.draw, 0), where);
    fragment.threshold =
        entry.contains("threshold") ? number(entry, "threshold", where) : unit_random(fragment.seed, 0);
    if (!(fragment.threshold >= 0 && fragment.threshold <= 1))
        throw Error(fmt::format("The view ray's {} has threshold {}; give one from 0 to 1.", where,
                                fragment.threshold));
    if (!(fragment.opacity >= 0 && fragment.opacity <= 1))
        throw Error(
            fmt::format("The view ray's {} has opacity {}; give one from 0 to 1.", where, fragment.opacity));
    const float low = warp.has_view_depths() ? warp.z_min : -1.0f;
    const float high = warp.has_view_depths() ? warp.z_max : 1.0f;
    if (!(fragment.view_depth >= low && fragment.view_depth <= high))
        throw Error(fmt::format("The view ray's {} has depth {}; give one from {} to {}.", where,
                                fragment.view_depth, low, high));
    fragment.depth = to_depth(fragment.view_depth, warp);
    return fragment;
}

std::vector<Fragment> fragments_from(const json& entries, const DepthWarp& warp) {
    if (entries.size() > MAX_RAY_FRAGMENTS)
        throw Error(fmt::format("The view ray has {} fragments; at most {} are read.", entries.size(),
                                MAX_RAY_FRAGMENTS));
    std::vector<Fragment> fragments;
    for (std::size_t i = 0; i < entries.size(); ++i) fragments.push_back(fragment_from(entries[i], i, warp));
    return fragments;
}

constexpr std::size_t MAX_SHARES = 16;

std::vector<LowResolutionSource> shares_from(const json& root, const DepthWarp& warp) {
    const auto found = root.find("shares");
    if (found == root.end()) return {};
    const auto good = [](const json& entry) {
        return entry.is_object() && entry.contains("fragments") && entry["fragments"].is_array();
    };
    if (!found->is_array() || found->size() > MAX_SHARES || !std::ranges::all_of(*found, good))
        throw Error(fmt::format(
            "The view ray's \"shares\" must be a list of at most {} objects, each with a \"weight\" and "
            "\"fragments\".",
            MAX_SHARES));
    std::vector<LowResolutionSource> shares;
    for (const json& entry : *found) {
        require_known_keys(entry, {"weight", "fragments"}, "share");
        const float weight = number(entry, "weight", "share");
        if (!(weight >= 0 && weight <= 1))
            throw Error(fmt::format("A share of the view ray has weight {}; give one from 0 to 1.", weight));
        shares.push_back({weight, fragments_from(entry["fragments"], warp)});
    }
    return shares;
}

json fragments_to_json(const std::vector<Fragment>& fragments, const DepthWarp& warp) {
    json list = json::array();
    for (const Fragment& f : fragments)
        list.push_back({{"depth", warp.has_view_depths() ? f.view_depth : f.depth},
                        {"opacity", f.opacity},
                        {"color", {f.color.r, f.color.g, f.color.b}},
                        {"seed", f.seed},
                        {"threshold", f.threshold}});
    return list;
}

}  // namespace

json ray_to_json(const ViewRay& ray) {
    constexpr const char* KINDS[] = {"none", "log", "linear"};
    json warp = {{"kind", KINDS[static_cast<int>(ray.warp.kind)]}};
    if (ray.warp.has_view_depths()) warp.update({{"z_min", ray.warp.z_min}, {"z_max", ray.warp.z_max}});
    json root = {{"fragments", fragments_to_json(ray.fragments, ray.warp)}, {"warp", warp}};
    if (ray.far_plane > 0) root.update({{"near", ray.near_plane}, {"far", ray.far_plane}});
    for (const LowResolutionSource& share : ray.low_resolution_sources)
        root["shares"].push_back(
            {{"weight", share.weight}, {"fragments", fragments_to_json(share.fragments, ray.warp)}});
    return root;
}

ViewRay ray_from_json(const std::string& text) {
    return ray_from_value(parse_ray(text));
}

ViewRay ray_from_value(const json& root) {
    if (!root.is_object() || !root.contains("fragments") || !root["fragments"].is_array())
        throw Error("The view ray needs a list \"fragments\"; see the README for its form.");
    // inspect adds total_absorbance to the rays that it prints.
    require_known_keys(root, {"fragments", "warp", "near", "far", "shares", "total_absorbance"}, "top level");
    ViewRay ray;
    ray.warp = warp_from(root);
    if (root.contains("near")) ray.near_plane = number(root, "near", "top level");
    if (root.contains("far")) ray.far_plane = number(root, "far", "top level");
    const bool unknown = ray.near_plane == 0 && ray.far_plane == 0;
    if (!unknown && !is_depth_range(ray.near_plane, ray.far_plane))
        throw Error(
            "The view ray needs a \"near\" above 0 (1e-30 at least), and a \"far\" of at least 1.0001 near.");
    ray.fragments = fragments_from(root["fragments"], ray.warp);
    ray.low_resolution_sources = shares_from(root, ray.warp);
    return ray;
}

ViewRay read_ray_file(const std::filesystem::path& path) {
    return ray_from_json(read_input_file(path, MAX_RAY_FILE_BYTES, "view ray"));
}

}  // namespace momentscope
