#include "core/gl/loop_writer.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/gl/shader_constants.hpp"
#include "core/gl/shader_tokens.hpp"

namespace momentscope {

namespace {

using Kind = ShaderToken::Kind;
using Tokens = std::vector<ShaderToken>;

constexpr int MAX_TURNS = 256;  // of one loop; loops with more turns are kept

/// A range of tokens: [begin, end).
struct Part {
    std::size_t begin = 0, end = 0;
};

/// for (int variable = first; condition; step) body
struct Loop {
    std::string_view variable;
    Part first, condition, step, body;
    std::size_t end = 0;
};

class Writer {
public:
    explicit Writer(std::string_view text) : tokens_(shader_tokens(text)) {}

    WrittenOut run() {
        write({0, tokens_.size()});
        return std::move(result_);
    }

private:
    std::size_t after_spaces(std::size_t at) const {
        while (at < tokens_.size() && tokens_[at].kind == Kind::space) ++at;
        return at;
    }

    bool is(std::size_t at, std::string_view text) const {
        return at < tokens_.size() && tokens_[at].is(text);
    }

    // The place after the bracket that closes the one at `at`.
    std::size_t after_brackets(std::size_t at) const {
        int depth = 0;
        for (; at < tokens_.size(); ++at) {
            const std::string_view text = tokens_[at].text;
            if (text == "(" || text == "{" || text == "[") ++depth;
            if (text == ")" || text == "}" || text == "]") --depth;
            if (depth == 0) return at + 1;
        }
        return at;
    }

    std::size_t after_semicolon(std::size_t at) const {
        while (at < tokens_.size() && !is(at, ";"))
            at = is(at, "(") || is(at, "[") || is(at, "{") ? after_brackets(at) : at + 1;
        return std::min(at + 1, tokens_.size());
    }

    // The place after the statement that begins at `at`.
    std::size_t after_statement(std::size_t at) const {
        at = after_spaces(at);
        if (is(at, "UNROLL")) return after_statement(at + 1);
        if (is(at, "{")) return after_brackets(at);
        if (is(at, "for") || is(at, "while")) return after_statement(after_brackets(after_spaces(at + 1)));
        if (is(at, "if")) {
            const std::size_t then = after_statement(after_brackets(after_spaces(at + 1)));
            const std::size_t other = after_spaces(then);
            return is(other, "else") ? after_statement(other + 1) : then;
        }
        return after_semicolon(at);
    }

    std::optional<Loop> loop_at(std::size_t unroll) const {
        std::size_t at = after_spaces(unroll + 1);
        if (!is(at, "for")) return std::nullopt;
        at = after_spaces(at + 1);
        if (!is(at, "(")) return std::nullopt;
        const std::size_t close = after_brackets(at) - 1;
        at = after_spaces(at + 1);
        if (!is(at, "int")) return std::nullopt;
        at = after_spaces(at + 1);
        Loop loop;
        loop.variable = tokens_[at].text;
        at = after_spaces(at + 1);
        if (!is(at, "=")) return std::nullopt;
        loop.first = {at + 1, after_semicolon(at) - 1};
        loop.condition = {loop.first.end + 1, after_semicolon(loop.first.end + 1) - 1};
        loop.step = {loop.condition.end + 1, close};
        loop.body.begin = close + 1;
        loop.body.end = loop.end = after_statement(close + 1);
        return loop.step.begin < close ? std::optional(loop) : std::nullopt;
    }

    std::span<const ShaderToken> part(const Part& part) const {
        return std::span(tokens_).subspan(part.begin, part.end - part.begin);
    }

    // +1 or -1 for ++i, i++, --i and i--; otherwise nullopt.
    std::optional<int> step_of(const Loop& loop) const {
        std::vector<std::string_view> words;
        for (const ShaderToken& token : part(loop.step))
            if (token.kind != Kind::space) words.push_back(token.text);
        if (words.size() != 2 || std::ranges::find(words, loop.variable) == words.end()) return std::nullopt;
        const std::string_view sign = words[0] == loop.variable ? words[1] : words[0];
        if (sign == "++") return 1;
        return sign == "--" ? std::optional(-1) : std::nullopt;
    }

    // The values of the variable; nullopt if they are not known here, or if there are too many to write out.
    std::optional<std::vector<int>> turns_of(const Loop& loop) {
        const auto first = constants_.value_of(part(loop.first));
        const auto step = step_of(loop);
        if (!first || !step) return std::nullopt;
        std::vector<int> turns;
        for (int i = *first; turns.size() <= MAX_TURNS; i += *step) {
            constants_.set(loop.variable, i);
            const auto goes_on = constants_.value_of(part(loop.condition));
            constants_.forget(loop.variable);
            if (!goes_on) return std::nullopt;
            if (*goes_on == 0) return turns;
            turns.push_back(i);
        }
        return std::nullopt;
    }

