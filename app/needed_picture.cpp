#include "app/needed_picture.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/gl_context.hpp"
#include "app/gui_session.hpp"
#include "app/image_texture.hpp"
#include "core/gl/framebuffer.hpp"
#include "ui/widgets/theme.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope {

namespace {

// Similar to Cividis: the lightness shows the order. The colour for "no order is enough" stands out.
constexpr std::array<glm::vec3, NEEDED_COUNT> NEED_COLORS = {
    glm::vec3(0.93f, 0.93f, 0.93f), glm::vec3(0.99f, 0.91f, 0.55f), glm::vec3(0.53f, 0.66f, 0.63f),
    glm::vec3(0.16f, 0.31f, 0.50f), glm::vec3(0.80f, 0.28f, 0.10f)};
constexpr int MAX_TEXT_HEIGHT = 600;

enum class Agreement { nothing, agree, cautious, overlooked };
constexpr std::array<glm::vec3, 4> AGREEMENT_COLORS = {
    glm::vec3(0.93f, 0.93f, 0.93f), glm::vec3(0.80f, 0.80f, 0.80f), glm::vec3(0.34f, 0.55f, 0.75f),
    glm::vec3(0.90f, 0.45f, 0.05f)};
constexpr std::array AGREEMENT_TEXTS = {"no fragments", "both say the same", "the certificate asks for more",
                                        "the error asks for more: the bounds ignore bias and rounding"};

Agreement agreement_of(const PixelNeed& pixel) {
    if (pixel.by_error == Needed::nothing) return Agreement::nothing;
    if (pixel.by_certificate == pixel.by_error) return Agreement::agree;
    return pixel.by_certificate > pixel.by_error ? Agreement::cautious : Agreement::overlooked;
}

template <typename ColorOf>
Image map_of(const Image& picture, std::span<const PixelNeed> pixels, const ColorOf& color_of) {
    Image map(picture.width, picture.height);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::vec3 srgb = color_of(pixels[i]);
        map.pixels[i] =
            glm::vec4(linear_from_srgb(srgb.r), linear_from_srgb(srgb.g), linear_from_srgb(srgb.b), 1);
    }
    return map;
}

void legend_row(const glm::vec3& color, const std::string& text) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetTextLineHeight();
    const ImU32 packed = ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1});
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + 1.4f * side, at.y + side}, packed);
    ImGui::GetWindowDrawList()->AddRect(at, {at.x + 1.4f * side, at.y + side}, IM_COL32(90, 90, 90, 255));
    ImGui::Dummy({1.4f * side, side});
    ImGui::SameLine();
    ImGui::TextUnformatted(text.c_str());
}

std::string share_text(long count, std::size_t all) {
    return fmt::format(
        "{:.1f} %", 100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(all, 1)));
}

void need_legend(const std::array<long, NEEDED_COUNT>& histogram, std::size_t all) {
    for (std::size_t i = 0; i < NEEDED_COUNT; ++i)
        legend_row(NEED_COLORS[i],
                   fmt::format("{}{}: {}", i == 0 ? "" : "moments: ", needed_text(static_cast<Needed>(i)),
                               share_text(histogram[i], all)));
}

void agreement_legend(const NeedHistogram& histogram, std::size_t all) {
    const long nothing = histogram.by_error[0];
    const long agree = static_cast<long>(all) - nothing - histogram.cautious - histogram.overlooked;
    const std::array counts = {nothing, agree, histogram.cautious, histogram.overlooked};
    for (std::size_t i = 0; i < counts.size(); ++i)
        legend_row(AGREEMENT_COLORS[i],
                   fmt::format("{}: {}", AGREEMENT_TEXTS[i], share_text(counts[i], all)));
}

}  // namespace

void write_needed_picture(const Image& picture, std::span<const PixelNeed> pixels, const std::string& title,
                          const std::filesystem::path& path) {
    const std::array maps = {
        picture,
        map_of(picture, pixels,
               [](const PixelNeed& p) { return NEED_COLORS[static_cast<std::size_t>(p.by_certificate)]; }),
        map_of(picture, pixels,
               [](const PixelNeed& p) { return NEED_COLORS[static_cast<std::size_t>(p.by_error)]; }),
        map_of(picture, pixels, [](const PixelNeed& p) {
            return AGREEMENT_COLORS[static_cast<std::size_t>(agreement_of(p))];
        })};
    constexpr std::array HEADINGS = {"The scene", "By the certificate: bounds alone, without the truth",
                                     "By the measured error", "Where they disagree"};
    const NeedHistogram histogram = count_needs(pixels);
    const float width = 560;
    const float height = width * static_cast<float>(picture.height) / static_cast<float>(picture.width);
    glm::ivec2 size(static_cast<int>(2 * width) + 60, static_cast<int>(2 * height) + MAX_TEXT_HEIGHT);
    const auto context = make_headless_context(size);
    GuiSession gui(nullptr, 1.0f);
    std::array<GlTexture, 4> textures;
    for (std::size_t i = 0; i < maps.size(); ++i) textures[i] = image_texture(maps[i]);
    ui::apply_style(ui::ThemeKind::light, 1.0f);
    for (int frame = 0; frame < 2; ++frame) {  // the first frame measures the height
        float content = 0;
        gui.begin_frame(size);
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({static_cast<float>(size.x), static_cast<float>(size.y)});
        ImGui::Begin("needed", nullptr, ImGuiWindowFlags_NoDecoration);
        ImGui::TextUnformatted(title.c_str());
        ImGui::Spacing();
        for (std::size_t i = 0; i < maps.size(); ++i) {
            if (i % 2 == 1) ImGui::SameLine(0, 24);
            ImGui::BeginGroup();
            ImGui::TextUnformatted(HEADINGS[i]);
            ImGui::Image(ui::texture_id(textures[i]), {width, height});
            if (i == 1) need_legend(histogram.by_certificate, pixels.size());
            if (i == 2) need_legend(histogram.by_error, pixels.size());
            if (i == 3) agreement_legend(histogram, pixels.size());
            if (i == 0) ImGui::Dummy({width, 5 * ImGui::GetTextLineHeightWithSpacing()});
            ImGui::EndGroup();
        }
        content = ImGui::GetCursorPosY();
        ImGui::End();
        gui.end_frame(size);
        if (frame == 0) size.y = std::min(size.y, static_cast<int>(content));
    }
    write_png(read_window(size), size.x, size.y, path);
}

}  // namespace momentscope
