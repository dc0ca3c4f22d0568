#include "core/input_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "core/reachable.hpp"

namespace momentscope {

std::string read_input_file(const std::filesystem::path& path, std::uintmax_t most_bytes, const char* what) {
    require_reachable(path);
    std::error_code status;
    if (!std::filesystem::is_regular_file(path, status))
        throw Error(fmt::format("There is no {} file '{}'; give the path of one.", what, path.string()));
    if (std::filesystem::file_size(path, status) > most_bytes)
        throw Error(fmt::format("The {} file '{}' is larger than {} MiB; give a smaller one.", what,
                                path.string(), most_bytes >> 20));
    std::ifstream file(path, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (!file)
        throw Error(
            fmt::format("The {} file '{}' cannot be read; check its permissions.", what, path.string()));
    return text;
}

}  // namespace momentscope
