// command_line_page.hpp -- docs/cli.md: the commands with their options, as --help has them.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace momentscope {

/// `app` is the whole command line with the commands of command_rows(). Markdown.
std::string command_line_page(const CLI::App& app);

}  // namespace momentscope
