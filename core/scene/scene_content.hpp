// scene_content.hpp -- tells a mesh file from another one that has taken its name.
#pragma once
#include <string>

#include "core/scene/scene.hpp"

namespace momentscope {

/// 16 hexadecimal digits of the triangles and maps of a mesh file, or BUILTIN_CONTENT. Files of the same
/// content have the same digits, whatever their names; others hardly ever (FNV-1a, no protection against
/// intent).
std::string scene_content(const Scene& scene);

constexpr const char* BUILTIN_CONTENT = "-";  // changes with the version of the program alone

}  // namespace momentscope
