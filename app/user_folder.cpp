#include "app/user_folder.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "core/support/error.hpp"
#include "core/support/input_file.hpp"
#include "core/support/output_file.hpp"

namespace momentscope {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t MAX_KEPT_BYTES = 4U << 20;

fs::path folder_of(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr ? fs::path() : fs::path(value);
}

fs::path file_of(const std::string& name) {
    return user_folder() / (name + ".json");
}

}  // namespace

fs::path user_folder() {
    const fs::path config = folder_of("XDG_CONFIG_HOME");
    if (config.is_absolute()) return config / "momentscope";
    const fs::path home = folder_of("HOME");
    return home.is_absolute() ? home / ".config" / "momentscope" : fs::path();
}

void keep_for_user(const std::string& name, const std::string& text) {
    const fs::path folder = user_folder();
    if (folder.empty())
        throw Error(
            "Settings and progress are not kept, because neither XDG_CONFIG_HOME nor HOME names a folder.");
    std::error_code code;
    fs::create_directories(folder, code);
    try {
        write_file(text, file_of(name));
    } catch (const Error& error) {
        throw Error(fmt::format("Settings and progress are not kept: {}", error.what()));
    }
}

std::string kept_for_user(const std::string& name) {
    std::error_code code;
    if (user_folder().empty() || !fs::exists(file_of(name), code)) return "";
    return read_input_file(file_of(name), MAX_KEPT_BYTES, "kept");
}

}  // namespace momentscope
