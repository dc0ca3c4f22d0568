// progress.hpp -- what a student has done of the lessons, and what they answered.
#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "ui/model/lesson.hpp"

namespace momentscope::ui {

struct StepProgress {
    bool done = false;
    int tries = 0;       // answers that were checked
    std::string answer;  // the last one, as typed, chosen or written
    friend bool operator==(const StepProgress&, const StepProgress&) = default;
};

/// By id of a lesson and index of a step.
class Progress {
public:
    /// Empty for a step that was never tried.
    const StepProgress& of(const std::string& lesson, std::size_t step) const;
    StepProgress& of(const std::string& lesson, std::size_t step);

    /// Are all steps with checks done?
    bool is_done(const Lesson& lesson) const;
    bool empty() const { return lessons_.empty(); }

    friend bool operator==(const Progress&, const Progress&) = default;
    friend nlohmann::ordered_json progress_to_json(const Progress& progress);
    friend Progress progress_from_json(const std::string& text);
    friend std::string answers_text(std::span<const Lesson> lessons, const Progress& progress);

private:
    std::map<std::string, std::vector<StepProgress>> lessons_;
};

constexpr std::uintmax_t MAX_PROGRESS_BYTES = 4U << 20;

nlohmann::ordered_json progress_to_json(const Progress& progress);

/// Throws Error if the text does not hold progress.
Progress progress_from_json(const std::string& text);

/// The answers for a teacher, as Markdown: each lesson that was begun, its questions, the answers and the
/// numbers of tries.
std::string answers_text(std::span<const Lesson> lessons, const Progress& progress);

}  // namespace momentscope::ui
