// output_conflicts.hpp -- a file that a command reads is not one that it may write.
#pragma once
#include "app/command.hpp"

namespace momentscope {

/// All files of a command: those to read and those to write. Outputs without a name are none.
std::vector<std::string> files_of(const FileUse& use);

/// Throws Error when an output is a file that the command reads, or when two outputs are one.
void refuse_outputs_that_are_inputs(const FileUse& use);

}  // namespace momentscope
