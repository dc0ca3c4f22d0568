#include "core/support/reachable.hpp"

#include <fmt/format.h>

#include <system_error>

#include "core/support/error.hpp"

namespace momentscope {

void require_reachable(const std::filesystem::path& path) {
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(path, code);
    if (!code || status.type() == std::filesystem::file_type::not_found) return;
    if (code == std::errc::filename_too_long)
        throw Error(
            fmt::format("The name '{:.40}...' is too long for a file; give a shorter one.", path.string()));
    if (code == std::errc::permission_denied)
        throw Error(fmt::format(
            "'{}' is in a folder that you may not enter; check its permissions, or give another path.",
            path.string()));
    throw Error(
        fmt::format("'{}' cannot be looked up ({}); give another path.", path.string(), code.message()));
}

std::filesystem::path absolute_path(const std::filesystem::path& path) {
    std::error_code code;
    std::filesystem::path result = std::filesystem::absolute(path, code);
    if (code) throw Error("The working folder is gone; change to one that is there.");
    return result;
}

bool same_file(const std::string& a, const std::string& b) {
    std::error_code code;
    if (std::filesystem::equivalent(a, b, code)) return true;
    const auto path_a = std::filesystem::absolute(a, code), path_b = std::filesystem::absolute(b, code);
    return !code && path_a.lexically_normal() == path_b.lexically_normal();
}

}  // namespace momentscope
