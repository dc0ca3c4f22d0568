// input.hpp -- what is fuzzed: a file and the reader that it goes to.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace momentscope::fuzz {

struct Input {
    std::string reader;     // the name of the seed's folder: ray, session, table, configuration, events, mesh
    std::string extension;  // ".obj"; Assimp goes by it
    std::string bytes;
};

constexpr std::size_t MAX_BYTES = std::size_t{1} << 18;  // of a mutated input

/// Throws Error when it cannot be read.
Input read_input(const std::filesystem::path& path);

/// All files in the folders of a folder, in the order of their names. Throws Error when there are none.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

}  // namespace momentscope::fuzz
