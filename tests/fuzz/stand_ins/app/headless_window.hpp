// headless_window.hpp -- replaces app/headless_window.hpp, so that the player of event files runs without GL:
// a window that draws nothing and has two controls.
#pragma once
#include <glm/glm.hpp>
#include <string>

#include "core/render/view.hpp"
#include "ui/model/state.hpp"
#include "ui/model/status.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope {

class HeadlessWindow {
public:
    struct Log {
        void line(const std::string& /*text*/) {}
        long frames() const { return 0; }
    };
    struct Files {
        void open_dropped(const std::string& /*path*/) const {}
    };
    struct Workspace {
        Files files;
        ui::WidgetRects widget_rects;
        ui::ExplorerState state;
        ui::Status status{"The scene was read.", "", std::nullopt};
    };
    struct Explorer {
        Workspace shown;
        const Workspace& workspace() const { return shown; }
    };

    HeadlessWindow() {
        explorer_.shown.widget_rects = {{"scene", {{0, 0}, {640, 400}}}, {"tab.1", {{640, 0}, {700, 20}}}};
    }

    bool step_is_done() const { return false; }
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
