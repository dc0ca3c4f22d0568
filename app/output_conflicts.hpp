// output_conflicts.hpp -- makes sure that a command does not overwrite a file that it reads.
#pragma once
#include "app/command.hpp"

namespace momentscope {

/// All files of a command, inputs and outputs. Outputs without a name are left out.
std::vector<std::string> files_of(const FileUse& use);

/// Throws Error if an output is a file that the command reads, or if two outputs are the same file.
void refuse_outputs_that_are_inputs(const FileUse& use);

}  // namespace momentscope
