#include "core/bounded_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace momentscope {

namespace {

constexpr int MAX_NESTING = 16;  // a session with a ray needs 5; deeper is refused before it costs memory

// The deepest nesting of brackets outside strings. Counted beforehand: a parser callback would make reading
// quadratic.
int nesting(const std::string& text) {
    int depth = 0;
    int deepest = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string && c == '\\') ++i;  // whatever is escaped, it does not end the string
        if (c == '"') in_string = !in_string;
        if (in_string) continue;
        if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
        if (c == ']' || c == '}') --depth;
    }
    return deepest;
}

}  // namespace

nlohmann::json parse_bounded_json(const std::string& text, std::uintmax_t most_bytes) {
    if (text.size() > most_bytes)
        throw Error(fmt::format("it is larger than {} MiB; make it smaller.", most_bytes >> 20));
    if (nesting(text) > MAX_NESTING) throw Error("it is nested too deeply; see the README for its form.");
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        throw Error(fmt::format("it is not valid JSON at byte {}; correct it there.", error.byte));
    } catch (const nlohmann::json::exception&) {  // a number beyond a double, for instance
        throw Error("it holds a value that JSON cannot carry; give finite numbers.");
    }
}

}  // namespace momentscope
