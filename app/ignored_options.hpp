// ignored_options.hpp -- options that were typed and would change nothing.
#pragma once
#include <initializer_list>
#include <vector>

#include "app/options.hpp"

namespace momentscope {

/// An option, whether the command would ignore it, and the end of the sentence that says so.
struct Ignored {
    const char* option;
    bool when;
    const char* why;
};

/// Throws Error with the first of these that was typed and would be ignored.
void refuse_ignored_options(const CLI::App& command, std::initializer_list<Ignored> rows);

/// What a command reads of the parameters.
struct ParameterReading {
    std::vector<const Technique*> techniques;
    std::vector<ParameterId> others = {};  // that it reads itself
    bool picture = false;                  // shaded colours
    bool order = false;                    // of submission
    bool tone_map = false;
    bool mesh = false;  // is there a mesh file, which has no opacity of its own?
};

/// Throws Error with the first parameter that was typed and is not read.
void refuse_ignored_parameters(const ParameterOptions& typed, const ParameterReading& reading);

/// For a reading: the techniques of configurations, and the parameters of moments and reconstruction that
/// techniques read.
std::vector<const Technique*> techniques_in(const std::vector<Configuration>& configurations);
std::vector<ParameterId> reconstruction_parameters(const std::vector<const Technique*>& techniques);

bool ends_in(const std::string& path, const char* extension);

/// `--shadows` alone switches on; throws Error for `--shadows ''`, which is a mistake.
void refuse_empty_switches(const CLI::App& command);

/// From now on parsing refuses an empty value of these options.
void refuse_empty_values(CLI::App& command);

/// Throws Error for "--option=" without a value. To be called before the words are parsed.
void refuse_empty_assignments(int argc, const char* const* argv);

}  // namespace momentscope
