#include "core/gl/guarded_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

using Signs = std::vector<std::string_view>;

// From the weakest to the strongest. The last two are guarded, but for %, which is of whole numbers.
const std::vector<Signs>& levels() {
    static const std::vector<Signs> LEVELS = {
        {"||"}, {"&&"}, {"==", "!="}, {"<", ">", "<=", ">="}, {"+", "-"}, {"*", "/", "%"}};
    return LEVELS;
}

class Guard {
public:
    explicit Guard(std::span<const ShaderToken> expression) {
        for (const ShaderToken& token : expression)
            if (token.kind != ShaderToken::Kind::space) tokens_.push_back(token.text);
    }

    std::string whole() {
        std::string text = ternary();
        if (at_ < tokens_.size())
            throw Error(fmt::format("A PRECISE expression has '{}', which cannot be guarded.", tokens_[at_]));
        return text;
    }

private:
    std::string_view token() const { return at_ < tokens_.size() ? tokens_[at_] : std::string_view(); }

    std::string take() {
        if (at_ == tokens_.size()) throw Error("A PRECISE expression ends too early.");
        return std::string(tokens_[at_++]);
    }

    std::string ternary() {
        std::string text = binary(0);
        if (token() != "?") return text;
        for (int part = 0; part < 2; ++part) {
            text += " " + take() + " ";
            text += ternary();
        }
        return text;
    }

    std::string binary(std::size_t level) {
        if (level == levels().size()) return unary();
        std::string left = binary(level + 1);
        while (std::ranges::count(levels()[level], token()) > 0) {
            const std::string sign = take();
            std::string both = left;
            both.append(" ").append(sign).append(" ").append(binary(level + 1));
            const bool floats = level + 2 >= levels().size() && sign != "%";
            left = floats ? "guarded(" + both + ")" : both;
        }
        return left;
    }

    std::string unary() {
        if (token() == "-" || token() == "!" || token() == "+") {
            std::string sign = take();
            return sign + unary();
        }
        std::string text = token() == "(" ? "(" + parenthesised() + ")" : take();
        while (token() == "(" || token() == "[" || token() == ".") {
            if (token() == ".") {
                text += take();
                text += take();
            } else if (token() == "[" || takes_no_floats(text)) {
                text += verbatim();
            } else {
                text += "(" + parenthesised() + ")";
            }
        }
        return text;
    }

    // The expressions between the brackets here.
    std::string parenthesised() {
        ++at_;
        std::string text = token() == ")" ? "" : ternary();
        while (token() == ",") {
            ++at_;
            text += ", " + ternary();
        }
        ++at_;
        return text;
    }

    // The brackets here with what is between them.
    std::string verbatim() {
        std::string text;
        int depth = 0;
        do {
            depth += token() == "(" || token() == "[" ? 1 : token() == ")" || token() == "]" ? -1 : 0;
            text += take() + " ";
        } while (depth > 0);
        return text;
    }

    static bool takes_no_floats(std::string_view function) {
        constexpr std::array NAMES = {"float", "int", "uint", "intBitsToFloat", "uintBitsToFloat"};
        return std::ranges::count(NAMES, function) > 0;
    }

    std::vector<std::string_view> tokens_;
    std::size_t at_ = 0;
};

}  // namespace

std::string guarded_expression(std::span<const ShaderToken> expression) {
    return Guard(expression).whole();
}

}  // namespace momentscope
