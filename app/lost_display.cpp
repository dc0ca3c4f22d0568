#include "app/lost_display.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <utility>

#include "app/terminal.hpp"

namespace momentscope {

namespace {

// If GLFW uses Xlib, the library is loaded already. Otherwise, for instance under Wayland, it is not needed.
using IoErrorHandler = int (*)(void* display);
using SetIoErrorHandler = IoErrorHandler (*)(IoErrorHandler);

std::function<std::string()> words_for_lost_display;
IoErrorHandler handler_before = nullptr;

SetIoErrorHandler set_io_error_handler() {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): dlsym knows no types
    return reinterpret_cast<SetIoErrorHandler>(::dlsym(RTLD_DEFAULT, "XSetIOErrorHandler"));
}

// Xlib calls this in the middle of one of its functions, so Xlib must not be called any more. Destructors
// would call it, so exit directly.
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
