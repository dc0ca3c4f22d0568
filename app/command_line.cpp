#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>
#include <sstream>
#include <system_error>

#include "app/command.hpp"
#include "app/end_by_signal.hpp"
#include "app/ignored_options.hpp"
#include "app/output_conflicts.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr const char* ABOUT = "Momentscope: an oscilloscope for moment-based order-independent transparency.";

std::string typed_name(std::string name) {
    std::ranges::replace(name, '_', '-');
    return name;
}

const std::vector<Command> COMMANDS = {
#define EXAMPLES(...) \
    { __VA_ARGS__ }
#define COMMAND(name, help, examples) {typed_name(#name), help, add_##name, examples},
#include "app/commands.def"
#undef COMMAND
#undef EXAMPLES
};

/// All commands with their options. The options of the window also work without the name of a command.
struct CommandLine {
    CLI::App app{ABOUT, "momentscope"};
    std::unique_ptr<ParsedCommand> without_name;
    std::vector<std::pair<CLI::App*, std::unique_ptr<ParsedCommand>>> named;

    CommandLine() : without_name(COMMANDS.front().add(app)) {
        for (const Command& command : COMMANDS) {
            CLI::App* const sub = app.add_subcommand(command.name, command.help);
            named.emplace_back(sub, command.add(*sub));
        }
        app.require_subcommand(0, 1);
        refuse_empty_values(app);
        for (const auto& [sub, command] : named) refuse_empty_values(*sub);
    }

    const ParsedCommand& chosen() const {
        for (const auto& [sub, command] : named)
            if (sub->parsed()) return *command;
        return *without_name;
    }
};

void refuse_window_options_before(const CLI::App& app, const std::string& command) {
    for (const CLI::Option* option : app.get_options())
        if (option->count() > 0)
            throw Error(fmt::format(
                "{} stands before '{}' and would apply to the window; write it after the command.",
                option->get_name(), command));
}

int fail(const std::string& sentence) {
    warn(sentence);
    return 1;
}

void parse_and_run(int argc, const char* const* argv) {
    refuse_empty_assignments(argc, argv);
    CommandLine line;
    CLI::App& app = line.app;
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        std::ostringstream text;
        app.exit(help, text, text);
        print(text.str());
        return require_printed();
    } catch (const CLI::ParseError& error) {
        throw Error(fmt::format("{}; momentscope --help lists commands and options.", error.what()));
    }
    const auto chosen = app.get_subcommands();
    refuse_empty_switches(chosen.empty() ? app : *chosen.front());
    if (!chosen.empty()) refuse_window_options_before(app, chosen.front()->get_name());
    line.chosen().refuse_ignored();
    refuse_outputs_that_are_inputs(line.chosen().files());
    line.chosen().run();
    require_printed();
}

}  // namespace

std::span<const Command> command_rows() {
    return COMMANDS;
}

int run_command_line(int argc, const char* const* argv) {
    occupy_closed_streams();
    end_cleanly_on_signals();
    std::signal(SIGXFSZ, SIG_IGN);  // writing beyond the file size limit then fails like on a full disk
    try {
        parse_and_run(argc, argv);
        return 0;
    } catch (const Interrupted& end) {
        fail(end.what());
        std::fflush(stdout);
        end_by_signal(end.signal);
    } catch (const Error& error) {
        return fail(error.what());
    } catch (const std::bad_alloc&) {
        return fail("Memory ran out; try a smaller --size or a smaller scene.");
    } catch (const std::system_error& error) {  // for instance, no thread can be started
        return fail(fmt::format(
            "The system refuses a resource that the program needs ({}); close other programs, or check limits.",
            error.code().message()));
    } catch (const std::exception& error) {  // even an unforeseen exception ends with a sentence
        return fail(
            fmt::format("Something failed that should not fail: {}; please report it.", error.what()));
    }
}

}  // namespace momentscope
