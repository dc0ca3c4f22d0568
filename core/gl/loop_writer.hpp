// loop_writer.hpp -- loops of fixed count written out, for drivers that do not unroll them: llvmpipe keeps
// arrays that a loop indexes in memory, which makes a fragment 3 to 7 times dearer.
#pragma once
#include <string>
#include <string_view>

namespace momentscope {

struct WrittenOut {
    std::string text;
    int loops = 0;  // that were written out, those inside others once for each copy
    int left = 0;   // loops marked UNROLL that stay: their count is not a constant, or they break out
};

/// The text of a shader (all #includes joined) with every loop that is marked UNROLL as its bodies one after
/// another, in braces, the variable replaced by its value. Bounds may be macros, `const int`s and the
/// variables of outer loops; `if (...) continue;` in the body becomes a branch around the rest. Branches of
/// the preprocessor are followed, and stay.
WrittenOut with_loops_written_out(std::string_view text);

}  // namespace momentscope
