#include "ui/widgets/rich_text.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "ui/model/glossary.hpp"

namespace momentscope::ui {

namespace {

constexpr float PARAGRAPH_GAP = 0.4f;  // font heights

/// A word at its place, relative to the corner of the text. A word that ends in punctuation has two parts in
/// different styles.
struct PlacedWord {
    std::string text;
    ImVec2 at;
    float width;
    bool bold;
    const GlossaryEntry* entry;
};

struct TextLayout {
    std::vector<PlacedWord> words;
    float height = 0;
};

float width_of(std::string_view text, bool bold) {
    ImFont* font = bold ? bold_font() : ImGui::GetFont();
    return font->CalcTextSizeA(ImGui::GetFontSize(), 1e6f, 0, text.data(), text.data() + text.size()).x;
}

/// A part of a word in one style; `joined`: no space stands before it.
struct Piece {
    std::string_view text;
    const TextRun* run;
    bool joined;
    bool paragraph;
};

std::vector<Piece> pieces_of(const std::vector<TextRun>& runs) {
    std::vector<Piece> pieces;
    bool space = true;
    for (const TextRun& run : runs) {
        bool paragraph = run.paragraph;
        std::string_view rest = run.text;
        while (!rest.empty()) {
            if (rest.front() == ' ' || rest.front() == '\n') {
                space = true;
                rest.remove_prefix(1);
                continue;
            }
            const std::size_t end = rest.find_first_of(" \n");
            pieces.push_back({rest.substr(0, end), &run, !space && !paragraph, paragraph});
            paragraph = space = false;
            rest.remove_prefix(end == std::string_view::npos ? rest.size() : end);
        }
    }
    return pieces;
}

// Breaks lines between words, but not between the parts of one.
TextLayout layout_of(const std::vector<TextRun>& runs, float width) {
    const std::vector<Piece> pieces = pieces_of(runs);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float space = width_of(" ", false);
    TextLayout layout;
    ImVec2 at = {0, 0};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        float whole = width_of(piece.text, piece.run->bold);
        const float own = whole;
        for (std::size_t k = i + 1; k < pieces.size() && pieces[k].joined; ++k)
            whole += width_of(pieces[k].text, pieces[k].run->bold);
        if (piece.paragraph && i > 0)
            at = {0, at.y + line + PARAGRAPH_GAP * em()};
        else if (!piece.joined && at.x > 0)
            at.x += space;
        if (!piece.joined && at.x > 0 && at.x + whole > width) at = {0, at.y + line};
        layout.words.push_back({std::string(piece.text), at, own, piece.run->bold, piece.run->entry});
        at.x += own;
    }
    layout.height = pieces.empty() ? 0 : at.y + line;
    return layout;
}

void explain(const GlossaryEntry& entry) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(28 * em());
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted(entry.term.c_str());
    ImGui::PopFont();
    ImGui::TextUnformatted(entry.meaning.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace

void draw_rich_text(const Ui& ui, const std::string& text, float width) {
    const TextLayout layout = layout_of(text_runs(text), width);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 tint = ImGui::GetColorU32(ImGuiCol_Text);
    const float size = ImGui::GetFontSize();
    for (const PlacedWord& word : layout.words) {
        const ImVec2 low = {corner.x + word.at.x, corner.y + word.at.y};
        const ImVec2 high = {low.x + word.width, low.y + size};
        list.AddText(word.bold ? bold_font() : ImGui::GetFont(), size, low, tint, word.text.c_str());
        if (word.entry == nullptr) continue;
        const float dot = std::max(1.0f, 0.08f * em());
        const int dots = static_cast<int>(word.width / (3 * dot));
        for (int i = 0; i <= dots; ++i) {  // a dotted line marks a term
            const float x = low.x + 3 * dot * static_cast<float>(i);
            list.AddRectFilled({x, high.y + dot}, {x + dot, high.y + 2 * dot}, ui.colors.bounds);
        }
        if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high)) explain(*word.entry);
        std::string name = "term." + word.entry->term;
        std::ranges::replace(name, ' ', '_');
        ui.widget_rects[name] = {low, high};
    }
    ImGui::Dummy({width, layout.height - ImGui::GetStyle().ItemSpacing.y});
}

float rich_text_height(const std::string& text, float width) {
    return layout_of(text_runs(text), width).height;
}

}  // namespace momentscope::ui
