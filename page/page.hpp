// page.hpp -- the window of ui/ on the canvas of a page.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "core/render/renderer.hpp"
#include "ui/window/explorer.hpp"
#include "ui/window/frame_need.hpp"
#include "ui/window/input_queue.hpp"

namespace momentscope {

/// Makes the WebGL context of the canvas current. Throws Error that says what the browser lacks.
void make_web_context();

/// Does again what a context needs that has been lost and restored.
void prepare_web_context();

class Page {
public:
    /// size: of the canvas in pixels. scale: pixels of the screen per pixel of the page. The context must be
    /// current.
    Page(const ui::ExplorerState& start, const ui::Embedding& embedding, glm::ivec2 size, float scale);
    ~Page();
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;

    /// Draws a frame if one is due. True if it drew. seconds: since the last call.
    bool frame(double seconds);

    /// Is a frame due without further input?
    bool due() const { return !input_.empty() || need_.due(*explorer_); }

    void resize(glm::ivec2 size, float scale);
    void push(const ui::InputQueue::Event& event) { input_.push(event); }

    /// The link of the state that the last frame showed, if it is another step than the last time; or "".
    std::string take_step();

    /// Shows another state. It does not count as a step, because it has a link already.
    void open(const ui::ExplorerState& state);

    const std::shared_ptr<ProgramCache>& programs() const { return renderer_->programs(); }
    ui::Workspace& workspace() { return explorer_->workspace(); }

private:
    void use_scale();
    void write_window(const std::filesystem::path& path);

    glm::ivec2 size_;
    float own_scale_, scale_;  // of the screen; as it is drawn
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<ui::Explorer> explorer_;
    ui::InputQueue input_;
    ui::FrameNeed need_;
    ui::ExplorerState linked_;  // of which the scripts have the link
};

}  // namespace momentscope
