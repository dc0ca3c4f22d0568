// command_line_page.hpp -- docs/cli.md: the commands and their options, with the same texts as --help.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace momentscope {

/// Returns the page as Markdown. `app` is the whole command line with the commands of command_rows().
std::string command_line_page(const CLI::App& app);

}  // namespace momentscope
