// command.hpp -- the registry of commands of the command line. --help, docs/cli.md and the dispatch are built
// from it.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace momentscope {

/// The files that the user named for a command: the files it reads, and the files it writes, each with the
/// option that names it. The check against overwriting inputs uses them.
struct FileUse {
    std::vector<std::string> inputs = {};
    std::vector<std::pair<const char*, std::string>> outputs = {};
};

/// A command with its own options. The constructor adds the options to CLI11, and parsing the words sets
/// their values. All functions throw Error.
class ParsedCommand {
public:
    explicit ParsedCommand(CLI::App& app) : app_(app) {}
    virtual ~ParsedCommand() = default;
    ParsedCommand(const ParsedCommand&) = delete;  // CLI11 writes into the members
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
    const char* name;
    const char* help;  // a phrase, not a sentence
    std::unique_ptr<ParsedCommand> (*add)(CLI::App& app);
    std::vector<const char*> examples;  // the words after "momentscope"
};

/// In the order of --help. The first command runs if the user names none.
std::span<const Command> command_rows();

// add_render and the like: each in a file of its own.
#define COMMAND(name, ...) std::unique_ptr<ParsedCommand> add_##name(CLI::App& app);
#include "app/commands.def"
#undef COMMAND

}  // namespace momentscope
