// folder_files.cpp -- finds the path of a name in a mesh file, and whether it may be opened.
#include "core/scene/folder_files.hpp"

#include "core/scene/text_encoding.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <new>
#include <sstream>
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

// The functions that Assimp calls. An exception must not pass through Assimp.

std::istream& stream_of(aiFile* file) {
    return *reinterpret_cast<std::istream*>(file->UserData);
}

std::size_t read_items(aiFile* file, char* to, std::size_t size, std::size_t count) {
    std::istream& stream = stream_of(file);
    stream.clear();  // the last read may have met the end
    stream.read(to, static_cast<std::streamsize>(size * count));
    return size > 0 ? static_cast<std::size_t>(stream.gcount()) / size : 0;
}

std::size_t place_in(aiFile* file) {
    stream_of(file).clear();
    return static_cast<std::size_t>(stream_of(file).tellg());
}

aiReturn seek_in(aiFile* file, std::size_t offset, aiOrigin origin) {
    std::istream& stream = stream_of(file);
    stream.clear();
    const auto from = origin == aiOrigin_SET   ? std::ios::beg
                      : origin == aiOrigin_CUR ? std::ios::cur
                                               : std::ios::end;
    return stream.seekg(static_cast<std::streamoff>(offset), from) ? aiReturn_SUCCESS : aiReturn_FAILURE;
}

std::size_t size_of(aiFile* file) {
    const std::size_t here = place_in(file);
    seek_in(file, 0, aiOrigin_END);
    const std::size_t size = place_in(file);
    seek_in(file, here, aiOrigin_SET);
    return size;
}

std::size_t write_nothing(aiFile* /*file*/, const char* /*from*/, std::size_t /*size*/,
                          std::size_t /*count*/) {
    return 0;
}

void flush_nothing(aiFile* /*file*/) {}

aiFile* open_file(aiFileIO* files, const char* name, const char* mode) try {
    if (mode == nullptr || mode[0] != 'r') return nullptr;
    auto stream = reinterpret_cast<FolderFiles*>(files->UserData)->open(name);
    if (!stream) return nullptr;
    auto* const file = new aiFile{read_items, write_nothing, place_in, size_of, seek_in, flush_nothing, {}};
    file->UserData = reinterpret_cast<char*>(stream.release());
    return file;
} catch (const std::bad_alloc&) {
    return nullptr;
}

void close_file(aiFileIO* /*files*/, aiFile* file) {
    delete &stream_of(file);
    delete file;
}

}  // namespace

FolderFiles::FolderFiles(fs::path mesh, std::optional<std::string> text, bool uris)
    : mesh_(std::move(mesh)), text_(std::move(text)), uris_(uris) {
    std::error_code code;
    folder_ = fs::canonical(mesh_.has_parent_path() ? mesh_.parent_path() : fs::path("."), code);
}

/// The path to open; nullopt if there is no such ordinary file or it must not be opened.
std::optional<std::string> FolderFiles::found(const std::string& file) {
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

std::unique_ptr<std::istream> FolderFiles::open(const std::string& name) {
    const std::optional<std::string> path = found(name);
    if (!path) return nullptr;
    if (*path == mesh_.string() && text_) return std::make_unique<std::istringstream>(*text_);
    auto file = std::make_unique<std::ifstream>(*path, std::ios::binary);
    if (!*file) return nullptr;
    if (*path != mesh_.string() &&
        fs::path(*path).extension() == ".mtl") {  // the only text file beside the mesh
        const std::string bytes{std::istreambuf_iterator<char>(*file), {}};
        if (const std::optional<std::string> text = as_utf8(bytes))
            return std::make_unique<std::istringstream>(*text);
        file->clear();
        file->seekg(0);
    }
    return file;
}

aiFileIO FolderFiles::for_assimp() {
    return {open_file, close_file, reinterpret_cast<char*>(this)};
}

}  // namespace momentscope
