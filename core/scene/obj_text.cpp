// obj_text.cpp -- one pass over the lines of an OBJ file.
#include "core/scene/obj_text.hpp"

#include "core/scene/mesh_error.hpp"
#include "core/support/real_from_chars.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <system_error>
#include <vector>

namespace momentscope {
namespace {

constexpr std::size_t MAX_QUOTED = 40;                     // characters of a word in an error message
constexpr std::int64_t MAX_INDEX = std::int64_t{1} << 28;  // more vertices than a file can hold

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0';
}

/// The decimal number, if it is the whole word. Numbers too small for a double become 0. nullopt for infinite
/// numbers and NaN.
std::optional<double> number_in(std::string_view word) {
    const bool is_signed = word.starts_with('-') || word.starts_with('+');
    const char first = word.size() > (is_signed ? 1 : 0) ? word[is_signed ? 1 : 0] : ' ';
    if (!(first >= '0' && first <= '9') && first != '.') return std::nullopt;  // "inf", "nan", "+-1"
    if (word.starts_with('+')) word.remove_prefix(1);  // from_chars does not accept this sign
    double value = 0.0;
    const auto [end, code] = real_from_chars(word, value);
    if (end != word.data() + word.size()) return std::nullopt;
    if (code == std::errc()) return value;
    const std::size_t exponent = word.find_first_of("eE");
    const bool tiny =
        exponent != word.npos ? word.substr(exponent + 1).starts_with('-') : first == '0' || first == '.';
    return code == std::errc::result_out_of_range && tiny ? std::optional(0.0) : std::nullopt;
}

class ObjReader {
public:
    explicit ObjReader(const std::filesystem::path& path) : path_(path) {}

    void read(std::string_view source) {
        std::string joined;
        while (!source.empty()) {
            std::string_view line = next_line(source);
            joined.clear();
            while (line.ends_with('\\') && !source.empty()) {  // the next line continues this one
                joined += joined.empty() ? line : std::string_view();
                joined.back() = ' ';
                joined += next_line(source);
                line = joined;
            }
            read_line(line);
            line_ = next_;
        }
    }

    ObjText finish();

private:
    /// Removes the first line and returns it. Lines end in \n, \r\n or, as on old Macintoshes, \r.
    std::string_view next_line(std::string_view& source) {
        const std::size_t end = std::min(source.find_first_of("\r\n"), source.size());
        const std::string_view line = source.substr(0, end);
        const bool both = source.substr(end).starts_with("\r\n");
        source.remove_prefix(std::min(end + (both ? 2 : 1), source.size()));
        ++next_;
        return line;
    }

    [[noreturn]] void refuse(const std::string& what_and_what_to_do) const {
        refuse_mesh(path_, "cannot be read: line " + std::to_string(line_) + " " + what_and_what_to_do);
    }

    static std::string quoted(std::string_view word) {
        return "'" + std::string(word.substr(0, MAX_QUOTED)) + "'";
    }

    void split(std::string_view line);
    void read_line(std::string_view line);
    void read_vertex();
    void read_directions(std::size_t fewest);
    void read_face();
    std::int64_t index_in(std::string_view word, std::int64_t count) const;
    void write_vertices(std::string& text, const glm::dvec3& center, double half_diagonal) const;

    const std::filesystem::path& path_;
    std::size_t line_ = 1;  // number of the current line
    std::size_t next_ = 1;  // number of the first line that was not read yet
    std::vector<std::string_view> words_;
    std::vector<glm::dvec3> vertices_;
    std::vector<bool> used_;  // by a face
    std::int64_t texture_coordinate_count_ = 0;
    std::int64_t normal_count_ = 0;
    std::int64_t largest_index_ = 0;
    std::size_t line_of_largest_ = 0;
    std::string rest_;  // everything except the vertices
    std::size_t not_shown_ = 0;
};

/// Splits a line into words and removes its comment.
void ObjReader::split(std::string_view line) {
    words_.clear();
    line = line.substr(0, line.find('#'));
    std::size_t at = 0;
    while (at < line.size()) {
        const std::size_t begin = at;
        while (at < line.size() && !is_blank(line[at])) ++at;
        if (at > begin) words_.push_back(line.substr(begin, at - begin));
        ++at;
    }
}

void ObjReader::read_line(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    split(line);
    if (words_.empty()) return;
    const std::string_view what = words_.front();
    if (what == "v") return read_vertex();
    if (what == "vt" || what == "vn") return read_directions(what == "vt" ? 2 : 3);
    if (what == "f" || what == "fo") return read_face();
    if (what == "p" || what == "l" || what == "curv" || what == "curv2" || what == "surf") {
        ++not_shown_;
    } else if (what == "o" || what == "g" || what == "usemtl" || what == "mtllib") {
        rest_ += line;  // names may contain blanks and #
        rest_ += '\n';
    }
}

/// Reads x, y and z. A weight, which only curves use, or a colour may follow. Both are ignored.
void ObjReader::read_vertex() {
    const std::size_t count = words_.size() - 1;
    if (count < 3 || count == 5 || count > 7)
        refuse("has a vertex of " + std::to_string(count) + " numbers; give it x, y and z.");
    glm::dvec3 position(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = words_[static_cast<std::size_t>(axis) + 1];
        const std::optional<double> value = number_in(word);
        if (!value)
            refuse("has " + quoted(word) + ", which is not a finite decimal number; write one such as 1.5.");
        position[axis] = *value;
    }
    vertices_.push_back(position);
}

/// Reads a normal or texture coordinates. `fewest` numbers are needed; more are ignored. Exporters write
/// "nan" for unknown normals.
void ObjReader::read_directions(std::size_t fewest) {
    (fewest == 2 ? texture_coordinate_count_ : normal_count_) += 1;
    rest_ += words_.front();
    for (std::size_t i = 1; i <= fewest; ++i) {
        const std::optional<double> value = i < words_.size() ? number_in(words_[i]) : std::nullopt;
        const double most = std::numeric_limits<float>::max();
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits,
                                       static_cast<float>(std::clamp(value.value_or(0.0), -most, most)));
        rest_ += ' ';
        rest_.append(digits, end.ptr);
    }
    rest_ += '\n';
}

