// scene_content.hpp -- tells whether a mesh file has changed although its name has not.
#pragma once
#include <string>

#include "core/scene/scene.hpp"

namespace momentscope {

/// A hash with 16 hexadecimal digits of the triangles and maps of a mesh file, or BUILTIN_CONTENT. Files with
/// the same content have the same digits, whatever their names; others almost never (FNV-1a, which does not
/// protect against intent).
std::string scene_content(const Scene& scene);

constexpr const char* BUILTIN_CONTENT = "-";  // changes only with the version of the program

}  // namespace momentscope
