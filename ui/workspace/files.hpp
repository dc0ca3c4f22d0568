// files.hpp -- the files that the window opens and saves.
#pragma once
#include "ui/widgets/file_dialog.hpp"
#include "ui/workspace/host.hpp"

namespace momentscope::ui {

struct Workspace;

class Files {
public:
    explicit Files(const Host& host) : host_(host), dialog_(host.shows_folders()) {}

    void open_session();
    void save_session();
    void open_mesh();
    void open_ray();
    void open_lesson();
    void save_answers();
    void save_export();
    void save_chart();
    bool is_open() const { return dialog_.is_open(); }

    /// Opens the file that the host let the user choose.
    void open_chosen(const std::filesystem::path& path) { chosen_ = {path, nullptr}; }

    /// Opens a file that was dropped on the window: a view ray, a session, a lesson or a mesh, or a folder of
    /// lessons.
    void open_dropped(const std::filesystem::path& path);

    /// Draws the dialog if it is open, and uses the chosen file. The status line reports success or
    /// failure.
    void draw(const Ui& ui, Workspace& workspace);

    /// The file to which this frame of the window shall be written; nullopt if there is none. Call this
    /// function exactly once per frame, because it counts the frames until the export.
    std::optional<std::filesystem::path> take_window_export();

    /// Tells the user that the window was written to this file.
    void window_written(const std::filesystem::path& path, Workspace& workspace) const {
        say_written(path, workspace);
    }

private:
    enum class Purpose {
        open_session,
        save_session,
        open_mesh,
        open_ray,
        open_json,
        open_lesson,
        save_answers,
        save_export,
        save_chart
    };

    void open(Purpose purpose, const char* title, const FileKind& kind);
    void say_written(const std::filesystem::path& path, Workspace& workspace) const;
    void use(const FileDialog::Choice& choice, Workspace& workspace);
    void write_export(const FileDialog::Choice& choice, Workspace& workspace);

    const Host& host_;
    FileDialog dialog_;
    std::optional<FileDialog::Choice> chosen_;
    Purpose purpose_ = Purpose::open_session;
    std::optional<std::filesystem::path> window_export_;
    int frames_to_export_ = 0;
};

}  // namespace momentscope::ui
