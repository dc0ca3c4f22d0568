#include "page/host_calls.hpp"

#include <emscripten.h>

// clang-format off
EM_JS(void, host_choose_file, (const char* extension), { Module.host.chooseFile(UTF8ToString(extension)); });
EM_JS(void, host_deliver, (const char* path), { Module.host.deliver(UTF8ToString(path)); });
EM_JS(void, host_copy_link, (const char* link), { Module.host.copyLink(UTF8ToString(link)); });
EM_JS(void, host_copy_text, (const char* text), { Module.host.copyText(UTF8ToString(text)); });
// clang-format on

namespace momentscope {

void choose_file(const char* extension) {
    host_choose_file(extension);
}

void deliver_file(const std::filesystem::path& path) {
    host_deliver(path.c_str());
}

void copy_link(const char* link) {
    host_copy_link(link);
}

void copy_text(const char* text) {
    host_copy_text(text);
}

}  // namespace momentscope
