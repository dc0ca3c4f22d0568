// mesh_error.hpp -- how everything that is wrong with a mesh file is said.
#pragma once
#include "core/error.hpp"

#include <filesystem>
#include <string>

namespace momentscope {

/// One sentence about the file, on one line: "The mesh file 'x.obj' " and what it has or is.
inline std::string mesh_sentence(const std::filesystem::path& path, const std::string& what_and_what_to_do) {
    return Error("The mesh file '" + path.string() + "' " + what_and_what_to_do).what();
}

/// Throws that sentence as an Error.
[[noreturn]] inline void refuse_mesh(const std::filesystem::path& path,
                                     const std::string& what_and_what_to_do) {
    throw Error(mesh_sentence(path, what_and_what_to_do));
}

}  // namespace momentscope
