// folder_files.cpp -- finds the path of a name in a mesh file, and whether it may be opened.
#include "core/scene/folder_files.hpp"

#include "core/scene/text_encoding.hpp"

#include <assimp/MemoryIOWrapper.h>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

namespace momentscope {
namespace {

namespace fs = std::filesystem;

/// Replaces "%20" by a blank and other codes alike; all other text stays as it is.
std::string percent_decoded(std::string_view text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned char byte = 0;
        const std::string_view digits = text.substr(i).substr(0, 3);
        const char* const end = digits.data() + digits.size();
        const bool encoded = digits.size() == 3 && digits[0] == '%' &&
                             std::from_chars(digits.data() + 1, end, byte, 16).ptr == end && byte != 0;
        decoded += encoded ? static_cast<char>(byte) : text[i];
        if (encoded) i += 2;
    }
    return decoded;
}

/// A file that owns a copy of the text.
Assimp::IOStream* file_of(const std::string& text) {
    auto* const bytes = new std::uint8_t[text.size()];
    std::copy(text.begin(), text.end(), bytes);
    return new Assimp::MemoryIOStream(bytes, text.size(), true);
}

}  // namespace

FolderFiles::FolderFiles(fs::path mesh, std::optional<std::string> text, bool uris)
    : mesh_(std::move(mesh)), text_(std::move(text)), uris_(uris) {
    std::error_code code;
    folder_ = fs::canonical(mesh_.has_parent_path() ? mesh_.parent_path() : fs::path("."), code);
}

/// The path to open; nullopt if there is no such ordinary file or it must not be opened.
std::optional<std::string> FolderFiles::found(const std::string& file) const {
    if (file == mesh_.string()) return file;
    // Assimp prefixes every name with the folder.
    const std::string parent = mesh_.has_parent_path() ? mesh_.parent_path().string() : "";
    std::string_view name = file;
    if (name.starts_with(parent)) name.remove_prefix(parent.size());
    if (!parent.empty() && name.starts_with('/')) name.remove_prefix(1);
    if (name.starts_with("./") && parent.empty()) name.remove_prefix(2);

    std::string_view local = name;
    if (local.starts_with("file://localhost/")) local.remove_prefix(16);
    if (local.starts_with("file:///")) local.remove_prefix(7);
    const std::string decoded = percent_decoded(local);
    std::vector<std::string> names = {std::string(name), decoded};
    if (uris_) std::swap(names[0], names[1]);

    bool leads_out = false;
    for (const std::string& candidate : names) {
        std::error_code code;  // an absolute name replaces the folder
        const fs::path path = fs::weakly_canonical(mesh_.parent_path() / candidate, code);
        if (code || folder_.empty() || !fs::exists(path, code)) continue;
        if (std::mismatch(folder_.begin(), folder_.end(), path.begin(), path.end()).first != folder_.end())
            leads_out = true;
        else if (fs::is_regular_file(path, code))
            return path.string();
    }
    if (leads_out && !outside_) outside_ = name;
    return std::nullopt;
}

bool FolderFiles::Exists(const char* file) const {
    return found(file).has_value();
}

Assimp::IOStream* FolderFiles::Open(const char* file, const char* mode) {
    if (mode == nullptr || mode[0] != 'r') return nullptr;
    const std::optional<std::string> path = found(file);
    if (!path) return nullptr;
    if (*path == mesh_.string()) return text_ ? file_of(*text_) : DefaultIOSystem::Open(file, mode);
    if (fs::path(*path).extension() == ".mtl") {  // the only text file beside the mesh itself
        std::ifstream stream(*path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        if (const std::optional<std::string> text = as_utf8(bytes)) return file_of(*text);
    }
    return DefaultIOSystem::Open(path->c_str(), mode);
}

}  // namespace momentscope
