#include "tests/fuzz/input.hpp"

#include <algorithm>

#include "core/support/error.hpp"
#include "core/support/input_file.hpp"

namespace momentscope::fuzz {

Input read_input(const std::filesystem::path& path) {
    constexpr std::uintmax_t MAX_SOURCE_BYTES = std::uintmax_t{1} << 30;
    return {std::filesystem::absolute(path).parent_path().filename().string(), path.extension().string(),
            read_input_file(path, MAX_SOURCE_BYTES, "input")};
}

std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code code;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, code))
        if (entry.is_regular_file()) files.push_back(entry.path());
    if (files.empty()) throw Error("There are no seeds in '" + folder.string() + "'; give their folder.");
    std::ranges::sort(files);
    return files;
}

}  // namespace momentscope::fuzz
