// shader_namespace_test.cpp -- renaming of GLSL that occurs twice in a program.
#include "core/gl/shader_namespace.hpp"

#include <gtest/gtest.h>

namespace momentscope::test {
namespace {

TEST(ShaderNamespace, RenamesWhatTheTextDeclaresAndNothingElse) {
    const std::string text =
        "#define SIZE 3\n#ifdef ELSEWHERE\n#endif\nstruct Texel { float f[4]; };\n"
        "const float LIMIT = 2.0f;   // SIZE\nFN float half_of(IN(Texel) texel)\n"
        "{\n    PRECISE float x = texel.f[0] * LIMIT;\n    return abs(x) > 1.0f ? half_of(texel) : float(SIZE);\n}\n";
    const std::string renamed = in_namespace(text, "light");
    EXPECT_NE(renamed.find("#define light_SIZE 3"), std::string::npos);
    EXPECT_NE(renamed.find("#ifdef light_ELSEWHERE"), std::string::npos) << "surrounding macros are not seen";
    EXPECT_NE(renamed.find("struct light_Texel { float f[4]; };"), std::string::npos);
    EXPECT_NE(renamed.find("FN float light_half_of(IN(light_Texel) texel)"), std::string::npos);
    EXPECT_NE(renamed.find("PRECISE float x = texel.f[0] * light_LIMIT;"), std::string::npos);
    EXPECT_NE(renamed.find("abs(x) > 1.0f ? light_half_of(texel) : float(light_SIZE)"), std::string::npos);
}

}  // namespace
}  // namespace momentscope::test
