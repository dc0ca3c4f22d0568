// file_dialog.hpp -- a file browser inside the window, for opening and saving.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// One kind of file that a dialog offers.
struct FileKind {
    const char* id;
    const char* name;
    const char* extension;  // ".json"; "" for any
};

/// The working folder, or the root if that folder was deleted.
std::filesystem::path working_folder();

class FileDialog {
public:
    enum class Mode { open, save };

    /// shows_folders: false if files have no place that the user could see, as in a browser. Then it only
    /// asks for a name.
    explicit FileDialog(bool shows_folders) : shows_folders_(shows_folders) {}

    /// Opens in the folder of the last time; at first in the working folder.
    void open(Mode mode, const char* title, std::vector<FileKind> kinds, const std::string& suggested_name);

    struct Choice {
        std::filesystem::path path;
        const FileKind* kind;
    };
    /// Draws the dialog if it is open. Returns the choice in the frame in which it was made.
    std::optional<Choice> draw(const Ui& ui);
    bool is_open() const { return open_; }

private:
    struct Entry {
        std::string name;
        bool folder;
        std::uintmax_t bytes;
    };
    void read_folder();
    void enter(const std::filesystem::path& folder);
    void choose_kind(std::size_t kind);
    void draw_entries(const Ui& ui, bool& accept);
    void draw_kinds(const Ui& ui);
    void draw_answer(const Ui& ui, bool& accept, bool& cancel);
    std::optional<Choice> accept();

    bool shows_folders_;
    bool open_ = false;
    bool begin_ = false;
    bool just_entered_ = false;  // the last click entered a folder
    Mode mode_ = Mode::open;
    std::string title_;
    std::vector<FileKind> kinds_;
    std::size_t kind_ = 0;
    std::filesystem::path folder_ = working_folder();
    std::vector<Entry> entries_;
    std::string name_;
    std::string problem_;
    std::string confirmed_;  // the existing file that the next click on Save replaces
};

}  // namespace momentscope::ui
