// configuration.hpp -- a technique with values of its parameters, written as one text: at:nodes=8.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/techniques/technique.hpp"

namespace momentscope {

/// How a picture of a scene is drawn. `values` has all parameters; those that the technique does not read
/// mean nothing.
struct Configuration {
    const Technique* technique = nullptr;
    ParameterValues values;
};

/// The id of the technique and, after a colon, those of its parameters that do not have their default values:
/// "mt:resolution=half,read-format=theta16". Configurations with equal texts draw equal pictures.
std::string configuration_text(const Configuration& configuration);

/// The same as options of the command line: "--technique mt --resolution half".
std::string configuration_options(const Configuration& configuration);

/// How often the transparent geometry is drawn; 0 if that grows with the number of layers.
int geometry_passes(const Configuration& configuration);

/// The configuration that a text means. Parameters that it does not name have their values in `base`. Throws
/// Error for unknown ids, for parameters that the technique does not read, for wrong values, and for values
/// that make no sense together.
Configuration parse_configuration(std::string_view text, const ParameterValues& base = {});

/// Splits a list at its commas. A part with `=` and without a colon belongs to the configuration before it,
/// as another parameter.
std::vector<std::string> split_configurations(std::string_view list);

}  // namespace momentscope
