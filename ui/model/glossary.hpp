// glossary.hpp -- the terms of docs/glossary.md, and the marks of texts that refer to them.
//
// A text has these marks: [[term]] shows the term, [[term|shown]] shows another word for it, **bold**, and an
// empty line between paragraphs.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace momentscope::ui {

struct GlossaryEntry {
    std::string term;     // as the glossary writes it, such as "Bias, moment bias"
    std::string meaning;  // without marks
};

/// In the order of the glossary.
std::span<const GlossaryEntry> glossary();

/// The entry one of whose names this is, whatever its case; nullptr if there is none. "Bias, moment bias" has
/// two names.
const GlossaryEntry* find_term(std::string_view name);

/// A part of a text in one style.
struct TextRun {
    std::string text;
    bool bold = false;
    const GlossaryEntry* entry = nullptr;  // of a term
    bool paragraph = false;                // begins a new paragraph
};

/// The parts of a text with marks.
std::vector<TextRun> text_runs(std::string_view text);

/// The names between [[ and ]] (or |) of a text.
std::vector<std::string> terms_of(std::string_view text);

/// The text without marks.
std::string without_marks(std::string_view text);

}  // namespace momentscope::ui
