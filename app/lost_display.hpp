// lost_display.hpp -- when the display goes away, tells the user so and where the work was saved.
#pragma once
#include <functional>
#include <string>

namespace momentscope {

/// During its lifetime, the end of the window system ends the program with exit code 1 and this sentence.
/// Without it, Xlib would end the program with a message of its own, and nothing could be saved. Only one
/// object may exist at a time.
class LostDisplay {
public:
    /// `last_words` saves the session if possible and returns a sentence. It must neither throw nor draw.
    explicit LostDisplay(std::function<std::string()> last_words);
    ~LostDisplay();
    LostDisplay(const LostDisplay&) = delete;
    LostDisplay& operator=(const LostDisplay&) = delete;
};

}  // namespace momentscope
