#include "tests/fuzz/mutate.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <string_view>

namespace momentscope::fuzz {

namespace {

/// SplitMix64 (Steele et al. 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }
    /// In [0, count); 0 if count is 0.
    std::size_t below(std::size_t count) { return count == 0 ? 0 : next() % count; }
    template <typename Rows>
    const auto& one_of(const Rows& rows) {
        return rows[below(std::size(rows))];
    }

private:
    std::uint64_t state_;
};

using namespace std::string_view_literals;

constexpr std::array NUMBERS = {"0"sv,
                                "-0"sv,
                                "-1"sv,
                                "1"sv,
                                "0.5"sv,
                                "1e-45"sv,
                                "1e39"sv,
                                "-1e308"sv,
                                "1.7e308"sv,
                                "1e999"sv,
                                "5e-324"sv,
                                "nan"sv,
                                "inf"sv,
                                "-inf"sv,
                                "4294967295"sv,
                                "2147483648"sv,
                                "-2147483649"sv,
                                "1e-30"sv,
                                "18446744073709551615"sv,
                                "9223372036854775808"sv,
                                "65536"sv,
                                "3"sv,
                                "16777217"sv,
                                "1e5"sv};
constexpr std::array VALUES = {"null"sv,     "true"sv,  "{}"sv,           "[]"sv,      "\"\""sv,
                               "-1"sv,       "1e999"sv, "\"\\u0000\""sv,  "[[]]"sv,    "{\"a\":1}"sv,
                               "\"auto\""sv, "[0,0]"sv, "\"\xC3\xA9\""sv, "\"\xFF\""sv};
constexpr std::string_view LETTERS = "{}[]\",:\\/#\n\r\t -+.0eE19=@%\0\x7F\x80\xFF\xC3"sv;
constexpr std::array<std::uint32_t, 12> WORDS = {0,          1,          0xFFFFFFFF, 0x7FFFFFFF,
                                                 0x80000000, 0x7F800000, 0x7FC00000, 0xFF800000,
                                                 0x7F7FFFFF, 0x00010000, 4,          0x4E4F534A};

struct Part {
    std::size_t begin, length;
};

/// Changes one text; `donor` is another seed of the same reader.
class Mutator {
public:
    Mutator(std::string& text, std::string_view donor, Random& random)
        : text_(text), donor_(donor), random_(random) {}

    void change() {
        switch (random_.below(14)) {
            case 0:
                return flip_bit();
            case 1:
                return put(1, std::string(1, random_.one_of(LETTERS)));
            case 2:
                return put(0, std::string(1, random_.one_of(LETTERS)));
            case 3:
                return erase();
            case 4:
                return repeat();
            case 5:
                return text_.resize(random_.below(text_.size() + 1));
            case 6:
                return splice();
            case 7:
            case 8:
                return replace(token("-+.0123456789eE", true), random_.one_of(NUMBERS));
            case 9:
                return replace(json_value(), random_.one_of(VALUES));
            case 10:
                return replace(token(" \n,:=\"[]{}/", false), token_of_donor());
            case 11:
                return swap_lines();
            case 12:
                return put_word();
            default:
                return copy_part();
        }
    }

private:
    std::size_t place() { return random_.below(text_.size() + 1); }

    Part some_part() {
        const std::size_t begin = place();
        const std::size_t most = std::size_t{1} << random_.below(10);
        return {begin, std::min(random_.below(most) + 1, text_.size() - begin)};
    }

    void replace(const Part& part, std::string_view with) { text_.replace(part.begin, part.length, with); }

    void put(std::size_t instead_of, std::string_view what) {
        const std::size_t at = place();
        replace({at, std::min(instead_of, text_.size() - at)}, what);
    }

