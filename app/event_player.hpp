// event_player.hpp -- replays mouse and keyboard events from a text file: docs/events.md.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/headless_window.hpp"

namespace momentscope {

class EventPlayer {
public:
    /// Screenshots never overwrite the files in `kept`.
    explicit EventPlayer(HeadlessWindow& window, std::vector<std::string> kept = {})
        : window_(window), kept_(std::move(kept)) {}

    /// Plays the events line by line and draws each one before the next. Throws Error with the line.
    void play(const std::string& text);
    void play_file(const std::filesystem::path& path);

private:
    void play_line(const std::string& line);
    bool play_mouse(const std::vector<std::string>& words);  // false if it is another event
    bool play_keyboard(const std::vector<std::string>& words, const std::string& rest);
    void move(ImVec2 to);
    void button(int which, bool down);
    void click(ImVec2 at, int which);
    void drag(ImVec2 from, ImVec2 to, int which);
    void key(const std::string& name, bool down);
    void wait(double seconds);
    void screenshot(const std::string& path) const;
    void expect_done() const;
    void expect(const std::string& pointer, const std::string& value) const;
    ImVec2 place(const std::vector<std::string>& words, std::size_t& next) const;

    HeadlessWindow& window_;
    std::vector<std::string> kept_;
};

}  // namespace momentscope
