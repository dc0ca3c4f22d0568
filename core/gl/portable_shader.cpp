#include "core/gl/portable_shader.hpp"

#include <charconv>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/gl/guarded_expression.hpp"
#include "core/gl/shader_tokens.hpp"

namespace momentscope {

namespace {

class PortableWriter {
public:
    PortableWriter(std::string_view text, bool guards_rounding)
        : tokens_(shader_tokens(text)), guards_rounding_(guards_rounding) {}

    PortableShader run() {
        while (at_ < tokens_.size()) {
            if (token(at_) == "layout" && write_layout()) continue;
            if (guards_rounding_ && write_guarded()) continue;
            if (token(at_) == "{" && begins_array(at_) && write_array()) continue;
            depth_ += token(at_) == "{" ? 1 : token(at_) == "}" ? -1 : 0;
            if (depth_ == 0) precise_.clear();  // a function ends
            result_.text += token(at_++);
        }
        return std::move(result_);
    }

private:
    std::string_view token(std::size_t at) const {
        return at < tokens_.size() ? tokens_[at].text : std::string_view();
    }

    std::size_t next(std::size_t at) const {
        do ++at;
        while (at < tokens_.size() && tokens_[at].kind == ShaderToken::Kind::space);
        return at;
    }

    std::optional<std::size_t> before(std::size_t at) const {
        while (at-- > 0)
            if (tokens_[at].kind != ShaderToken::Kind::space) return at;
        return std::nullopt;
    }

    // The place of the bracket that closes the one at `open`.
    std::size_t closing(std::size_t open) const {
        int depth = 0;
        for (std::size_t at = open; at < tokens_.size(); ++at) {
            const std::string_view text = token(at);
            if (text == "(" || text == "{" || text == "[") ++depth;
            if (text == ")" || text == "}" || text == "]") --depth;
            if (depth == 0) return at;
        }
        return tokens_.size();
    }

    void copy(std::size_t end) {
        for (; at_ < end; ++at_) result_.text += token(at_);
    }

    // layout(binding = 3) uniform sampler2D name; layout(std140, binding = 0) uniform Name
    bool write_layout() {
        const std::size_t open = next(at_), close = closing(open);
        std::optional<int> binding;
        bool is_block = false;
        for (std::size_t i = open; i < close; i = next(i)) {
            is_block |= token(i) == "std140";
            if (token(i) == "binding") {
                const std::string_view number = token(next(next(i)));
                std::from_chars(number.data(), number.data() + number.size(), binding.emplace());
            }
        }
        const std::size_t uniform = next(close), type = next(uniform);
        const bool is_sampler = token(type).find("sampler") != std::string_view::npos;
        if (!binding || token(uniform) != "uniform" || !(is_block || is_sampler)) return false;
        result_.bindings[std::string(token(is_block ? type : next(type)))] = *binding;
        if (is_block) result_.text += "layout(std140) ";
        at_ = uniform;
        return true;
    }

    // PRECISE float x = ...; and x = ...; behind it in the same function
    bool write_guarded() {
        const bool declares = token(at_) == "PRECISE" && token(next(at_)) == "float";
        const std::size_t name = declares ? next(next(at_)) : at_, equals = next(name);
        if (declares) precise_.insert(token(name));
        const auto last = before(at_);
        const bool member = last && token(*last) == ".";
        if (token(equals) != "=" || !(declares || (precise_.contains(token(name)) && !member))) return false;
        std::size_t end = equals;
        while (end < tokens_.size() && token(end) != ";")
            end = token(end) == "(" ? closing(end) + 1 : end + 1;
        if (declares) at_ = next(at_);
        copy(equals + 1);
        result_.text += " " + guarded_expression(std::span(tokens_).subspan(equals + 1, end - equals - 1));
        at_ = end;
        return true;
    }

    // type name[...] = {
    bool begins_array(std::size_t brace) const {
        const auto equals = before(brace);
        if (!equals || token(*equals) != "=") return false;
        const auto bracket = before(*equals);
        return bracket && token(*bracket) == "]";
    }

    bool write_array() {
        std::size_t open = *before(*before(at_));
        while (open > 0 && token(open) != "[") --open;
        const auto name = before(open);
        const auto type = name ? before(*name) : std::nullopt;
        if (!type) return false;
        const std::size_t close = closing(at_);
        result_.text.append(token(*type)).append("[](");
        ++at_;
        copy(close);
        result_.text += ")";
        ++at_;
        return true;
    }

    std::vector<ShaderToken> tokens_;
    bool guards_rounding_;
    std::set<std::string_view> precise_;  // the locals of this function that are declared PRECISE
    int depth_ = 0;                       // of braces
    std::size_t at_ = 0;
    PortableShader result_;
};

}  // namespace

PortableShader portable_shader(std::string_view text, bool guards_rounding) {
    return PortableWriter(text, guards_rounding).run();
}

}  // namespace momentscope
