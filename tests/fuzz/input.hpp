// input.hpp -- an input of the fuzz test: a file and the reader that gets it.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace momentscope::fuzz {

struct Input {
    std::string reader;     // name of the seed's folder: ray, session, table, configuration, events, mesh
    std::string extension;  // such as ".obj"; Assimp uses it
    std::string bytes;
};

constexpr std::size_t MAX_BYTES = std::size_t{1} << 18;  // limit of a mutated input

/// Throws Error if the file cannot be read.
Input read_input(const std::filesystem::path& path);

/// All files in the subfolders of a folder, sorted by name. Throws Error if there are none.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

}  // namespace momentscope::fuzz
