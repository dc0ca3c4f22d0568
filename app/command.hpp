// command.hpp -- the registry of commands of the command line: --help, docs/cli.md and the dispatch follow
// from it.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace momentscope {

/// The files that a command was told of, so that none is lost: those it reads, and those it writes with the
/// option that names them.
struct FileUse {
    std::vector<std::string> inputs = {};
    std::vector<std::pair<const char*, std::string>> outputs = {};
};

/// A command with its own options, which its constructor adds to CLI11; they have their values once the words
/// are parsed. All functions throw Error.
class ParsedCommand {
public:
    explicit ParsedCommand(CLI::App& app) : app_(app) {}
    virtual ~ParsedCommand() = default;
    ParsedCommand(const ParsedCommand&) = delete;  // CLI11 writes into the members
    ParsedCommand& operator=(const ParsedCommand&) = delete;

    /// Throws Error if an option was typed that would change nothing beside the others.
    virtual void refuse_ignored() const {}
    virtual FileUse files() const { return {}; }
    virtual void run() const = 0;

protected:
    CLI::App& app() const { return app_; }

private:
    CLI::App& app_;
};

/// One row: a command and what it is for.
struct Command {
    const char* name;
    const char* help;  // a phrase
    std::unique_ptr<ParsedCommand> (*add)(CLI::App& app);
    std::vector<const char*> examples;  // what to type behind "momentscope"
};

/// In the order of --help. The first one runs where no command is named.
std::span<const Command> command_rows();

// add_render and the like: each in a file of its own.
#define COMMAND(name, ...) std::unique_ptr<ParsedCommand> add_##name(CLI::App& app);
#include "app/commands.def"
#undef COMMAND

}  // namespace momentscope
