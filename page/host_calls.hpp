// host_calls.hpp -- calls of the page's scripts: the object `host` of page/site/host.js.
#pragma once
#include <filesystem>
#include <string>

namespace momentscope {

void choose_file(const char* extension);
void deliver_file(const std::filesystem::path& path);
void copy_link(const char* link);
void copy_text(const char* text);

/// In the storage of the browser. Both throw Error if the browser refuses.
void keep(const std::string& name, const std::string& text);
std::string kept(const std::string& name);

void toggle_fullscreen();

}  // namespace momentscope