    void flip_bit() {
        if (text_.empty()) return;
        char& byte = text_[random_.below(text_.size())];
        byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << random_.below(8)));
    }

    void erase() { replace(some_part(), ""); }

    void repeat() {
        const Part part = some_part();
        const std::string once = text_.substr(part.begin, part.length);
        std::string all;
        for (std::size_t left = std::size_t{1} << random_.below(14); left > 0; --left)
            if (all.size() + once.size() <= MAX_BYTES) all += once;
        text_.insert(part.begin, all);
    }

    void splice() {
        text_.resize(place());
        text_ += donor_.substr(random_.below(donor_.size() + 1));
    }

    /// The next run of letters that are in this set, or of letters that are not, from a random place on.
    Part token(std::string_view letters, bool among) { return token_in(text_, place(), letters, among); }
    static Part token_in(std::string_view text, std::size_t from, std::string_view letters, bool among) {
        const std::size_t begin = std::min(
            among ? text.find_first_of(letters, from) : text.find_first_not_of(letters, from), text.size());
        const std::size_t end = std::min(
            among ? text.find_first_not_of(letters, begin) : text.find_first_of(letters, begin), text.size());
        return {begin, end - begin};
    }
    std::string_view token_of_donor() {
        const Part part = token_in(donor_, random_.below(donor_.size() + 1), " \n,:=\"[]{}/", false);
        return donor_.substr(part.begin, part.length);
    }

    /// The text after a colon, comma or bracket, up to the next one or up to the bracket that closes it.
    Part json_value() {
        const std::size_t before = std::min(text_.find_first_of(":,[{", place()), text_.size());
        const std::size_t begin = std::min(text_.find_first_not_of(" \n", before + 1), text_.size());
        std::size_t end = begin;
        int depth = 0;
        for (; end < text_.size(); ++end) {
            const char c = text_[end];
            if (depth == 0 && (c == ',' || c == '}' || c == ']' || c == ':')) break;
            depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
        }
        return {begin, end - begin};
    }

    Part line() {
        const std::size_t at = place();
        const std::size_t before = at == 0 ? text_.npos : text_.rfind('\n', at - 1);
        const std::size_t begin = before == text_.npos ? 0 : before + 1;
        return {begin, std::min(text_.find('\n', begin), text_.size()) - begin};
    }

    void swap_lines() {
        Part a = line(), b = line();
        if (a.begin > b.begin) std::swap(a, b);
        if (a.begin + a.length > b.begin) return;
        const std::string first = text_.substr(a.begin, a.length), second = text_.substr(b.begin, b.length);
        replace(b, first);
        replace(a, second);
    }

    void put_word() {
        const std::uint32_t word = random_.one_of(WORDS);
        if (text_.size() < sizeof word) return;
        std::memcpy(text_.data() + random_.below(text_.size() / sizeof word) * sizeof word, &word,
                    sizeof word);
    }

    void copy_part() {
        const Part part = some_part();
        const std::string copy = text_.substr(part.begin, part.length);
        put(random_.below(2) * copy.size(), copy);
    }

    std::string& text_;
    std::string_view donor_;
    Random& random_;
};

}  // namespace

Input mutated_input(const std::vector<Input>& seeds, std::uint64_t random_seed, std::uint64_t number) {
    Random random(random_seed * 0x2545F4914F6CDD1DU + number);
    std::vector<std::string_view> readers;
    for (const Input& seed : seeds)
        if (readers.empty() || readers.back() != seed.reader) readers.push_back(seed.reader);
    const std::string_view reader = readers[number % readers.size()];
    std::vector<const Input*> own;
    for (const Input& seed : seeds)
        if (seed.reader == reader) own.push_back(&seed);
    Input input = *random.one_of(own);
    Mutator mutator(input.bytes, random.one_of(own)->bytes, random);
    for (std::size_t left = 1 + random.below(std::size_t{1} << random.below(5)); left > 0; --left) {
        mutator.change();
        if (input.bytes.size() > MAX_BYTES) input.bytes.resize(MAX_BYTES);
    }
    return input;
}

}  // namespace momentscope::fuzz
