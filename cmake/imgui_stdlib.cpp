// imgui_stdlib.cpp -- what the program uses of imgui_stdlib.h, for libc++: the library of Debian has it only
// for the std::string of libstdc++ (cmake/libcxx.cmake).
#include <imgui.h>
#include <imgui_stdlib.h>

namespace {

struct Edited {
    std::string* text;
    ImGuiInputTextCallback callback;
    void* user_data;
};

// Dear ImGui calls this when the text needs more room than it has.
int resize(ImGuiInputTextCallbackData* data) {
    const auto* const edited = static_cast<Edited*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        edited->text->resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = edited->text->data();
        return 0;
    }
    data->UserData = edited->user_data;
    return edited->callback != nullptr ? edited->callback(data) : 0;
}

}  // namespace

bool ImGui::InputTextWithHint(const char* label, const char* hint, std::string* str,
                              ImGuiInputTextFlags flags, ImGuiInputTextCallback callback, void* user_data) {
    Edited edited{str, callback, user_data};
    return InputTextWithHint(label, hint, str->data(), str->capacity() + 1,
                             flags | ImGuiInputTextFlags_CallbackResize, resize, &edited);
}
