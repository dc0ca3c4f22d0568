// plain_text_test.cpp -- text from outside in sentences, JSON, pages and tables.
#include "core/support/plain_text.hpp"
#include "core/support/json_text.hpp"
#include "core/support/markup.hpp"
#include "core/support/parse_number.hpp"
#include "tests/unit/expect_error.hpp"

#include <gtest/gtest.h>

using namespace momentscope;

namespace {

TEST(PlainText, WhatIsTextStays) {
    for (const char* text : {"", "plain", "Münstermann π 深さ 🫖", "\u00A0\u200D\uFFFD\U0010FFFD"}) {
        EXPECT_TRUE(is_utf8(text));
        EXPECT_EQ(one_line(text), text);
    }
}

TEST(PlainText, ControlsBecomeSpaces) {
    EXPECT_EQ(one_line("a\x1B[31m\tb\x7F\r\n"), "a [31m b   ");
    EXPECT_EQ(one_line("\u0080\u009B\u009F\u2028\u2029\u202E\u2066"), "       ");
    EXPECT_EQ(one_line(std::string_view("a\0b", 3)), "a b");
    EXPECT_EQ(plain_lines("a\n\tb\u009B\n"), "a\n b \n");
    EXPECT_STREQ(Error("a\u009B31m\x1B.").what(), "a 31m .");
}

TEST(PlainText, WhatIsNoUtf8IsReplaced) {
    for (const char* wrong : {"\xE9", "\x80", "\xFF", "\xC2", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
                              "\xF4\x90\x80\x80", "\xE2\x82", "\xF0\x9F\xAB"}) {
        EXPECT_FALSE(is_utf8(wrong));
        const std::string text = one_line(std::string("a") + wrong + "z");
        EXPECT_TRUE(is_utf8(text));
        EXPECT_TRUE(text.starts_with("a\uFFFD") && text.ends_with("\uFFFDz")) << text;
    }
    EXPECT_EQ(one_line("\uFFFE\uFFFF"), "\uFFFD\uFFFD") << "XML has no such characters";
}

TEST(JsonText, ReadsBackTheSameWithoutControls) {
    const nlohmann::json value = {{"k\u009B", "a\x1B\x7F\u0085\u202E\n π \"\\"}, {"n", {1, 2.5}}};
    for (const int indent : {-1, 1}) {
        const std::string text = json_text(value, indent);
        EXPECT_EQ(plain_lines(text), text);
        EXPECT_NE(text.find("π"), std::string::npos) << "what is harmless stays";
        EXPECT_EQ(nlohmann::json::parse(text), value);
    }
    EXPECT_EQ(json_text(nlohmann::json("caf\xE9")), "\"caf\uFFFD\"");
}

TEST(Markup, EscapesWhatHasAMeaning) {
    EXPECT_EQ(markup_escaped("<a b=\"c\">&\x01\x1B\n\xE9"), "&lt;a b=&quot;c&quot;>&amp;   \uFFFD");
    EXPECT_EQ(markdown_cell("a|b\n<b>*x*[y](z)`"), "a\\|b \\<b>\\*x\\*\\[y\\](z)\\`");
    EXPECT_EQ(markdown_code("plain"), "`plain`");
    EXPECT_EQ(markdown_code("a``b|c\n"), "``` a``b\\|c  ```");
}

TEST(Csv, RecordsRoundTrip) {
    const std::vector<std::string> fields = {"", "a", "b,c", "say \"x\"", "two\nlines\r\n", "\"", "\\n"};
    std::string quoted, bare;
    for (const std::string& field : fields) {
        quoted += (quoted.empty() ? "" : ",") + csv_quoted(field);
        bare += (&field == fields.data() ? "" : ",") + csv_field(field);
    }
    for (const std::string& record : {quoted, bare}) {
        EXPECT_EQ(first_csv_record(record + "\nnext,one\n"), record);
        EXPECT_EQ(csv_fields(record), fields);
        EXPECT_EQ(csv_fields(record, 2), (std::vector<std::string>{"", "a"}));
    }
    EXPECT_EQ(csv_field("at:nodes=8"), "at:nodes=8");
}

TEST(ParseNumber, TakesWholeFiniteNumbers) {
    EXPECT_EQ(parse_number<int>("-12"), -12);
    EXPECT_EQ(parse_number<float>("5e-7"), 5e-7f);
    EXPECT_EQ(parse_number<double>("-.5"), -0.5);
    for (const char* wrong :
         {"", " ", "1 ", " 1", "1x", "+1", "0x1", "1,5", "1e999", "inf", "-nan", "infinity"})
        EXPECT_EQ(parse_number<double>(wrong), std::nullopt) << wrong;
    for (const char* wrong : {"", "1.5", "1e3", "2147483648", "inf"})
        EXPECT_EQ(parse_number<int>(wrong), std::nullopt) << wrong;
}

}  // namespace
