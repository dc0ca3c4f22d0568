#include "core/support/bounded_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

struct Extent {
    int nesting = 0;         // deepest nesting of brackets outside of strings
    std::size_t values = 1;  // upper limit: one at the beginning, the others after a bracket or a comma
};

// Counts in advance, so that a text which is not accepted costs no memory. A parser callback would make
// reading quadratic.
Extent extent_of(const std::string& text) {
    Extent extent;
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string && c == '\\') ++i;  // an escaped character never ends the string
        if (c == '"') in_string = !in_string;
        if (in_string) continue;
        if (c == '[' || c == '{') extent.nesting = std::max(extent.nesting, ++depth);
        if (c == '[' || c == '{' || c == ',') ++extent.values;
        if (c == ']' || c == '}') --depth;
    }
    return extent;
}

}  // namespace

nlohmann::json parse_bounded_json(const std::string& text, const JsonBounds& bounds) {
    if (text.size() > bounds.bytes)
        throw Error(fmt::format("it is larger than {} MiB; make it smaller.", bounds.bytes >> 20));
    const Extent extent = extent_of(text);
    if (extent.nesting > bounds.nesting) throw Error("it is nested too deeply; see the README for its form.");
    if (extent.values > bounds.values)
        throw Error(fmt::format("it holds more than {} values; make it smaller.", bounds.values));
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        throw Error(fmt::format("it is not valid JSON at byte {}; correct it there.", error.byte));
    } catch (const nlohmann::json::exception&) {  // for example, a number too large for a double
        throw Error("it holds a value that JSON cannot represent; give finite numbers.");
    }
}

}  // namespace momentscope