    // The statements of the body, without its braces.
    std::vector<Part> statements_of(const Loop& loop) const {
        Part inner = loop.body;
        const std::size_t begin = after_spaces(inner.begin);
        if (is(begin, "{")) inner = {begin + 1, loop.body.end - 1};
        std::vector<Part> statements;
        for (std::size_t at = inner.begin; at < inner.end;) {
            const std::size_t end =
                after_spaces(at) >= inner.end ? inner.end : std::min(after_statement(at), inner.end);
            statements.push_back({at, end});
            at = end;
        }
        return statements;
    }

    // The condition of a statement `if (...) continue;`; nullopt for other statements.
    std::optional<Part> skips(const Part& statement) const {
        const std::size_t at = after_spaces(statement.begin);
        if (at >= statement.end || !is(at, "if")) return std::nullopt;
        const std::size_t open = after_spaces(at + 1);
        const std::size_t close = after_brackets(open);
        const std::size_t word = after_spaces(close);
        const std::size_t end = after_spaces(word + 1);
        if (!is(word, "continue") || !is(end, ";")) return std::nullopt;
        if (after_spaces(end + 1) < statement.end) return std::nullopt;  // there is an else
        return Part{open, close};
    }

    // True if a statement may leave the loop or its turn, changes the variable, or declares another variable
    // with this name. Other ways to change the variable, such as an `out` argument, are not seen here. But
    // with a number in its place no driver compiles them, and then the loop is kept.
    bool leaves(const Part& statement, std::string_view variable) const {
        for (std::size_t at = statement.begin; at < statement.end; ++at)
            if (is(at, "int") && is(after_spaces(at + 1), variable)) return true;
        for (std::size_t at = statement.begin; at < statement.end; ++at) {
            if (is(at, "for") || is(at, "while")) {
                at = after_statement(at) - 1;  // statements that leave an inner loop do not matter here
                continue;
            }
            if (is(at, "break") || is(at, "continue")) return true;
            if (!is(at, variable)) continue;
            for (const char* sign : {"=", "+=", "-=", "*=", "/=", "++", "--"})
                if (is(after_spaces(at + 1), sign)) return true;
        }
        return false;
    }

    bool can_be_written_out(const Loop& loop) const {
        return std::ranges::none_of(statements_of(loop), [&](const Part& statement) {
            return !skips(statement) && leaves(statement, loop.variable);
        });
    }

    void write_loop(const Loop& loop, const std::vector<int>& turns) {
        const std::vector<Part> statements = statements_of(loop);
        for (const int turn : turns) {
            constants_.set(loop.variable, turn);
            values_.emplace_back(loop.variable, turn);
            ++result_.loops;
            result_.text += turn == turns.front() ? "{" : " {";
            int open = 1;
            for (const Part& statement : statements) {
                if (const auto condition = skips(statement)) {
                    result_.text += " if (!";
                    write(*condition);
                    result_.text += ") {";
                    ++open;
                } else {
                    write(statement);
                }
            }
            result_.text.append(static_cast<std::size_t>(open), '}');
            values_.pop_back();
            constants_.forget(loop.variable);
        }
    }

    // Reads `const int NAME = value;` outside of functions.
    void learn_constant(std::size_t at) {
        std::vector<std::size_t> words;
        for (std::size_t i = at; i < tokens_.size() && words.size() < 4; i = after_spaces(i + 1))
            words.push_back(i);
        if (words.size() < 4 || !is(words[1], "int") || !is(words[3], "=")) return;
        const Part value = {words[3] + 1, after_semicolon(words[3]) - 1};
        if (const auto known = constants_.value_of(part(value)))
            constants_.set(tokens_[words[2]].text, *known);
    }

    void write_word(std::size_t at) {
        const std::string_view word = tokens_[at].text;
        const bool member = at > 0 && is(at - 1, ".");
        const auto value = std::ranges::find(values_, word, &std::pair<std::string_view, int>::first);
        if (member || value == values_.end())
            result_.text += word;
        else
            result_.text +=
                value->second < 0 ? "(" + std::to_string(value->second) + ")" : std::to_string(value->second);
    }

    void write(const Part& part) {
        for (std::size_t at = part.begin; at < part.end;) {
            const ShaderToken& token = tokens_[at];
            if (token.kind == Kind::directive) constants_.read_directive(token.text);
            if (token.is("{")) ++depth_;
            if (token.is("}")) --depth_;
            if (token.is("const") && depth_ == 0 && constants_.active()) learn_constant(at);
            if (token.is("UNROLL") && constants_.active()) {
                const auto loop = loop_at(at);
                const auto turns = loop && can_be_written_out(*loop) ? turns_of(*loop) : std::nullopt;
                if (turns) {
                    write_loop(*loop, *turns);
                    at = loop->end;
                    continue;
                }
                ++result_.left;
            }
            if (token.kind == Kind::word)
                write_word(at);
            else
                result_.text += token.text;
            ++at;
        }
    }

    Tokens tokens_;
    ShaderConstants constants_;
    std::vector<std::pair<std::string_view, int>> values_;  // of the loops that are being written out now
    WrittenOut result_;
    int depth_ = 0;  // of braces
};

}  // namespace

WrittenOut with_loops_written_out(std::string_view text) {
    return Writer(text).run();
}

}  // namespace momentscope
