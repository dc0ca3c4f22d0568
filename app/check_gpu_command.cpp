#include <fmt/format.h>

#include "app/command.hpp"
#include "app/gl_context.hpp"
#include "app/options.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/bench/gpu_check_report.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"

namespace momentscope {

namespace {

class CheckGpuCommand : public ParsedCommand {
public:
    explicit CheckGpuCommand(CLI::App& app) : ParsedCommand(app) {
        add_gl(app, "auto");
        add_parsed<bool>(app, "--format", json_, "text or json [text]", [](const std::string& text) {
            if (text != "text" && text != "json")
                throw Error(fmt::format("'{}' is not a format; choose text or json.", text));
            return text == "json";
        });
        add_count(app, "--seconds", seconds_, "the time after which techniques are left out",
                  {"number of seconds", 1, 3600});
        app.add_option("-o,--output", output_, "a file for the report: .txt or .json");
    }

    FileUse files() const override { return {{}, {{"-o", output_}}}; }

    void run() const override {
        const bool json_file = ends_in(output_, ".json");
        if (!output_.empty() && !json_file && !ends_in(output_, ".txt"))
            throw Error(fmt::format("'{}' ends in neither .txt nor .json; give -o such a name.", output_));
        if (!output_.empty()) require_writable(output_);
        const GpuCheck check = measure();
        const std::string kind = headless_gl_key();
        const auto report = [&](bool as_json) {
            return as_json ? gpu_check_json(check, kind) : gpu_check_text(check, kind);
        };
        if (!output_.empty()) write_file(report(json_file), output_);
        print(report(json_));
        if (!check.passed()) throw Error("This GL does not draw what C++ computes; the report says where.");
    }

private:
    GpuCheck measure() const {
        prefer_headless_gl("auto");
        Progress progress("The check");
        const auto context = make_headless_context({16, 16});
        const auto programs = std::make_shared<ProgramCache>();
        GpuCheckPlan plan = full_gpu_check();
        plan.limit = std::chrono::seconds(seconds_);
        std::size_t done = 0;
        GpuCheck check = check_gpu(plan, programs, progress.stop(),
                                   [&] { progress.show(++done, plan.techniques.size()); });
        progress.require_finished();
        return check;
    }

    bool json_ = false;
    int seconds_ = 55;
    std::string output_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_check_gpu(CLI::App& app) {
    return std::make_unique<CheckGpuCommand>(app);
}

}  // namespace momentscope
