// expect_error.hpp -- what every failure of the outside world must look like: one sentence, on one line.
#pragma once
#include "core/error.hpp"

#include <gtest/gtest.h>
#include <regex>
#include <string>

namespace momentscope {

/// One line that ends in its only full stop that ends a sentence (that of 0.5, .json or "e.g." is none).
inline void expect_one_sentence(const std::string& text) {
    ASSERT_FALSE(text.empty());
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_EQ(text.back(), '.') << text;
    EXPECT_FALSE(std::regex_search(text, std::regex("[.!?] +[A-Z]"))) << text;
    EXPECT_FALSE(text.ends_with("..")) << text;
}

/// Expects `action` to throw an Error of one sentence that contains `part`.
template <class Action>
void expect_error(const Action& action, const std::string& part) {
    try {
        action();
        ADD_FAILURE() << "nothing was refused; expected: " << part;
    } catch (const Error& error) {
        expect_one_sentence(error.what());
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

}  // namespace momentscope
