// read_report.hpp -- what a reader of meshes says while it works.
#pragma once
#include <functional>
#include <string>

namespace momentscope {

/// Is told what is done now, as part of a sentence without its end: "reading 190 MiB". May be empty.
using ReadReport = std::function<void(const std::string& what)>;

}  // namespace momentscope
