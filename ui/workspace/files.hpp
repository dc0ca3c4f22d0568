// files.hpp -- the files that the window opens and saves.
#pragma once
#include "ui/widgets/file_dialog.hpp"

namespace momentscope::ui {

struct Workspace;

class Files {
public:
    void open_session();
    void save_session();
    void open_mesh();
    void open_ray();
    void save_export();
    void save_chart();
    bool is_open() const { return dialog_.is_open(); }

    /// Draws the dialog if it is open, and uses the chosen file. The status line reports success or
    /// failure.
    void draw(const Ui& ui, Workspace& workspace);

    /// The file to which this frame of the window shall be written; nullopt if there is none. Call this
    /// function exactly once per frame, because it counts the frames until the export.
    std::optional<std::filesystem::path> take_window_export();

private:
    enum class Purpose { open_session, save_session, open_mesh, open_ray, save_export, save_chart };

    void use(const FileDialog::Choice& choice, Workspace& workspace);
    void write_export(const FileDialog::Choice& choice, Workspace& workspace);

    FileDialog dialog_;
    Purpose purpose_ = Purpose::open_session;
    std::optional<std::filesystem::path> window_export_;
    int frames_to_export_ = 0;
};

}  // namespace momentscope::ui
