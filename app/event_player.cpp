#include "app/event_player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "core/support/bounded_json.hpp"
#include "core/support/error.hpp"
#include "core/support/input_file.hpp"
#include "core/support/json_text.hpp"
#include "core/support/parse_number.hpp"
#include "core/support/reachable.hpp"
#include "ui/model/session.hpp"
#include "ui/widgets/shortcut.hpp"

namespace momentscope {

namespace {

constexpr std::uintmax_t MAX_EVENT_BYTES = 16U << 20;
constexpr std::uintmax_t MAX_EXPECTED_BYTES = 1U << 20;
constexpr std::size_t MAX_WORDS = 16;  // an event has fewer; further words have no meaning
constexpr int DRAG_STEPS = 8;

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; words.size() < MAX_WORDS && stream >> word && !word.starts_with('#');)
        words.push_back(word);
    return words;
}

float need_number(const std::vector<std::string>& words, std::size_t at, float least, float most) {
    const auto value = at < words.size() ? parse_number<float>(words[at]) : std::nullopt;
    if (!value || !(*value >= least && *value <= most))
        throw Error(fmt::format("'{}' needs a number from {:g} to {:g}", words[0], least, most));
    return *value;
}

const std::string& need_word(const std::vector<std::string>& words, std::size_t at, const char* what) {
    if (at >= words.size()) throw Error(fmt::format("'{}' needs {}", words[0], what));
    return words[at];
}

int button_of(const std::vector<std::string>& words, std::size_t at) {
    if (at >= words.size() || words[at] == "left") return ImGuiMouseButton_Left;
    if (words[at] == "right") return ImGuiMouseButton_Right;
    if (words[at] == "middle") return ImGuiMouseButton_Middle;
    throw Error(fmt::format("there is no mouse button '{}'; use left, right or middle", words[at]));
}

nlohmann::json expected_value(const std::string& text) {
    try {
        return parse_bounded_json(text, {.bytes = MAX_EXPECTED_BYTES});
    } catch (const Error&) {
        return text;  // a word without quotes is a string
    }
}

std::string after_first_word(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(" \t");
    const std::size_t space = line.find(' ', begin);
    return space == std::string::npos ? "" : line.substr(space + 1);
}

}  // namespace

// "X Y" in pixels, "@name" for the middle of a control, "@name FX FY" for a fraction of it.
ImVec2 EventPlayer::place(const std::vector<std::string>& words, std::size_t& next) const {
    const std::string& first = need_word(words, next, "a place: X Y, or @control");
    if (!first.starts_with('@')) {
        const ImVec2 at = {need_number(words, next, -1e5f, 1e5f), need_number(words, next + 1, -1e5f, 1e5f)};
        next += 2;
        return at;
    }
    const auto& widget_rects = window_.explorer().workspace().widget_rects;
    const auto found = widget_rects.find(first.substr(1));
    if (found == widget_rects.end())
        throw Error(fmt::format("there is no control '{}' in the window now", first));
    ++next;
    ImVec2 share = {0.5f, 0.5f};
    if (next + 1 < words.size() && parse_number<float>(words[next]) && parse_number<float>(words[next + 1])) {
        share = {need_number(words, next, -100, 100), need_number(words, next + 1, -100, 100)};
        next += 2;
    }
    const ui::Rect& rect = found->second;
    return {rect.low.x + share.x * (rect.high.x - rect.low.x),
            rect.low.y + share.y * (rect.high.y - rect.low.y)};
}

void EventPlayer::move(ImVec2 to) {
    ImGui::GetIO().MousePos = to;
    window_.settle();
}

void EventPlayer::button(int which, bool down) {
    ImGui::GetIO().MouseDown[which] = down;
    window_.settle();
}

void EventPlayer::click(ImVec2 at, int which) {
    move(at);
    button(which, true);
    button(which, false);
}

