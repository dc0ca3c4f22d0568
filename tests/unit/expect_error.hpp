// expect_error.hpp -- checks the form of error messages: one sentence on one line.
#pragma once
#include "core/support/error.hpp"

#include <gtest/gtest.h>
#include <regex>
#include <string>

namespace momentscope {

/// One line that ends with its only full stop (those in 0.5, .json or "e.g." do not count).
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
