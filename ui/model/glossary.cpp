#include "ui/model/glossary.hpp"

#include <algorithm>
#include <cctype>

#include "ui/model/embedded_texts.hpp"

namespace momentscope::ui {

namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

// Removes the signs of Markdown from one place of a text: a link becomes its text, *emphasis* loses its
// stars, code its quotes. Other brackets and stars stay.
std::string plain(std::string_view markdown) {
    std::string text;
    std::size_t link = std::string_view::npos;  // where the bracket of an open link ends
    std::size_t star = std::string_view::npos;  // where an open emphasis ends
    for (std::size_t i = 0; i < markdown.size(); ++i) {
        const char c = markdown[i];
        const bool after_space =
            i == 0 || markdown[i - 1] == ' ' || markdown[i - 1] == '\n' || markdown[i - 1] == '(';
        if (c == '`') continue;
        if (c == '[') {
            const std::size_t end = markdown.find(']', i);
            if (end != std::string_view::npos && markdown.substr(end).starts_with("](")) {
                link = end;
                continue;
            }
        }
        if (i == link) {
            i = std::min(markdown.find(')', i), markdown.size() - 1);
            continue;
        }
        if (i == star) continue;
        if (c == '*' && after_space) {
            star = markdown.find('*', i + 1);
            continue;
        }
        text += c == '\n' ? ' ' : c;
    }
    return text;
}

// The sentence "See ..." at the end sends to a file, which the window cannot open.
std::string without_reference(const std::string& text) {
    const std::size_t see = text.rfind(" See ");
    return see == std::string::npos ? text : text.substr(0, see);
}

std::vector<GlossaryEntry> read_glossary() {
    const std::string_view text = embedded_glossary().at("glossary.md");
    std::vector<GlossaryEntry> entries;
    for (std::size_t begin = text.find("\n\n**"); begin != std::string_view::npos;
         begin = text.find("\n\n**", begin + 1)) {
        const std::size_t end = text.find("\n\n", begin + 2);
        const std::string_view paragraph = text.substr(begin + 4, end - begin - 4);
        const std::size_t head = paragraph.find("**");
        std::string term(paragraph.substr(0, head));
        const std::size_t symbols = head + 2;
        if (term.ends_with('.')) term.pop_back();
        std::string meaning = without_reference(plain(paragraph.substr(symbols)));
        meaning.erase(0, meaning.find_first_not_of(' '));
        entries.push_back({std::move(term), std::move(meaning)});
    }
    return entries;
}

// Calls text(part) and mark(name, shown) for the parts of a text, and bold() where a bold part begins or
// ends.
template <typename Text, typename Mark, typename Bold>
void scan(std::string_view text, const Text& on_text, const Mark& on_mark, const Bold& on_bold) {
    while (!text.empty()) {
        const std::size_t term = text.find("[[");
        const std::size_t bold = text.find("**");
        const std::size_t next = std::min(term, bold);
        if (next > 0) on_text(text.substr(0, next));
        if (next == std::string_view::npos) return;
        text.remove_prefix(next + 2);
        if (next == bold) {
            on_bold();
            continue;
        }
        const std::string_view inside = text.substr(0, text.find("]]"));
        const std::size_t bar = inside.find('|');
        on_mark(inside.substr(0, bar), bar == std::string_view::npos ? inside : inside.substr(bar + 1));
        text.remove_prefix(std::min(inside.size() + 2, text.size()));
    }
}

}  // namespace

std::span<const GlossaryEntry> glossary() {
    static const std::vector<GlossaryEntry> entries = read_glossary();
    return entries;
}

const GlossaryEntry* find_term(std::string_view name) {
    const std::string wanted = lower(name);
    for (const GlossaryEntry& entry : glossary()) {
        std::string_view names = entry.term;
        while (!names.empty()) {
            const std::size_t comma = names.find(", ");
            if (lower(names.substr(0, comma)) == wanted) return &entry;
            names.remove_prefix(comma == std::string_view::npos ? names.size() : comma + 2);
        }
    }
    return nullptr;
}

std::vector<TextRun> text_runs(std::string_view text) {
    std::vector<TextRun> runs;
    bool bold = false;
    bool paragraph = true;
    const auto add = [&](std::string_view part, const GlossaryEntry* entry) {
        if (!part.empty()) runs.push_back({std::string(part), bold, entry, paragraph});
        paragraph &= part.empty();
    };
    scan(
        text,
        [&](std::string_view part) {
            for (std::size_t end; (end = part.find("\n\n")) != std::string_view::npos;) {
                add(part.substr(0, end), nullptr);
                paragraph = true;
                part.remove_prefix(end + 2);
            }
            add(part, nullptr);
        },
        [&](std::string_view name, std::string_view shown) { add(shown, find_term(name)); },
        [&] { bold = !bold; });
    return runs;
}

std::vector<std::string> terms_of(std::string_view text) {
    std::vector<std::string> names;
    scan(
        text, [](std::string_view) {},
        [&](std::string_view name, std::string_view) { names.emplace_back(name); }, [] {});
    return names;
}

std::string without_marks(std::string_view text) {
    std::string plain_text;
    scan(
        text, [&](std::string_view part) { plain_text += part; },
        [&](std::string_view, std::string_view shown) { plain_text += shown; }, [] {});
    return plain_text;
}

}  // namespace momentscope::ui