void EventPlayer::drag(ImVec2 from, ImVec2 to, int which) {
    move(from);
    button(which, true);
    for (int i = 1; i <= DRAG_STEPS; ++i) {
        const float share = static_cast<float>(i) / DRAG_STEPS;
        move({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
    }
    button(which, false);
}

void EventPlayer::key(const std::string& name, bool down) {
    if (name == "Ctrl" || name == "Shift") {  // so that a click can have a held key
        (name == "Ctrl" ? ImGui::GetIO().KeyCtrl : ImGui::GetIO().KeyShift) = down;
        return window_.settle();
    }
    const auto shortcut = ui::parse_shortcut(name);
    if (!shortcut)
        throw Error(
            fmt::format("there is no key '{}'; use names such as Ctrl+Z, Left, F1 or a letter", name));
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = down && shortcut->ctrl;
    io.KeyShift = down && shortcut->shift;
    if (shortcut->key != 0) io.KeysDown[shortcut->key] = down;
    // A real keyboard also sends the character.
    if (down && shortcut->character != 0) io.AddInputCharacter(static_cast<unsigned>(shortcut->character));
    const bool letter = shortcut->key > ' ' && shortcut->key < 128;
    if (down && letter && !shortcut->ctrl) {
        const int c = shortcut->key;
        io.AddInputCharacter(static_cast<unsigned>(shortcut->shift ? c : std::tolower(c)));
    }
    window_.settle();
}

// Draws only the frames that are needed; the next one comes after this time.
void EventPlayer::wait(double seconds) {
    const long before = window_.log().frames();
    window_.idle();
    window_.pass(static_cast<float>(seconds));
    window_.log().line(fmt::format("waited {:g} s: {} frames", seconds, window_.log().frames() - before));
}

// It may replace an older picture, because events are played repeatedly, but no other file.
void EventPlayer::screenshot(const std::string& path) const {
    if (std::filesystem::path(path).extension() != ".png")
        throw Error(fmt::format("a screenshot is a .png file; '{}' is not", path));
    for (const std::string& file : kept_)
        if (same_file(path, file))
            throw Error(fmt::format("'{}' is already used by this command line; give another name", path));
    window_.write_png(path);
}

void EventPlayer::expect(const std::string& pointer, const std::string& value) const {
    const auto found = ui::session_value(window_.explorer().workspace().state, pointer);
    if (!found) throw Error(fmt::format("a session has no '{}'", pointer));
    const nlohmann::json wanted = expected_value(value);
    const bool close =
        found->is_number() && wanted.is_number() &&
        std::abs(found->get<double>() - wanted.get<double>()) <= 1e-6 * (1 + std::abs(wanted.get<double>()));
    if (!close && *found != wanted)
        throw Error(fmt::format("{} is {}, not {}", pointer, json_text(*found), value));
}

void EventPlayer::expect_done() const {
    const ui::ExplorerState& state = window_.explorer().workspace().state;
    if (!window_.step_is_done())
        throw Error(state.card.empty()
                        ? "no lesson is open"
                        : fmt::format("step {} of the lesson '{}' is not done", state.step + 1, state.card));
}

bool EventPlayer::play_mouse(const std::vector<std::string>& words) {
    const std::string& what = words[0];
    std::size_t next = 1;
    if (what == "move") {
        move(place(words, next));
    } else if (what == "press" || what == "release") {
        button(button_of(words, 1), what == "press");
    } else if (what == "click" || what == "doubleclick") {
        const ImVec2 at = place(words, next);
        const int which = button_of(words, next);
        click(at, which);
        if (what == "doubleclick") click(at, which);
    } else if (what == "drag") {
        const ImVec2 from = place(words, next);
        if (need_word(words, next, "'to' and a second place") != "to")
            throw Error("'drag' needs 'to' and a second place");
        ++next;
        const ImVec2 to = place(words, next);
        drag(from, to, button_of(words, next));
    } else if (what == "wheel") {
        ImGui::GetIO().MouseWheel = need_number(words, 1, -100, 100);
        window_.settle();
    } else {
        return false;
    }
    return true;
}

bool EventPlayer::play_keyboard(const std::vector<std::string>& words, const std::string& rest) {
    const std::string& what = words[0];
    if (what == "key") {
        key(need_word(words, 1, "the name of a key"), true);
        key(words[1], false);
    } else if (what == "hold" || what == "let") {
        key(need_word(words, 1, "the name of a key"), what == "hold");
    } else if (what == "type") {
        ImGui::GetIO().AddInputCharactersUTF8(rest.c_str());
        window_.settle();
    } else {
        return false;
    }
    return true;
}

void EventPlayer::play_line(const std::string& line) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) return;
    const std::string& what = words[0];
    const std::string rest = after_first_word(line);
    if (play_mouse(words) || play_keyboard(words, rest)) return;
    if (what == "wait") {
        wait(static_cast<double>(need_number(words, 1, 0, 1e6f)));
    } else if (what == "resize") {
        constexpr float MAX_SIDE = MAX_PICTURE_SIDE;
        window_.resize({static_cast<int>(need_number(words, 1, 1, MAX_SIDE)),
                        static_cast<int>(need_number(words, 2, 1, MAX_SIDE))});
        window_.settle();
    } else if (what == "drop") {
        window_.explorer().workspace().files.open_dropped(need_word(words, 1, "a file"));
        window_.settle();
    } else if (what == "where") {
        std::size_t next = 1;
        const ImVec2 at = place(words, next);
        window_.log().line(fmt::format("{} is at {:.0f} {:.0f}", words[1], at.x, at.y));
    } else if (what == "screenshot") {
        screenshot(need_word(words, 1, "the name of a .png"));
    } else if (what == "expect") {
        expect(need_word(words, 1, "a JSON pointer"), need_word(words, 2, "a value"));
    } else if (what == "expect-done") {
        expect_done();
    } else if (what == "expect-message") {
        const std::string& message = window_.explorer().workspace().status.message;
        if (message.find(rest) == std::string::npos) throw Error(fmt::format("the message is '{}'", message));
    } else {
        throw Error(fmt::format("there is no event '{}'; docs/events.md lists them", what));
    }
}

void EventPlayer::play(const std::string& text) {
    std::istringstream stream(text);
    int number = 0;
    window_.idle();
    for (std::string line; std::getline(stream, line);) {
        ++number;
        try {
            play_line(line);
        } catch (const Error& error) {
            std::string why = error.what();
            if (why.ends_with('.')) why.pop_back();
            throw Error(fmt::format("Line {} of the events, '{:.200}': {:.400}.", number, line, why));
        }
    }
}

void EventPlayer::play_file(const std::filesystem::path& path) {
    play(read_input_file(path, MAX_EVENT_BYTES, "event"));
}

}  // namespace momentscope
