#include "core/support/markup.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/support/plain_text.hpp"

namespace momentscope {

std::string markup_escaped(std::string_view text) {
    std::string result;
    for (const char letter : one_line(text)) {
        if (letter == '<')
            result += "&lt;";
        else if (letter == '&')
            result += "&amp;";
        else if (letter == '"')
            result += "&quot;";
        else
            result += letter;
    }
    return result;
}

std::string markdown_cell(std::string_view text) {
    constexpr std::string_view SIGNS = "|`\\*_[]<&~";
    std::string result;
    for (const char letter : one_line(text)) {
        if (SIGNS.find(letter) != std::string_view::npos) result += '\\';
        result += letter;
    }
    return result;
}

std::string markdown_code(std::string_view text) {
    std::string code;
    std::size_t run = 0, longest = 0;  // of backquotes
    for (const char letter : one_line(text)) {
        if (letter == '|') code += '\\';
        code += letter;
        run = letter == '`' ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    const std::string fence(longest + 1, '`');
    const char* space = longest > 0 ? " " : "";  // spaces that are not part of the code
    return fence + space + code + space + fence;
}

std::string css_color(const glm::vec3& color) {
    const glm::ivec3 c = glm::ivec3(color * 255.0f + 0.5f);
    return fmt::format("#{:02x}{:02x}{:02x}", c.x, c.y, c.z);
}

std::string csv_quoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + "\"";
}

std::string csv_field(std::string_view text) {
    return text.find_first_of(",\"\r\n") == std::string_view::npos ? std::string(text) : csv_quoted(text);
}

std::string_view first_csv_record(std::string_view text) {
    bool quoted = false;
    std::size_t end = 0;
    for (; end < text.size() && (quoted || text[end] != '\n'); ++end)
        if (text[end] == '"') quoted = !quoted;
    return text.substr(0, end);
}

std::vector<std::string> csv_fields(std::string_view record, std::size_t most) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < record.size(); ++i) {
        const bool doubled = quoted && record.substr(i, 2) == "\"\"";
        if (doubled)
            fields.back() += record[i++];
        else if (record[i] == '"')
            quoted = !quoted;
        else if (record[i] == ',' && !quoted && fields.size() == most)
            break;
        else if (record[i] == ',' && !quoted)
            fields.emplace_back();
        else
            fields.back() += record[i];
    }
    return fields;
}

}  // namespace momentscope
