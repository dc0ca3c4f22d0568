// loop_writer_test.cpp -- writing out the loops of shaders.
#include "core/gl/loop_writer.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <vector>

#include "core/gl/shader_tokens.hpp"

namespace momentscope::test {
namespace {

// Removes white space that does not matter.
std::string packed(std::string_view text) {
    std::string result;
    for (const ShaderToken& token : shader_tokens(text)) {
        const bool between_words =
            !result.empty() && (std::isalnum(static_cast<unsigned char>(result.back())) != 0);
        if (token.kind == ShaderToken::Kind::space) continue;
        if (between_words &&
            (token.kind == ShaderToken::Kind::word || token.kind == ShaderToken::Kind::number))
            result += ' ';
        result += token.text;
    }
    return result;
}

std::string written(std::string_view text) {
    return packed(with_loops_written_out(text).text);
}

TEST(ShaderTokens, AreTheWholeText) {
    const std::string text =
        "#version 450\n// a { comment\nfloat f(int i) /* ; */ { return i <= 3 ? 1.0e-3f : .5 + a.b[i]; }\n  #if A\n#endif";
    std::string joined;
    std::vector<std::string_view> signs;
    for (const ShaderToken& token : shader_tokens(text)) {
        joined += token.text;
        if (token.kind == ShaderToken::Kind::number) signs.push_back(token.text);
    }
    EXPECT_EQ(joined, text);
    EXPECT_EQ(signs, (std::vector<std::string_view>{"3", "1.0e-3f", ".5"}));
    int directives = 0;
    for (const ShaderToken& token : shader_tokens(text))
        directives += token.kind == ShaderToken::Kind::directive ? 1 : 0;
    EXPECT_EQ(directives, 3);
}

TEST(LoopWriter, WritesABodyForEachTurn) {
    EXPECT_EQ(written("UNROLL\nfor (int i = 0; i < 3; ++i) a[i] = b.i + i;"),
              "{a[0]=b.i+0;}{a[1]=b.i+1;}{a[2]=b.i+2;}");
    EXPECT_EQ(written("UNROLL for (int i = 1; i >= -1; --i) { float x = f(i); y += x; }"),
              "{float x=f(1);y+=x;}{float x=f(0);y+=x;}{float x=f((-1));y+=x;}");
    EXPECT_EQ(written("UNROLL for (int i = 5; i < 3; ++i) a = i;"), "");
}

TEST(LoopWriter, KnowsMacrosConstantsAndBranches) {
    const std::string text =
        "#define M 4\n#define ORDER (M / 2 + 1)\n#if M == 4 && defined(ORDER)\nconst int TURNS = ORDER - 1;\n#else\n"
        "const int TURNS = 9;\n#endif\nvoid f() { UNROLL for (int i = 0; i < TURNS; ++i) g(i); }\n#undef M\n#define M 2\n"
        "void h() { UNROLL for (int i = 0; i < M; ++i) g(i); }\n#ifdef NEVER\nUNROLL for (int i = 0; i < 2; ++i) g(i);\n#endif";
    const WrittenOut result = with_loops_written_out(text);
    EXPECT_EQ(result.loops, 4);
    EXPECT_EQ(result.left, 0);
    EXPECT_NE(packed(result.text).find("void f(){{g(0);}{g(1);}}"), std::string::npos) << result.text;
    EXPECT_NE(packed(result.text).find("void h(){{g(0);}{g(1);}}"), std::string::npos) << result.text;
    EXPECT_NE(packed(result.text).find("for(int i=0;i<2;++i)g(i);"), std::string::npos)
        << "what is not compiled stays";
}

TEST(LoopWriter, NestsTriangularBounds) {
    EXPECT_EQ(
        written(
            "UNROLL for (int i = 1; i < 3; ++i) { UNROLL for (int j = i - 1; j < i; ++j) a[i * 3 + j] = 1; }"),
        "{{a[1*3+0]=1;}}{{a[2*3+1]=1;}}");
    EXPECT_EQ(
        written(
            "UNROLL for (int k = 0; k < 2; ++k)\n UNROLL for (int j = k; j < 2; ++j) if (a) b(k, j); else c();"),
        "{{if(a)b(0,0);else c();}{if(a)b(0,1);else c();}}{{if(a)b(1,1);else c();}}");
}

TEST(LoopWriter, ContinueBecomesABranch) {
    EXPECT_EQ(
        written(
            "UNROLL for (int k = 0; k < 2; ++k) { if (k >= degree) continue; a(k); if (b[k]) continue; c(); }"),
        "{if(!(0>=degree)){a(0);if(!(b[0])){c();}}}{if(!(1>=degree)){a(1);if(!(b[1])){c();}}}");
}

TEST(LoopWriter, LeavesWhatItCannotWriteOut) {
    for (const char* loop :
         {"UNROLL for (int i = 0; i < count; ++i) a[i] = 0;",
          "UNROLL for (int i = 0; i < 9; i += 2) a[i] = 0;",
          "UNROLL for (int i = 0; i < 9; ++i) { if (a) break; b(); }",
          "UNROLL for (int i = 0; i < 9; ++i) { if (a) { continue; } b(); }",
          "UNROLL for (int i = 0; i < 9; ++i) { for (int i = 0; i < 2; ++i) b(i); }",
          "UNROLL for (int i = 0; i < 9; ++i) { i = 3; }", "UNROLL for (int i = 0; i < 9; ++i) { i += 3; }",
          "UNROLL for (int i = 0; i < 9; ++i) { if (a[i]) continue; else b(i); c(i); }",
          "UNROLL for (int i = 0; i < 1000; ++i) b(i);",
          "UNROLL for (float x = 0.0; x < 2.0; x += 1.0) b(x);", "UNROLL while (true) b();"}) {
        const WrittenOut result = with_loops_written_out(loop);
        EXPECT_EQ(packed(result.text), packed(loop));
        EXPECT_EQ(result.left, 1) << loop;
    }
    EXPECT_EQ(written("for (int i = 0; i < 3; ++i) a[i] = 0;"), "for(int i=0;i<3;++i)a[i]=0;")
        << "it is not marked";
}

// A number that only looks like a constant of the whole file.
TEST(LoopWriter, ConstantsOfFunctionsAreTheirOwn) {
    EXPECT_EQ(with_loops_written_out(
                  "void f() { const int n = 2; } void g(int n) { UNROLL for (int i = 0; i < n; ++i) a(i); }")
                  .loops,
              0);
}

}  // namespace
}  // namespace momentscope::test
