#include "ui/widgets/file_dialog.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "ui/widgets/shortcut.hpp"

namespace momentscope::ui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t MAX_ENTRIES = 5000;  // nobody scrolls through more

std::string size_text(std::uintmax_t bytes) {
    if (bytes < 1000) return fmt::format("{} B", bytes);
    if (bytes < 1'000'000) return fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3);
    return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

}  // namespace

fs::path working_folder() {
    std::error_code code;
    const fs::path folder = fs::current_path(code);
    return code ? fs::path("/") : folder;
}

void FileDialog::open(Mode mode, const char* title, std::vector<FileKind> kinds,
                      const std::string& suggested_name) {
    mode_ = mode;
    title_ = title;
    kinds_ = std::move(kinds);
    kind_ = 0;
    name_ = suggested_name;
    problem_.clear();
    confirmed_.clear();
    open_ = begin_ = true;
    enter(folder_);
}

void FileDialog::enter(const fs::path& folder) {
    std::error_code status;
    const fs::path canonical = fs::weakly_canonical(folder, status);
    folder_ = status ? folder : canonical;
    read_folder();
}

void FileDialog::read_folder() {
    entries_.clear();
    std::error_code status;
    const std::string extension = kinds_[kind_].extension;
    for (fs::directory_iterator at(folder_, status), end;
         !status && at != end && entries_.size() < MAX_ENTRIES; at.increment(status)) {
        std::error_code of_entry;
        const bool folder = at->is_directory(of_entry);
        const std::string name = at->path().filename().string();
        if (name.starts_with(".")) continue;
        if (!folder && !extension.empty() && at->path().extension() != extension) continue;
        const std::uintmax_t bytes = folder ? 0 : at->file_size(of_entry);
        entries_.push_back({name, folder, of_entry ? 0 : bytes});
    }
    problem_ = status ? fmt::format("The folder '{}' cannot be read.", folder_.string()) : "";
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
}

void FileDialog::choose_kind(std::size_t kind) {
    kind_ = kind;
    if (mode_ == Mode::save && !name_.empty())
        name_ = fs::path(name_).replace_extension(kinds_[kind].extension).string();
    read_folder();
}

void FileDialog::draw_entries(const Ui& ui, bool& accept) {
    const ImVec2 size = {
        0, std::max(ImGui::GetContentRegionAvail().y - 4.6f * ImGui::GetFrameHeightWithSpacing(), 4 * em())};
    ImGui::BeginChild("entries", size, true);
    if (ImGui::Selectable("../", false)) enter(folder_.parent_path());
    ui.record_widget_rect("file.parent");
    std::optional<fs::path> entered;
    for (const Entry& entry : entries_) {
        const std::string label = entry.folder ? entry.name + "/" : entry.name;
        if (ImGui::Selectable(label.c_str(), name_ == entry.name, ImGuiSelectableFlags_AllowDoubleClick)) {
            // A double-click on a folder enters it with the first click. The second click then hits a row of
            // the new list, so ignore it.
            const bool second = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
            if (second && just_entered_) continue;
            just_entered_ = entry.folder;
            if (entry.folder)
                entered = folder_ / entry.name;
            else
                name_ = entry.name;
            accept |= !entry.folder && second;
        }
        ui.record_widget_rect("file.entry." + entry.name);
        if (!entry.folder) {
            ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 6 * em());
            ImGui::TextDisabled("%s", size_text(entry.bytes).c_str());
        }
    }
    if (entries_.empty()) ImGui::TextDisabled("There are no files of this kind here.");
    ImGui::EndChild();
    if (entered) enter(*entered);
}

