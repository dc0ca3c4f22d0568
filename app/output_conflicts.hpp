// output_conflicts.hpp -- a file that a command reads is not one that it may write.
#pragma once
#include <string>
#include <vector>

#include "app/options.hpp"

namespace momentscope {

/// The files that the command line names, but the folder of figures: those to read and those to write.
std::vector<std::string> files_of(const Options& options);

/// Throws Error when -o, --screenshot or --log is a file that the command reads, or when two of them are one.
void refuse_outputs_that_are_inputs(const Options& options);

}  // namespace momentscope