/// The index from 0. In the file, indices count from 1; negative ones count back from the last vertex that
/// was read.
std::int64_t ObjReader::index_in(std::string_view word, std::int64_t count) const {
    std::string_view digits = word;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::int64_t index = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (code != std::errc() || end != digits.data() + digits.size() || index == 0)
        refuse("has " + quoted(word) +
               " in a face, where the number of a vertex belongs; write one such as 1.");
    const std::int64_t absolute = index < 0 ? count + 1 + index : index;
    if (absolute < 1 || absolute > MAX_INDEX)
        refuse("has a face with vertex " + quoted(word) + " of " + std::to_string(count) +
               "; repair it or export it again.");
    return absolute;
}

/// Reads a face. Its corners are v, v/vt, v//vn or v/vt/vn.
void ObjReader::read_face() {
    if (words_.size() < 4) {
        ++not_shown_;
        return;
    }
    rest_ += 'f';
    for (std::size_t i = 1; i < words_.size(); ++i) {
        const std::string_view corner = words_[i];
        const std::size_t first = std::min(corner.find('/'), corner.size());
        const std::size_t second = std::min(corner.find('/', first + 1), corner.size());
        const std::int64_t v = index_in(corner.substr(0, first), static_cast<std::int64_t>(vertices_.size()));
        if (v > largest_index_) {
            largest_index_ = v;
            line_of_largest_ = line_;
        }
        const auto place = static_cast<std::size_t>(v - 1);
        if (place >= used_.size()) used_.resize(std::max(place + 1, vertices_.size()));
        used_[place] = true;
        rest_ += ' ' + std::to_string(v);
        const std::string_view vt = first < corner.size() ? corner.substr(first + 1, second - first - 1) : "";
        const std::string_view vn = second < corner.size() ? corner.substr(second + 1) : "";
        if (!vt.empty()) rest_ += '/' + std::to_string(index_in(vt, texture_coordinate_count_));
        if (!vn.empty()) rest_ += (vt.empty() ? "//" : "/") + std::to_string(index_in(vn, normal_count_));
    }
    rest_ += '\n';
}

/// Writes coordinates in [-1, 1] with 12 decimals, which is a millionth of the step of floats at 1. Vertices
/// that no face uses are written as 0, so that indices stay valid.
void ObjReader::write_vertices(std::string& text, const glm::dvec3& center, double half_diagonal) const {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const bool used = i < used_.size() && used_[i];
        text += 'v';
        for (int axis = 0; axis < 3; ++axis) {
            // Halves, so that the difference of the largest doubles does not overflow.
            const double half = 0.5 * vertices_[i][axis] - 0.5 * center[axis];
            const double value = used ? 2.0 * (half / half_diagonal) : 0.0;
            char digits[32];
            const auto end =
                std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 12);
            text += ' ';
            text.append(digits, end.ptr);
        }
        text += '\n';
    }
}

ObjText ObjReader::finish() {
    if (largest_index_ > static_cast<std::int64_t>(vertices_.size())) {
        line_ = line_of_largest_;
        refuse("has a face with vertex " + std::to_string(largest_index_) + " of " +
               std::to_string(vertices_.size()) + "; repair it or export it again.");
    }
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (std::size_t i = 0; i < used_.size(); ++i) {
        if (!used_[i]) continue;
        low = glm::min(low, vertices_[i]);
        high = glm::max(high, vertices_[i]);
    }
    ObjText result{"", not_shown_, 0.0, 0.0};
    glm::dvec3 center(0.0);
    if (largest_index_ > 0) {
        center = 0.5 * low + 0.5 * high;
        const glm::dvec3 half = 0.5 * high - 0.5 * low;
        result.half_diagonal = std::hypot(half.x, half.y, half.z);
        for (int axis = 0; axis < 3; ++axis)
            result.coordinate = std::max({result.coordinate, std::abs(low[axis]), std::abs(high[axis])});
    }
    write_vertices(result.text, center, result.half_diagonal > 1e-300 ? result.half_diagonal : 1.0);
    result.text += rest_;
    return result;
}

}  // namespace

ObjText readable_obj(std::string_view source, const std::filesystem::path& path) {
    ObjReader reader(path);
    reader.read(source);
    return reader.finish();
}

bool looks_like_obj(std::string_view source) {
    const auto has_line = [&](std::string_view beginning) {
        for (std::size_t at = source.find(beginning); at != source.npos; at = source.find(beginning, at + 1))
            if (at == 0 || source[at - 1] == '\n' || source[at - 1] == '\r') return true;
        return false;
    };
    return has_line("v ") && has_line("f ");
}

}  // namespace momentscope
