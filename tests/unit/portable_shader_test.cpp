// portable_shader_test.cpp -- what only some dialects of GLSL have is rewritten for all of them.
#include "core/gl/portable_shader.hpp"

#include <gtest/gtest.h>

#include "core/gl/shader_text.hpp"

namespace momentscope::test {
namespace {

std::string guarded(const std::string& text) {
    return portable_shader(text, true).text;
}

TEST(PortableShader, BindingsAreTakenOutAndKept) {
    const PortableShader shader = portable_shader(
        "layout(binding = 3) uniform sampler2D picture;   // comment\n"
        "layout(std140, binding = 1) uniform Object\n{ mat4 model; } object;\n"
        "layout(binding = 9) uniform usampler2DArray depths[2];\n",
        false);
    EXPECT_EQ(
        shader.text,
        "uniform sampler2D picture;   // comment\nlayout(std140) uniform Object\n{ mat4 model; } object;\n"
        "uniform usampler2DArray depths[2];\n");
    EXPECT_EQ(shader.bindings, (ShaderBindings{{"Object", 1}, {"depths", 9}, {"picture", 3}}));
}

TEST(PortableShader, ImagesStorageAndLocationsKeepTheirLayout) {
    const std::string text =
        "layout(binding = 0, r32f) uniform coherent image2D sums;\n"
        "layout(std430, binding = 0) buffer List { uint count; } list;\nlayout(location = 0) out vec4 color;\n";
    const PortableShader shader = portable_shader(text, true);
    EXPECT_EQ(shader.text, text);
    EXPECT_TRUE(shader.bindings.empty());
}

TEST(PortableShader, ListsBecomeConstructorsOfArrays) {
    EXPECT_EQ(
        portable_shader("const float BIAS[2] = {0.5f, -1.0f};\nfloat f() { return BIAS[1]; }", false).text,
        "const float BIAS[2] = float[](0.5f, -1.0f);\nfloat f() { return BIAS[1]; }");
}

TEST(PortableShader, WithoutAGuardPreciseStays) {
    const std::string text = "void f(float a) { PRECISE float x = a + 1.0f; }";
    EXPECT_EQ(portable_shader(text, false).text, text);
}

TEST(GuardedExpressions, HideTheResultOfEachOperation) {
    EXPECT_EQ(guarded("void f() { PRECISE float x = a * b + c; }"),
              "void f() { float x = guarded(guarded(a * b) + c); }");
    EXPECT_EQ(
        guarded("void f() { PRECISE float low = (a - (high - part)) + (b - part); }"),
        "void f() { float low = guarded((guarded(a - (guarded(high - part)))) + (guarded(b - part))); }");
    EXPECT_EQ(guarded("void f() { PRECISE float x = -a / max(b.y - 1.0f, 2.0f); }"),
              "void f() { float x = guarded(-a / max(guarded(b.y - 1.0f), 2.0f)); }");
}

TEST(GuardedExpressions, LeaveWholeNumbersAlone) {
    EXPECT_EQ(guarded("void f() { PRECISE float x = v[2 * k + 1] * float(k + 1); }"),
              "void f() { float x = guarded(v[ 2 * k + 1 ]  * float( k + 1 ) ); }");
    EXPECT_EQ(guarded("void f() { PRECISE float x = i % 2 == 0 ? a : b + a; }"),
              "void f() { float x = i % 2 == 0 ? a : guarded(b + a); }");
}

TEST(GuardedExpressions, AlsoOfLaterAssignmentsInTheSameFunction) {
    EXPECT_EQ(
        guarded("void f() { PRECISE float x = 1.0f; x = x + y; s.x = x + y; }\nvoid g() { x = x + y; }"),
        "void f() { float x = 1.0f; x = guarded(x + y); s.x = x + y; }\nvoid g() { x = x + y; }");
}

// A brace that a list of an array takes with it must not hide the end of a function.
TEST(GuardedExpressions, EndWithTheFunctionBehindAnArray) {
    EXPECT_EQ(
        guarded("const float A[1] = {1.0f};\nvoid f() { PRECISE float x = 1.0f; }\nvoid g() { x = x + y; }"),
        "const float A[1] = float[](1.0f);\nvoid f() { float x = 1.0f; }\nvoid g() { x = x + y; }");
}

TEST(ShaderText, BeginsAsItsDialectMust) {
    for (const DialectRow& row : dialects()) {
        const std::string text = shader_text("passes/color.frag", {}, language_of(row.dialect)).text;
        EXPECT_TRUE(text.starts_with(row.version)) << row.key;
        EXPECT_EQ(text.find("binding ="), std::string::npos) << row.key;
    }
}

TEST(ShaderText, ExtensionsStandBeforeEverythingElse) {
    const std::string text = shader_text("passes/copy.frag", {.defines = {{"FRAMEBUFFER_FETCH", "1"}}},
                                         language_of(Dialect::essl_300))
                                 .text;
    EXPECT_TRUE(text.starts_with("#version 300 es\n#extension GL_EXT_shader_framebuffer_fetch : require\n"));
}

}  // namespace
}  // namespace momentscope::test
