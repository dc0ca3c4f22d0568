// read_report.hpp -- what a mesh reader reports while it works.
#pragma once
#include <functional>
#include <string>

namespace momentscope {

/// Called with what is being done, as a part of a sentence: "reading 190 MiB". May be empty.
using ReadReport = std::function<void(const std::string& what)>;

}  // namespace momentscope
