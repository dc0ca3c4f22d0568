// ignored_options.hpp -- options that were typed and would change nothing.
#pragma once
#include "app/options.hpp"

namespace momentscope {

/// Throws Error with the first option of `app` or of the command that was chosen which the command would
/// ignore beside the others: another scene's size, a parameter that no chosen technique reads, a seed without
/// random rays. Throws Error, too, for techniques that do not exist.
void refuse_ignored_options(const CLI::App& app, const Options& options);

/// From now on parsing refuses an empty value of these options.
void refuse_empty_values(CLI::App& command);

/// Throws Error for "--option=" without a value. To be called before the words are parsed.
void refuse_empty_assignments(int argc, const char* const* argv);

}  // namespace momentscope
