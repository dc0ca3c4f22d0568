#include "ui/widgets/drawing_painter.hpp"

#include "ui/widgets/lines.hpp"
#include "ui/widgets/theme.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

namespace {

// The size of a font is its em in a drawing, but the line height in ImGui.
constexpr float LINE_PER_EM = 1.164f;
const ImVec2 DASH = {6, 4};

class Painter {
public:
    Painter(ImDrawList& list, ImVec2 origin, float scale) : list_(list), origin_(origin), scale_(scale) {}

    void paint(const Drawing::Line& line) {
        const std::vector<ImVec2> points = placed(line.points);
        if (line.dashed)
            draw_dashed(list_, points, packed(line.color), line.width * scale_,
                        {DASH.x * scale_, DASH.y * scale_});
        else
            list_.AddPolyline(points.data(), static_cast<int>(points.size()), packed(line.color), 0,
                              line.width * scale_);
    }

    void paint(const Drawing::Mark& mark) {
        const ImVec2 at = placed(mark.at);
        const std::vector<ImVec2> outline = placed(mark_outline(mark));
        const auto count = static_cast<int>(outline.size());
        if (mark.shape == MarkShape::ring) {
            list_.AddCircle(at, mark.radius * scale_, packed(mark.color), 0, 2 * scale_);
            return;
        }
        if (mark.shape == MarkShape::cross) {  // not convex, so draw two bars
            list_.AddRectFilled(outline[9], outline[3], packed(mark.color));
            list_.AddRectFilled(outline[0], outline[6], packed(mark.color));
        } else {
            list_.AddConvexPolyFilled(outline.data(), count, packed(mark.color));
        }
        list_.AddPolyline(outline.data(), count, IM_COL32_WHITE, ImDrawFlags_Closed, scale_);
    }

    void paint(const Drawing::Text& text) {
        ImFont* font = text.bold ? bold_font() : ImGui::GetFont();
        const float height = text.size * LINE_PER_EM * scale_;
        const ImVec2 at = placed(text.at);
        list_.AddText(font, height, {at.x, at.y - 0.5f * height}, packed(text.color), text.text.c_str());
    }

private:
    ImVec2 placed(const glm::vec2& at) const {
        return {origin_.x + scale_ * at.x, origin_.y + scale_ * at.y};
    }
    std::vector<ImVec2> placed(const std::vector<glm::vec2>& points) const {
        std::vector<ImVec2> result;
        for (const glm::vec2& point : points) result.push_back(placed(point));
        return result;
    }

    ImDrawList& list_;
    ImVec2 origin_;
    float scale_;
};

}  // namespace

void paint_drawing(ImDrawList& list, const Drawing& drawing, ImVec2 origin, float scale) {
    Painter painter(list, origin, scale);
    for (const Drawing::Line& line : drawing.lines) painter.paint(line);
    for (const Drawing::Mark& mark : drawing.marks) painter.paint(mark);
    for (const Drawing::Text& text : drawing.texts) painter.paint(text);
}

}  // namespace momentscope::ui
