// obj_text.hpp -- OBJ files in a form that Assimp reads without loss.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace momentscope {

struct ObjText {
    std::string text;            // the same triangles, groups and materials, all vertices first
    std::size_t not_shown = 0;   // points, lines, curves and free-form surfaces, which are left out
    double coordinate = 0.0;     // the largest magnitude of a used vertex's coordinate
    double half_diagonal = 0.0;  // of the used vertices' bounding box, as the file has it
};

/// Vertices that faces use are centred and scaled to a half diagonal of 1 in double: Assimp 5.2 knows floats
/// only, miscounts numbers that begin with a dot and drops decimals after the 15th. Colours and weights of
/// vertices are left out, and so is what may not be read as number among normals (0, 0 stands for "nan").
/// Throws Error with the number of the line that holds something else than the format allows.
ObjText readable_obj(std::string_view source, const std::filesystem::path& path);

/// Does it look like OBJ whatever it is called? It has a line that begins with "v " and one with "f ".
bool looks_like_obj(std::string_view source);

}  // namespace momentscope
