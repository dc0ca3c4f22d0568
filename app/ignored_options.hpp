// ignored_options.hpp -- refuses options that were typed but would change nothing.
#pragma once
#include <initializer_list>
#include <span>
#include <vector>

#include "app/options.hpp"

namespace momentscope {

/// An option, whether the command would ignore it, and the end of the sentence that explains why.
struct Ignored {
    const char* option;
    bool when;
    const char* why;
};

/// Throws Error for the first of these options that was typed and would be ignored.
void refuse_ignored_options(const CLI::App& command, std::initializer_list<Ignored> rows);

/// The parameters that a command reads.
struct ParameterReading {
    std::vector<const Technique*> techniques;
    std::vector<ParameterId> others = {};  // that the command reads itself
    bool picture = false;                  // it draws shaded colours
    bool order = false;                    // it depends on the order of submission
    bool tone_map = false;
    bool mesh = false;  // it reads a mesh file, which has no opacities of its own
};

/// Throws Error for the first parameter that was typed and is not read.
void refuse_ignored_parameters(const ParameterOptions& typed, const ParameterReading& reading);

/// Helpers for a ParameterReading: the techniques of configurations, and the parameters of moments and
/// reconstruction that techniques read.
std::vector<const Technique*> techniques_in(const std::vector<Configuration>& configurations);
std::vector<ParameterId> reconstruction_parameters(const std::vector<const Technique*>& techniques);

/// Throws Error if the values make no sense together for one of the techniques.
void refuse_nonsense(std::span<const Technique* const> techniques, const ParameterValues& values);

bool ends_in(const std::string& path, const char* extension);

/// `--shadows` without a value switches shadows on. Throws Error for `--shadows ''`, which is a mistake.
void refuse_empty_switches(const CLI::App& command);

/// Makes parsing refuse an empty value of these options.
void refuse_empty_values(CLI::App& command);

/// Throws Error for "--option=" without a value. Call it before the words are parsed.
void refuse_empty_assignments(int argc, const char* const* argv);

}  // namespace momentscope
