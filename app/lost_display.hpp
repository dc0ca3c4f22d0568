// lost_display.hpp -- what a user reads when the display goes away: a sentence, and where the work is.
#pragma once
#include <functional>
#include <string>

namespace momentscope {

/// While it lives, a window system that ends under the program ends it with exit code 1 and that sentence.
/// Xlib would end it with a line of its own, and nothing could be saved. Only one may live at a time.
class LostDisplay {
public:
    /// `last_words` saves what it can and says so; it neither throws nor draws.
    explicit LostDisplay(std::function<std::string()> last_words);
    ~LostDisplay();
    LostDisplay(const LostDisplay&) = delete;
    LostDisplay& operator=(const LostDisplay&) = delete;
};

}  // namespace momentscope
