#include "app/output_conflicts.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/support/error.hpp"
#include "core/support/reachable.hpp"

namespace momentscope {

std::vector<std::string> files_of(const FileUse& use) {
    std::vector<std::string> files;
    for (const std::string& input : use.inputs)
        if (!input.empty()) files.push_back(input);
    for (const auto& [option, path] : use.outputs)
        if (!path.empty()) files.push_back(path);
    return files;
}

void refuse_outputs_that_are_inputs(const FileUse& use) {
    for (const auto& [option, path] : use.outputs) {
        if (path.empty()) continue;
        for (const std::string& input : use.inputs)
            if (!input.empty() && same_file(path, input))
                throw Error(fmt::format(
                    "'{}' is read by this command and would be overwritten; give {} another name.", path,
                    option));
        for (const auto& [other, other_path] : use.outputs)
            if (std::string_view(option) != other && !other_path.empty() && same_file(path, other_path))
                throw Error(
                    fmt::format("{} and {} are the same file '{}'; give two names.", option, other, path));
    }
}

}  // namespace momentscope
