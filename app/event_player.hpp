// event_player.hpp -- replays mouse and keyboard from a text file: docs/events.md.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/headless_window.hpp"

namespace momentscope {

class EventPlayer {
public:
    /// Screenshots are not taken into `kept` files.
    explicit EventPlayer(HeadlessWindow& window, std::vector<std::string> kept = {})
        : window_(window), kept_(std::move(kept)) {}

    /// Plays events line by line; each is drawn before the next. Throws Error that names the line.
    void play(const std::string& text);
    void play_file(const std::filesystem::path& path);

private:
    void play_line(const std::string& line);
    bool play_mouse(const std::vector<std::string>& words);  // false when it is no such event
    bool play_keyboard(const std::vector<std::string>& words, const std::string& rest);
    void move(ImVec2 to);
    void button(int which, bool down);
    void click(ImVec2 at, int which);
    void drag(ImVec2 from, ImVec2 to, int which);
    void key(const std::string& name, bool down);
    void wait(double seconds);
    void screenshot(const std::string& path) const;
    void expect(const std::string& pointer, const std::string& value) const;
    ImVec2 place(const std::vector<std::string>& words, std::size_t& next) const;

    HeadlessWindow& window_;
    std::vector<std::string> kept_;
};

}  // namespace momentscope
