#include "core/gl/dialect.hpp"

#include <algorithm>
#include <iterator>

namespace momentscope {

namespace {

// The words that files use: EARLY_TESTS before main, INVARIANT_IN before an input that scene.vert declares
// invariant, PRECISE before a local float.
using Words = std::map<std::string, std::string>;

constexpr const char* PRECISIONS =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp usampler2D;\n"
    "precision highp sampler2DArray;\nprecision highp usampler2DArray;\n";

}  // namespace

// Before GLSL 4.30, an invariant output needs an invariant input.
std::span<const DialectRow> dialects() {
    static const DialectRow ROWS[] = {
        {"450", "GLSL 4.50", "#version 450 core\n", "",
         Words{{"EARLY_TESTS", "layout(early_fragment_tests) in;"},
               {"INVARIANT_IN", "in"},
               {"PRECISE", "precise"}},
         Dialect::glsl_450, true, true},
        {"410", "GLSL 4.10", "#version 410 core\n", "",
         Words{{"EARLY_TESTS", ""}, {"INVARIANT_IN", "invariant in"}, {"PRECISE", "precise"}},
         Dialect::glsl_410, true, false},
        {"330", "GLSL 3.30", "#version 330 core\n", "",
         Words{{"EARLY_TESTS", ""}, {"INVARIANT_IN", "invariant in"}, {"PRECISE", ""}}, Dialect::glsl_330,
         false, false},
        {"300es", "ESSL 3.00", "#version 300 es\n", PRECISIONS,
         Words{{"EARLY_TESTS", ""}, {"INVARIANT_IN", "in"}, {"PRECISE", ""}}, Dialect::essl_300, false,
         false},
    };
    return ROWS;
}

const DialectRow& row_of(Dialect dialect) {
    return *std::ranges::find(dialects(), dialect, &DialectRow::dialect);
}

ShaderLanguage language_of(Dialect dialect) {
    return {dialect, row_of(dialect).has_precise ? Rounding::precise : Rounding::unguarded};
}

}  // namespace momentscope
