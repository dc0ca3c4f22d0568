// ray_json.hpp -- writes and reads view rays as JSON.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/ray/view_ray.hpp"

namespace momentscope {

constexpr std::size_t MAX_RAY_FILE_BYTES = std::size_t{64} << 20;
constexpr std::size_t MAX_RAY_FRAGMENTS = 100'000;

/// {"fragments": [{"depth", "opacity", "color", ...}, ...], "warp": {"kind", "z_min", "z_max"}, "near",
/// "far"}. "depth" is a view depth in scene units with the kinds "log" and "linear", and lies in [-1, 1] with
/// the kind "none", which is the default.
nlohmann::json ray_to_json(const ViewRay& ray);

/// Each reads a view ray. Throws Error, which names the wrong entry, if the JSON is not a valid ray.
ViewRay ray_from_json(const std::string& text);
ViewRay ray_from_value(const nlohmann::json& root);  // of JSON that was parsed with limits
ViewRay read_ray_file(const std::filesystem::path& path);

}  // namespace momentscope
