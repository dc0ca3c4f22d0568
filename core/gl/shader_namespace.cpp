#include "core/gl/shader_namespace.hpp"

#include <cctype>
#include <set>
#include <sstream>
#include <vector>

namespace momentscope {

namespace {

// The words of prelude.glsl, which mean the same in all namespaces.
const std::set<std::string_view, std::less<>> PRELUDE = {"FN",     "IN",          "PRECISE",
                                                         "UNROLL", "EARLY_TESTS", "INVARIANT_IN"};

bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Calls word(text) for words and between(text) for the text between them, in order.
template <typename Word, typename Between>
void for_each_word(std::string_view text, const Word& word, const Between& between) {
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin;
        while (end < text.size() && in_word(text[end]) == in_word(text[begin])) ++end;
        const std::string_view part = text.substr(begin, end - begin);
        if (in_word(part.front()))
            word(part);
        else
            between(part);
        begin = end;
    }
}

bool is_macro_name(std::string_view word) {
    bool upper = false;
    for (const char c : word) {
        if (std::islower(static_cast<unsigned char>(c)) != 0) return false;
        upper |= std::isupper(static_cast<unsigned char>(c)) != 0;
    }
    return upper && !PRELUDE.contains(word) && !word.starts_with("GL_");
}

// The words of the code in a line, without its comment.
std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for_each_word(
        line.substr(0, line.find("//")), [&](std::string_view w) { words.push_back(w); },
        [](std::string_view) {});
    return words;
}

std::set<std::string, std::less<>> declared_names(std::string_view text) {
    std::set<std::string, std::less<>> names;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string_view> words = words_of(line);
        if (line.starts_with("#")) {
            for (const std::string_view word : words)
                if (is_macro_name(word)) names.emplace(word);
        } else if (words.size() > 1 && words[0] == "struct") {
            names.emplace(words[1]);
        } else if (words.size() > 2 && (words[0] == "FN" || words[0] == "const")) {
            names.emplace(words[2]);
        }
    }
    return names;
}

}  // namespace

std::string in_namespace(std::string_view text, std::string_view name) {
    const auto names = declared_names(text);
    std::string result;
    for_each_word(
        text,
        [&](std::string_view word) {
            if (names.contains(word)) result.append(name).append("_");
            result += word;
        },
        [&](std::string_view between) { result += between; });
    return result;
}

}  // namespace momentscope
