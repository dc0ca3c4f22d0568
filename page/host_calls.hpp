// host_calls.hpp -- calls of the page's scripts: the object `host` of page/site/host.js.
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace momentscope {

void choose_file(const char* extension);
void deliver_file(const std::filesystem::path& path);
void copy_link(const char* link);
void copy_text(const char* text);

/// Keeps a text in the storage of the browser. Throws Error if the browser refuses.
void keep(const std::string& name, const std::string& text);

/// What was kept, by name. The page's scripts fill it before the program starts.
std::map<std::string, std::string>& kept_texts();

void toggle_fullscreen();

}  // namespace momentscope
