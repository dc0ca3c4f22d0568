// lesson_file.hpp -- reads lessons from JSON (docs/lessons.md).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ui/model/lesson.hpp"

namespace momentscope::ui {

constexpr int LESSON_VERSION = 1;
constexpr std::uintmax_t MAX_LESSON_BYTES = 256U << 10;
constexpr std::size_t MAX_LESSON_STEPS = 30;

/// A lesson from the text of a file. Throws Error that names the file, the step and what is wrong: an unknown
/// key, a wrong type, a state that is not a session, a check that names nothing, a term that is not in the
/// glossary, another version.
Lesson lesson_from_json(const std::string& text, const std::string& file);

/// The same for a file. A scene of its sessions that is a mesh file is looked up beside the lesson.
Lesson read_lesson_file(const std::filesystem::path& path);

/// The lessons of a file, or of all .json files in a folder, in the order of their names.
struct LessonFolder {
    std::vector<Lesson> lessons;
    std::vector<std::string> problems;  // one sentence for each file that is not a lesson
};
LessonFolder read_lessons(const std::filesystem::path& file_or_folder);

}  // namespace momentscope::ui
