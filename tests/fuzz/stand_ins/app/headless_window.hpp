// headless_window.hpp -- replaces app/headless_window.hpp, so that the player of event files runs without GL:
// a window that draws nothing and has two controls.
#pragma once
#include <glm/glm.hpp>
#include <string>

#include "core/render/view.hpp"
#include "ui/state.hpp"
#include "ui/ui.hpp"

namespace momentscope {

class HeadlessWindow {
public:
    struct Log {
        void line(const std::string& /*text*/) {}
        long frames() const { return 0; }
    };
    struct Explorer {
        ui::WidgetRects shown;
        ui::ExplorerState chosen;
        std::string said = "The scene was read.";

        const ui::WidgetRects& widget_rects() const { return shown; }
        const ui::ExplorerState& state() const { return chosen; }
        const std::string& message() const { return said; }
    };

    HeadlessWindow() {
        explorer_.shown = {{"scene", {{0, 0}, {640, 400}}}, {"tab.1", {{640, 0}, {700, 20}}}};
    }

    void settle() { ImGui::GetIO().ClearInputCharacters(); }
    void idle() {}
    void pass(float /*seconds*/) {}
    void resize(glm::ivec2 /*size*/) {}
    void write_png(const std::string& /*path*/) const {}
    const Explorer& explorer() const { return explorer_; }
    Log& log() { return log_; }

private:
    Explorer explorer_;
    Log log_;
};

}  // namespace momentscope
