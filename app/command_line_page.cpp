#include "app/command_line_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/command.hpp"
#include "core/parameters/parameters.hpp"
#include "core/support/markup.hpp"

namespace momentscope {

namespace {

constexpr const char* INTRODUCTION =
    "# Command line\n\n"
    "Written by `momentscope list options --format markdown`. The program is `build/release/momentscope`; examples call it "
    "`momentscope`.\n\n"
    "- `--scene` takes the id of a scene or a mesh file (OBJ, PLY, glTF, 3DS and other formats that Assimp reads, "
    "[meshes.md](meshes.md)).\n"
    "- `--ray` takes a file with a view ray, `--session` a file that the window saved ([rays.md](rays.md)), and `--events` a "
    "file with mouse and keyboard events ([events.md](events.md)).\n"
    "- An option that would change nothing is refused. So is an output file that the command also reads.\n"
    "- If anything goes wrong, the program says so in one sentence, ends with exit code 1 and leaves existing files as they "
    "were.\n"
    "- `check-gpu` also ends with exit code 1 if it reports a difference.\n"
    "- Ctrl+C stops a command cleanly and says how much of its work is kept.\n";

bool is_parameter(const CLI::Option& option) {
    return find_parameter(option.get_name().substr(2)) != nullptr;
}

// Some commands compute a default themselves; it is in brackets at the end of the help.
std::string row_of(const CLI::Option& option) {
    const bool positional = option.get_positional();
    std::string help = option.get_description();
    std::string value = option.get_default_str();
    if (const std::size_t bracket = help.rfind(" ["); bracket != std::string::npos && help.back() == ']') {
        value = help.substr(bracket + 2, help.size() - bracket - 3);
        help.resize(bracket);
    }
    if (option.get_required()) value = "required";
    return fmt::format("| `{}` | {} | {} |\n", option.get_name(positional, !positional), markdown_cell(help),
                       markdown_cell(value));
}

// Makes a sentence of a phrase such as "draw a scene".
std::string sentence_of(std::string phrase) {
    phrase.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(phrase.front())));
    return phrase + ".";
}

std::string section_of(const CLI::App& app, const Command& command) {
    std::string text = fmt::format("\n## {}\n\n{}\n\n", command.name, sentence_of(command.help));
    for (const char* example : command.examples) text += fmt::format("    momentscope {}\n", example);
    const auto options = app.get_options();
    if (!app.get_footer().empty()) text += fmt::format("\n{}\n", app.get_footer());
    text += "\n| option | meaning | default |\n|---|---|---|\n";
    for (const CLI::Option* option : options)
        if (!is_parameter(*option) && option->get_name() != "--help") text += row_of(*option);
    if (std::ranges::any_of(options, [](const CLI::Option* o) { return is_parameter(*o); }))
        text +=
            "| [parameters](#parameters) | the parameters that the chosen techniques and pictures read | |\n";
    return text;
}

std::string parameter_section() {
    std::string text =
        "\n## Parameters\n\n"
        "Every slider of the window is an option. `momentscope list parameters --format markdown` also lists the symbols.\n\n"
        "| option | values | default | what it does |\n|---|---|---|---|\n";
    for (const Parameter& row : parameters())
        text += fmt::format("| `--{}` | {} | {} | {} |\n", row.key, markdown_cell(parameter_values_text(row)),
                            row.scale == Scale::toggle ? (row.default_value == 1.0f ? "on" : "off")
                                                       : parameter_text(row, row.default_value),
                            markdown_cell(fmt::format("{} {}", sentence_of(row.name), row.help)));
    return text;
}

}  // namespace

std::string command_line_page(const CLI::App& app) {
    std::string text = INTRODUCTION;
    for (const Command& command : command_rows())
        text += section_of(*app.get_subcommand(command.name), command);
    return text + parameter_section();
}

}  // namespace momentscope
