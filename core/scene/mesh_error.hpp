// mesh_error.hpp -- the form of all errors and warnings about mesh files.
#pragma once
#include "core/support/error.hpp"

#include <filesystem>
#include <string>

namespace momentscope {

/// A sentence about the file, on one line: "The mesh file 'x.obj' " and then the given text.
inline std::string mesh_sentence(const std::filesystem::path& path, const std::string& what_and_what_to_do) {
    return Error("The mesh file '" + path.string() + "' " + what_and_what_to_do).what();
}

/// Throws this sentence as an Error.
[[noreturn]] inline void refuse_mesh(const std::filesystem::path& path,
                                     const std::string& what_and_what_to_do) {
    throw Error(mesh_sentence(path, what_and_what_to_do));
}

}  // namespace momentscope
