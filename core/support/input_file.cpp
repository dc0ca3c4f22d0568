#include "core/support/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "core/support/error.hpp"
#include "core/support/reachable.hpp"

namespace momentscope {

std::string read_input_file(const std::filesystem::path& path, std::uintmax_t most_bytes, const char* what) {
    require_reachable(path);
    std::error_code status;
    if (!std::filesystem::is_regular_file(path, status))
        throw Error(fmt::format("There is no {} file '{}'; give the path of one.", what, path.string()));
    const std::uintmax_t size = std::filesystem::file_size(path, status);
    std::ifstream file(path, std::ios::binary);
    std::string text;
    if (!status)
        text.reserve(static_cast<std::size_t>(
            std::min(size, most_bytes)));  // growing text needs three times the memory
    std::vector<char> chunk(std::size_t{1} << 16);
    do {  // to the end: files of the kernel have a size of 0, and others may grow
        file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
        text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
    } while (file && text.size() <= most_bytes);
    if (!file.is_open() || file.bad())
        throw Error(
            fmt::format("The {} file '{}' cannot be read; check its permissions.", what, path.string()));
    if (text.size() > most_bytes)
        throw Error(fmt::format("The {} file '{}' is larger than {}; give a smaller one.", what,
                                path.string(),
                                most_bytes >> 20 > 0 ? fmt::format("{} MiB", most_bytes >> 20)
                                                     : fmt::format("{} KiB", most_bytes >> 10)));
    return text;
}

}  // namespace momentscope
