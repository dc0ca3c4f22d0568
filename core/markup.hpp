// markup.hpp -- text that becomes part of other text: pages, drawings and tables.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace momentscope {

/// As text or an attribute of HTML and XML, on one line: what has a meaning there is escaped, what may not
/// stand there replaced.
std::string markup_escaped(std::string_view text);

/// As text in Markdown, on one line, also within a table.
std::string markdown_cell(std::string_view text);

/// As code in Markdown, on one line, also within a table.
std::string markdown_code(std::string_view text);

/// "#rrggbb" of a colour in sRGB, each channel in [0, 1].
std::string css_color(const glm::vec3& color);

/// As a field of a CSV file (RFC 4180), which may hold commas, quotes and line breaks.
std::string csv_quoted(std::string_view text);

/// The same; in quotes only when it needs them.
std::string csv_field(std::string_view text);

/// The fields of a record of a CSV file, without their quotes; what follows the first `most` is left out.
std::vector<std::string> csv_fields(std::string_view record, std::size_t most = std::string_view::npos);

/// The first record of a CSV file, without the line break at its end: line breaks in quotes do not end it.
std::string_view first_csv_record(std::string_view text);

}  // namespace momentscope
