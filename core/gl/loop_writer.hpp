// loop_writer.hpp -- writes out loops of fixed count, for drivers that do not unroll them. llvmpipe keeps
// arrays in memory if a loop indexes them, which makes a fragment 3 to 7 times slower.
#pragma once
#include <string>
#include <string_view>

namespace momentscope {

struct WrittenOut {
    std::string text;
    int loops = 0;  // that were written out; inner loops count once per copy
    int left = 0;   // loops marked UNROLL that are kept: no constant count, or a break
};

/// The text of a shader (with all #includes joined) in which every loop marked UNROLL is replaced by its
/// bodies, one after another and in braces, with the variable replaced by its value. Bounds may be macros,
/// `const int`s and variables of outer loops. `if (...) continue;` in the body becomes a branch around the
/// rest. Branches of the preprocessor are evaluated, and stay in the text.
WrittenOut with_loops_written_out(std::string_view text);

}  // namespace momentscope