// Enters a folder or chooses a file. Explains why if neither is possible.
std::optional<FileDialog::Choice> FileDialog::accept() {
    if (name_.empty()) {
        problem_ = "Type the name of a file, or click one.";
        return std::nullopt;
    }
    const fs::path path = folder_ / name_;  // an absolute name replaces the folder
    std::error_code status;
    if (fs::is_directory(path, status)) {
        name_.clear();
        enter(path);
        return std::nullopt;
    }
    if (mode_ == Mode::open && !fs::exists(path, status)) {
        problem_ = fmt::format("There is no file '{}'.", path.string());
        return std::nullopt;
    }
    if (mode_ == Mode::open) return Choice{path, &kinds_[kind_]};
    fs::path target = shows_folders_ ? path : folder_ / path.filename();
    if (target.extension() != kinds_[kind_].extension) target += kinds_[kind_].extension;
    try {
        require_writable(target);
    } catch (const Error& error) {
        problem_ = error.what();
        return std::nullopt;
    }
    if (shows_folders_ && fs::exists(target, status) && confirmed_ != target.string()) {
        confirmed_ = target.string();
        problem_ = fmt::format("'{}' exists; press Save again to replace it.", target.filename().string());
        return std::nullopt;
    }
    return Choice{target, &kinds_[kind_]};
}

void FileDialog::draw_kinds(const Ui& ui) {
    if (kinds_.size() < 2) return;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##kind", kinds_[kind_].name)) {
        for (std::size_t i = 0; i < kinds_.size(); ++i) {
            if (ImGui::Selectable(kinds_[i].name, i == kind_)) choose_kind(i);
            ui.record_widget_rect(fmt::format("file.kind.{}", kinds_[i].id));
        }
        ImGui::EndCombo();
    }
    ui.record_widget_rect("file.kind");
    tooltip("The kind of file to write.");
}

// Draws the name field and the two buttons.
void FileDialog::draw_answer(const Ui& ui, bool& accept, bool& cancel) {
    ImGui::SetNextItemWidth(-1);
    if (begin_) ImGui::SetKeyboardFocusHere();
    begin_ = false;
    accept |= ImGui::InputTextWithHint("##name",
                                       shows_folders_ ? "name of the file, or a path" : "name of the file",
                                       &name_, ImGuiInputTextFlags_EnterReturnsTrue);
    ui.record_widget_rect("file.name");
    tooltip(shows_folders_ ? "A name in this folder, or a full path."
                           : "The name under which your browser saves the file.");
    accept |= ImGui::Button(mode_ == Mode::save ? "Save" : "Open", {6 * em(), 0});
    ui.record_widget_rect("file.accept");
    tooltip(mode_ == Mode::save ? "Writes the file." : "Opens the file, or enters the folder.", "Enter");
    ImGui::SameLine();
    cancel |= ImGui::Button("Cancel", {6 * em(), 0}) || pressed({.key = 256});
    ui.record_widget_rect("file.cancel");
    tooltip("Closes the dialog without a change.", "Escape");
}

std::optional<FileDialog::Choice> FileDialog::draw(const Ui& ui) {
    if (!open_) return std::nullopt;
    const std::string label = title_ + "###file";
    if (begin_) ImGui::OpenPopup(label.c_str());
    const ImVec2 room = ImGui::GetMainViewport()->Size;
    const float height = shows_folders_ ? 30 * em() : 11 * em();
    ImGui::SetNextWindowSize({std::min(38 * em(), 0.95f * room.x), std::min(height, 0.95f * room.y)});
    ImGui::SetNextWindowPos({0.5f * room.x, 0.5f * room.y}, ImGuiCond_Always, {0.5f, 0.5f});
    open_ = ImGui::BeginPopupModal(label.c_str(), nullptr,
                                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
    if (!open_) return std::nullopt;
    std::optional<Choice> choice;
    bool wanted = false;
    bool cancelled = false;
    if (shows_folders_) {
        ImGui::TextWrapped("%s", folder_.c_str());
        draw_entries(ui, wanted);
    }
    draw_kinds(ui);
    draw_answer(ui, wanted, cancelled);
    if (wanted) choice = accept();
    if (!problem_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.colors.warning);
        ImGui::TextWrapped("%s", problem_.c_str());
        ImGui::PopStyleColor();
    }
    open_ = !choice && !cancelled;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return choice;
}

}  // namespace momentscope::ui
