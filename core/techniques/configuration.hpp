// configuration.hpp -- a technique with values of its parameters, as one text: at:nodes=8.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/techniques/technique.hpp"

namespace momentscope {

/// What a picture is drawn by, beside the scene. Values of parameters that the technique does not read are
/// there, too, but mean nothing.
struct Configuration {
    const Technique* technique = nullptr;
    ParameterValues values;
};

/// The technique's id, and behind a colon those of its own parameters that are not at their standard:
/// "mt:resolution=half,read-format=theta16". Configurations with equal texts draw equal pictures.
std::string configuration_text(const Configuration& configuration);

/// The same as options of the command line: "--technique mt --resolution half".
std::string configuration_options(const Configuration& configuration);

/// How often the transparent geometry is drawn; 0 where that grows with the layers.
int geometry_passes(const Configuration& configuration);

/// What a text means; what it does not name has the value in `base`. Throws Error for unknown ids, parameters
/// that the technique does not read, their wrong values, and values that make no sense together.
Configuration parse_configuration(std::string_view text, const ParameterValues& base = {});

/// Texts between commas. A part with `=` and without a colon goes on with the parameters of the one before
/// it.
std::vector<std::string> split_configurations(std::string_view list);

}  // namespace momentscope
