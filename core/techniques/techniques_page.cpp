#include "core/techniques/techniques_page.hpp"

#include <fmt/format.h>

#include <iterator>

#include "core/techniques/technique.hpp"

namespace momentscope {

namespace {

std::string memory_text(const Technique& technique) {
    const int bits = bits_per_pixel(technique, ParameterValues());
    if (bits > 0) return fmt::format("{}", bits);
    return technique.is_truth() ? "grows with the fragments" : "none";
}

std::string passes_text(const Technique& technique) {
    return technique.geometry_passes > 0 ? fmt::format("{}", technique.geometry_passes) : "one per layer";
}

}  // namespace

std::string techniques_page() {
    std::string text =
        "# Techniques\n\n"
        "Written by `momentscope list techniques --format markdown`; memory is in bits per pixel with all parameters at their "
        "standard, beside the colour buffers that every technique has.\n\n"
        "| id | name | memory | geometry passes | order of submission |\n|---|---|---|---|---|\n";
    const auto out = std::back_inserter(text);
    for (const Technique& technique : techniques())
        fmt::format_to(out, "| `{}` | {} | {} | {} | {} |\n", technique.id, technique.name,
                       memory_text(technique), passes_text(technique),
                       technique.order_dependent ? "changes the picture" : "does not matter");
    for (const Technique& technique : techniques()) {
        fmt::format_to(out, "\n## `{}`: {}\n\n{}\n\nSource: {}.", technique.id, technique.name,
                       technique.description, technique.source);
        std::string options;
        for (const ParameterId id : technique.parameters)
            fmt::format_to(std::back_inserter(options), "{}`--{}`", options.empty() ? "" : ", ",
                           parameter(id).key);
        text += options.empty() ? "\n" : fmt::format(" Parameters: {}.\n", options);
    }
    return text;
}

}  // namespace momentscope
