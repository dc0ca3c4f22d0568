#include "app/output_conflicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/error.hpp"
#include "core/reachable.hpp"

namespace momentscope {

namespace {

using Named = std::pair<const char*, const std::string&>;  // an option and its value

std::vector<Named> outputs_of(const Options& options) {
    std::vector<Named> outputs;
    for (const Named& one : {Named("-o", options.output), Named("--screenshot", options.screenshot),
                             Named("--log", options.log)})
        if (!one.second.empty()) outputs.push_back(one);
    return outputs;
}

std::vector<std::string> inputs_of(const Options& options) {
    std::vector<std::string> inputs = options.files;
    inputs.insert(inputs.end(), options.pictures.begin(), options.pictures.end());
    for (const std::string* one : {&options.ray, &options.session, &options.events, &options.chart})
        if (!one->empty()) inputs.push_back(*one);
    if (is_builtin_scene(options.scene)) return inputs;
    inputs.push_back(options.scene);  // a mesh, or the scenes of a chart
    for (const std::string& scene : split_list({options.scene}))
        if (!is_builtin_scene(scene)) inputs.push_back(scene);
    return inputs;
}

}  // namespace

std::vector<std::string> files_of(const Options& options) {
    std::vector<std::string> files = inputs_of(options);
    for (const Named& output : outputs_of(options)) files.push_back(output.second);
    return files;
}

void refuse_outputs_that_are_inputs(const Options& options) {
    const std::vector<Named> outputs = outputs_of(options);
    for (const auto& [option, path] : outputs) {
        for (const std::string& input : inputs_of(options))
            if (same_file(path, input))
                throw Error(fmt::format(
                    "'{}' is read by this command and would be lost; give {} another name.", path, option));
        for (const auto& [other, other_path] : outputs)
            if (std::string_view(option) != other && same_file(path, other_path))
                throw Error(
                    fmt::format("{} and {} are the same file '{}'; give two names.", option, other, path));
    }
}

}  // namespace momentscope
