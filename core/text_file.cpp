#include "core/text_file.hpp"

#include <fmt/format.h>

#include <fstream>

#include "core/error.hpp"
#include "core/image/image.hpp"

namespace momentscope {

void write_text_file(const std::string& text, const std::filesystem::path& path) {
    require_writable(path);
    std::filesystem::path partial = path;
    partial.replace_filename(fmt::format(".{}.partial", path.filename().string()));
    std::ofstream file(partial, std::ios::binary);
    file << text;
    file.close();
    std::error_code status;
    if (file) std::filesystem::rename(partial, path, status);
    if (!file || status) {
        std::filesystem::remove(partial, status);
        throw Error(
            fmt::format("'{}' could not be written; check the folder and free space.", path.string()));
    }
}

}  // namespace momentscope
