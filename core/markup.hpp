// markup.hpp -- text that becomes part of other text: pages, drawings and tables.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace momentscope {

/// With the signs that HTML, SVG and their attributes give a meaning replaced.
std::string markup_escaped(std::string_view text);

/// As a cell of a Markdown table.
std::string markdown_cell(std::string_view text);

/// "#rrggbb" of a colour in sRGB, each channel in [0, 1].
std::string css_color(const glm::vec3& color);

/// As a field of a CSV file that may hold commas and quotes.
std::string csv_quoted(std::string_view text);

/// The fields of a line of a CSV file, without their quotes.
std::vector<std::string> csv_fields(std::string_view line);

}  // namespace momentscope
