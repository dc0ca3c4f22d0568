// obj_text.hpp -- rewrites OBJ files in a form that Assimp reads without loss.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace momentscope {

struct ObjText {
    std::string text;            // the same triangles, groups and materials, all vertices first
    std::size_t not_shown = 0;   // points, lines, curves and free-form surfaces, which are left out
    double coordinate = 0.0;     // largest magnitude of a coordinate of the used vertices
    double half_diagonal = 0.0;  // of the bounding box of the used vertices, in units of the file
};

/// Centres the vertices that faces use, and scales them to a half diagonal of 1, in double. This is needed
/// because Assimp 5.2 stores floats, miscounts numbers that begin with a dot, and drops decimals after the
/// 15th. Colours and weights of vertices are left out. Normals and texture coordinates that are not numbers,
/// such as "nan", become 0. Throws Error, with the number of the line, if a line does not follow the format.
ObjText readable_obj(std::string_view source, const std::filesystem::path& path);

/// True if the text looks like OBJ, whatever its name: it has a line that begins with "v " and one that
/// begins with "f ".
bool looks_like_obj(std::string_view source);

}  // namespace momentscope
