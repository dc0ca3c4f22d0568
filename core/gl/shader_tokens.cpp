#include "core/gl/shader_tokens.hpp"

#include <algorithm>
#include <cctype>

namespace momentscope {

namespace {

bool is_word_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_space(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

// The end of the line, after its line break.
std::size_t end_of_line(std::string_view text, std::size_t from) {
    const std::size_t end = text.find('\n', from);
    return end == text.npos ? text.size() : end + 1;
}

std::size_t end_of_space(std::string_view text, std::size_t from) {
    std::size_t at = from;
    while (at < text.size()) {
        const std::string_view rest = text.substr(at);
        if (is_space(rest.front())) {
            ++at;
        } else if (rest.starts_with("//")) {
            at = end_of_line(text, at);
        } else if (rest.starts_with("/*")) {
            const std::size_t end = text.find("*/", at + 2);
            at = end == text.npos ? text.size() : end + 2;
        } else {
            break;
        }
    }
    return at;
}

// The end of a number, which has digits, a point, an exponent and a suffix: 1, 0x1fu, 1.0e-30f.
std::size_t end_of_number(std::string_view text, std::size_t from) {
    std::size_t at = from;
    while (at < text.size()) {
        const bool exponent =
            at > from && (text[at - 1] == 'e' || text[at - 1] == 'E') && !text.substr(from).starts_with("0x");
        if (!is_word_letter(text[at]) && text[at] != '.' &&
            !(exponent && (text[at] == '+' || text[at] == '-')))
            break;
        ++at;
    }
    return at;
}

std::size_t length_of_sign(std::string_view rest) {
    constexpr std::string_view PAIRS[] = {"++", "--", "<=", ">=", "==", "!=", "&&", "||", "<<",
                                          ">>", "+=", "-=", "*=", "/=", "^^", "&=", "|=", "^="};
    return std::ranges::any_of(PAIRS, [&](std::string_view pair) { return rest.starts_with(pair); }) ? 2 : 1;
}

}  // namespace

std::vector<ShaderToken> shader_tokens(std::string_view text) {
    using enum ShaderToken::Kind;
    std::vector<ShaderToken> tokens;
    bool line_begins = true;
    for (std::size_t at = 0; at < text.size();) {
        const char first = text[at];
        const std::size_t after_space = end_of_space(text, at);
        ShaderToken::Kind kind = sign;
        std::size_t end = at + length_of_sign(text.substr(at));
        if (after_space > at) {
            kind = space;
            end = after_space;
        } else if (first == '#' && line_begins) {
            kind = directive;
            end = end_of_line(text, at);
        } else if (std::isdigit(static_cast<unsigned char>(first)) != 0 ||
                   (first == '.' && at + 1 < text.size() &&
                    std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0)) {
            kind = number;
            end = end_of_number(text, at);
        } else if (is_word_letter(first)) {
            kind = word;
            while (end < text.size() && is_word_letter(text[end])) ++end;
        }
        tokens.push_back({kind, text.substr(at, end - at)});
        line_begins = kind == directive ||
                      (kind == space && (line_begins || tokens.back().text.find('\n') != text.npos));
        at = end;
    }
    return tokens;
}

}  // namespace momentscope
