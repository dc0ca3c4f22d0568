// host_calls.hpp -- calls of the page's scripts: the object `host` of page/site/host.js.
#pragma once
#include <filesystem>

namespace momentscope {

void choose_file(const char* extension);
void deliver_file(const std::filesystem::path& path);
void copy_link(const char* link);
void copy_text(const char* text);

}  // namespace momentscope
