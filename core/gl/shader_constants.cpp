#include "core/gl/shader_constants.hpp"

#include <charconv>

namespace momentscope {

namespace {

constexpr int MAX_EXPANSIONS = 32;  // of nested macros

/// An expression of whole numbers, names, ( ), + - ! and the binary operators of C. A lower level binds less
/// tightly.
class Expression {
public:
    using Lookup = std::function<std::optional<int>(std::string_view name, int expansions)>;

    Expression(std::span<const ShaderToken> tokens, const Lookup& lookup, int expansions)
        : lookup_(lookup), expansions_(expansions) {
        for (const ShaderToken& token : tokens)
            if (token.kind != ShaderToken::Kind::space) tokens_.push_back(token);
    }

    std::optional<int> value() {
        const auto result = binary(0);
        return at_ == tokens_.size() ? result : std::nullopt;
    }

private:
    bool take(std::string_view sign) {
        const bool there = at_ < tokens_.size() && tokens_[at_].is(sign);
        at_ += there ? 1 : 0;
        return there;
    }

    static int level_of(std::string_view sign) {
        static const std::map<std::string_view, int> LEVELS = {
            {"||", 0}, {"&&", 1}, {"==", 2}, {"!=", 2}, {"<", 3}, {">", 3}, {"<=", 3},
            {">=", 3}, {"+", 4},  {"-", 4},  {"*", 5},  {"/", 5}, {"%", 5}};
        const auto found = LEVELS.find(sign);
        return found == LEVELS.end() ? -1 : found->second;
    }

    static std::optional<int> applied(std::string_view sign, int a, int b) {
        if (sign == "||") return a != 0 || b != 0;
        if (sign == "&&") return a != 0 && b != 0;
        if (sign == "==") return a == b;
        if (sign == "!=") return a != b;
        if (sign == "<") return a < b;
        if (sign == ">") return a > b;
        if (sign == "<=") return a <= b;
        if (sign == ">=") return a >= b;
        if (sign == "+") return a + b;
        if (sign == "-") return a - b;
        if (sign == "*") return a * b;
        if (b == 0) return std::nullopt;
        return sign == "/" ? a / b : a % b;
    }

    std::optional<int> binary(int least) {
        auto left = unary();
        while (left && at_ < tokens_.size() && level_of(tokens_[at_].text) >= least) {
            const std::string_view sign = tokens_[at_++].text;
            const auto right = binary(level_of(sign) + 1);
            left = right ? applied(sign, *left, *right) : std::nullopt;
        }
        return left;
    }

    std::optional<int> unary() {
        const auto mapped = [&](auto change) {
            const auto value = unary();
            return value ? std::optional<int>(change(*value)) : std::nullopt;
        };
        if (take("-")) return mapped([](int x) { return -x; });
        if (take("+")) return unary();
        if (take("!")) return mapped([](int x) { return x == 0 ? 1 : 0; });
        if (take("(")) {
            const auto value = binary(0);
            return take(")") ? value : std::nullopt;
        }
        if (at_ == tokens_.size()) return std::nullopt;
        const ShaderToken token = tokens_[at_++];
        if (token.kind == ShaderToken::Kind::word) return lookup_(token.text, expansions_);
        int value = 0;
        const auto [end, status] =
            std::from_chars(token.text.data(), token.text.data() + token.text.size(), value);
        return status == std::errc() && end == token.text.data() + token.text.size() ? std::optional(value)
                                                                                     : std::nullopt;
    }

    const Lookup& lookup_;
    int expansions_;
    std::vector<ShaderToken> tokens_;
    std::size_t at_ = 0;
};

std::vector<ShaderToken> without_spaces(std::string_view text) {
    std::vector<ShaderToken> tokens = shader_tokens(text);
    std::erase_if(tokens, [](const ShaderToken& token) { return token.kind == ShaderToken::Kind::space; });
    return tokens;
}

}  // namespace

std::optional<int> ShaderConstants::value_of(std::span<const ShaderToken> expression) const {
    const Expression::Lookup lookup = [&](std::string_view name, int expansions) -> std::optional<int> {
        if (const auto value = values_.find(name); value != values_.end()) return value->second;
        const auto macro = macros_.find(name);
        if (macro == macros_.end() || expansions == MAX_EXPANSIONS) return std::nullopt;
        const std::vector<ShaderToken> tokens = shader_tokens(macro->second);
        return Expression(tokens, lookup, expansions + 1).value();
    };
    return Expression(expression, lookup, 0).value();
}

// Evaluates a condition of the preprocessor. Names that are not macros count as 0. `defined(NAME)` and
// `defined NAME` are operators.
bool ShaderConstants::condition(std::string_view text) const {
    const std::vector<ShaderToken> words = without_spaces(text);
    std::vector<ShaderToken> known;
    for (std::size_t i = 0; i < words.size(); ++i) {
        using enum ShaderToken::Kind;
        if (words[i].is("defined")) {
            const bool bracket = i + 1 < words.size() && words[i + 1].is("(");
            const std::size_t name = i + (bracket ? 2 : 1);
            const bool there = name < words.size() && macros_.contains(words[name].text);
            known.push_back({number, there ? "1" : "0"});
            i = name + (bracket ? 1 : 0);
        } else if (words[i].kind == word && !macros_.contains(words[i].text)) {
            known.push_back({number, "0"});
        } else {
            known.push_back(words[i]);
        }
    }
    return value_of(known).value_or(0) != 0;
}

bool ShaderConstants::active() const {
    return branches_.empty() || (branches_.back().outer && branches_.back().now);
}

void ShaderConstants::read_directive(std::string_view line) {
    const std::vector<ShaderToken> words = without_spaces(line.substr(1));
    if (words.empty()) return;
    const std::string_view what = words[0].text;
    const std::string_view name = words.size() > 1 ? words[1].text : "";
    const auto rest_after = [&](std::string_view word) {
        return line.substr(static_cast<std::size_t>(word.data() + word.size() - line.data()));
    };
    if (what == "ifdef" || what == "ifndef" || what == "if") {
        const bool now =
            what == "if" ? condition(rest_after(what)) : macros_.contains(name) == (what == "ifdef");
        branches_.push_back({active(), now, now});
    } else if (what == "elif" && !branches_.empty()) {
        Branch& branch = branches_.back();
        branch.now = !branch.taken && condition(rest_after(what));
        branch.taken |= branch.now;
    } else if (what == "else" && !branches_.empty()) {
        branches_.back().now = !branches_.back().taken;
        branches_.back().taken = true;
    } else if (what == "endif" && !branches_.empty()) {
        branches_.pop_back();
    } else if (what == "define" && active()) {
        macros_[std::string(name)] = rest_after(name);
    } else if (what == "undef" && active()) {
        macros_.erase(std::string(name));
    }
}

}  // namespace momentscope
