#include "core/markup.hpp"

#include <fmt/format.h>

namespace momentscope {

std::string markup_escaped(std::string_view text) {
    std::string result;
    for (const char letter : text) {
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
    std::string result;
    for (const char letter : text) {
        if (letter == '|' || letter == '`' || letter == '\\') result += '\\';
        result += letter == '\n' || letter == '\r' ? ' ' : letter;
    }
    return result;
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

std::vector<std::string> csv_fields(std::string_view line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool doubled = quoted && line.substr(i, 2) == "\"\"";
        if (doubled)
            fields.back() += line[i++];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            fields.emplace_back();
        else
            fields.back() += line[i];
    }
    return fields;
}

}  // namespace momentscope
