#include "page/host_calls.hpp"

#include <emscripten.h>

#include "core/support/error.hpp"

// clang-format off
EM_JS(void, host_choose_file, (const char* extension), { Module.host.chooseFile(UTF8ToString(extension)); });
EM_JS(void, host_deliver, (const char* path), { Module.host.deliver(UTF8ToString(path)); });
EM_JS(void, host_copy_link, (const char* link), { Module.host.copyLink(UTF8ToString(link)); });
EM_JS(void, host_copy_text, (const char* text), { Module.host.copyText(UTF8ToString(text)); });
EM_JS(bool, host_keep, (const char* name, const char* text), { return Module.host.keep(UTF8ToString(name), UTF8ToString(text)); });
EM_JS(void, host_toggle_fullscreen, (), { Module.host.toggleFullscreen(); });
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

void keep(const std::string& name, const std::string& text) {
    if (!host_keep(name.c_str(), text.c_str()))
        throw Error("Settings and progress are not kept, because the browser refuses to store them.");
}

std::map<std::string, std::string>& kept_texts() {
    static std::map<std::string, std::string> texts;
    return texts;
}

void toggle_fullscreen() {
    host_toggle_fullscreen();
}

}  // namespace momentscope
