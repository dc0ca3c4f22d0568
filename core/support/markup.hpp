// markup.hpp -- escapes text that becomes part of pages, drawings and tables.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace momentscope {

/// The text as text or an attribute of HTML and XML, on one line. Characters with a meaning there are
/// escaped, forbidden ones replaced.
std::string markup_escaped(std::string_view text);

/// The text as text in Markdown, on one line, also within a table.
std::string markdown_cell(std::string_view text);

/// The text as code in Markdown, on one line, also within a table.
std::string markdown_code(std::string_view text);

/// "#rrggbb" of a colour in sRGB, each channel in [0, 1].
std::string css_color(const glm::vec3& color);

/// The text as a quoted field of a CSV file (RFC 4180), which may contain commas, quotes and line breaks.
std::string csv_quoted(std::string_view text);

/// The text as a field of a CSV file, in quotes only if it needs them.
std::string csv_field(std::string_view text);

/// The fields of a record of a CSV file, without their quotes; only the first `most`.
std::vector<std::string> csv_fields(std::string_view record, std::size_t most = std::string_view::npos);

/// The first record of a CSV file, without the line break at its end. Line breaks in quotes do not end a
/// record.
std::string_view first_csv_record(std::string_view text);

}  // namespace momentscope
