#include "app/lost_display.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <utility>

#include "app/terminal.hpp"

namespace momentscope {

namespace {

// Xlib is there when GLFW uses it, and is not asked for otherwise: under Wayland there is none.
using IoErrorHandler = int (*)(void* display);
using SetIoErrorHandler = IoErrorHandler (*)(IoErrorHandler);

std::function<std::string()> words_for_lost_display;
IoErrorHandler handler_before = nullptr;

SetIoErrorHandler set_io_error_handler() {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): dlsym knows no types
    return reinterpret_cast<SetIoErrorHandler>(::dlsym(RTLD_DEFAULT, "XSetIOErrorHandler"));
}

// Xlib calls it in the midst of one of its functions and may not be asked for anything any more. Destructors
// would do that.
int end_without_display(void*) {
    if (words_for_lost_display) warn(std::exchange(words_for_lost_display, nullptr)());
    ::_exit(1);
}

}  // namespace

LostDisplay::LostDisplay(std::function<std::string()> last_words) {
    words_for_lost_display = std::move(last_words);
    if (const auto set = set_io_error_handler()) handler_before = set(end_without_display);
}

LostDisplay::~LostDisplay() {
    words_for_lost_display = nullptr;
    if (const auto set = set_io_error_handler()) set(handler_before);
}

}  // namespace momentscope
