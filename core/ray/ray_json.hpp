// ray_json.hpp -- view rays as JSON, in and out.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/ray/view_ray.hpp"

namespace momentscope {

constexpr std::size_t MAX_RAY_FILE_BYTES = std::size_t{64} << 20;
constexpr std::size_t MAX_RAY_FRAGMENTS = 100'000;

/// {"fragments": [{"depth", "opacity", "color"}, ...], "warp": {"kind", "z_min", "z_max"}, "near", "far"}.
/// Depth is linear view depth with "kind": "log", and lies in [-1, 1] with "none", the default.
nlohmann::json ray_to_json(const ViewRay& ray);

/// Throws Error that names the offending entry.
ViewRay ray_from_json(const std::string& text);
ViewRay ray_from_value(const nlohmann::json& root);  // of JSON that was read with bounds
ViewRay read_ray_file(const std::filesystem::path& path);

}  // namespace momentscope
