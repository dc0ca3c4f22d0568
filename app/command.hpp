// command.hpp -- the registry of commands of the command line. --help and docs/cli.md are made from it, and
// it decides which function runs a command.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace momentscope {

/// The files that the user named for a command. inputs: the files that the command reads. outputs: the files
/// that it writes, each with the option that names it. output_conflicts.hpp uses them to refuse an output
/// that is also an input or another output.
struct FileUse {
    std::vector<std::string> inputs = {};
    std::vector<std::pair<const char*, std::string>> outputs = {};
};

/// A command with its own options. The constructor adds the options to CLI11. When CLI11 parses the command
/// line, it sets their values. Every function may throw Error.
class ParsedCommand {
public:
    explicit ParsedCommand(CLI::App& app) : app_(app) {}
    virtual ~ParsedCommand() = default;
    ParsedCommand(const ParsedCommand&) = delete;  // CLI11 writes into this object's members
    ParsedCommand& operator=(const ParsedCommand&) = delete;

    /// Throws Error if the user gave an option that has no effect together with the other options.
    virtual void refuse_ignored() const {}
    virtual FileUse files() const { return {}; }
    virtual void run() const = 0;

protected:
    CLI::App& app() const { return app_; }

private:
    CLI::App& app_;
};

/// One row: a command and its purpose.
struct Command {
    std::string name;
    const char* help;  // a phrase, not a sentence
    std::unique_ptr<ParsedCommand> (*add)(CLI::App& app);
    std::vector<const char*> examples;  // the words after "momentscope"
};

/// All commands, in the order of --help. The first one runs if the user names no command.
std::span<const Command> command_rows();

// Declares add_render, add_inspect and so on. Each is defined in app/<name>_command.cpp.
#define COMMAND(name, ...) std::unique_ptr<ParsedCommand> add_##name(CLI::App& app);
#include "app/commands.def"
#undef COMMAND

}  // namespace momentscope
