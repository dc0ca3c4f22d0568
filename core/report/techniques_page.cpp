#include "core/report/techniques_page.hpp"

#include <fmt/format.h>

#include <iterator>

#include "core/techniques/technique.hpp"

namespace momentscope {

namespace {

std::string passes_text(const Technique& technique) {
    return technique.geometry_passes > 0 ? fmt::format("{}", technique.geometry_passes) : "one per layer";
}

}  // namespace

std::string techniques_page() {
    std::string text =
        "# Techniques\n\n"
        "Written by `momentscope list techniques --format markdown`. Memory is in bits per pixel, with all parameters at their "
        "defaults and without the colour buffers that every technique has. It is what the technique stores, and what it "
        "needs with the factor that is stored once per pixel (`--factorisation per-fragment` needs none).\n\n"
        "| id | name | stored | with the factor | geometry passes | order of submission |\n|---|---|---|---|---|---|\n";
    const auto out = std::back_inserter(text);
    for (const Technique& technique : techniques())
        fmt::format_to(out, "| `{}` | {} | {} | {} | {} | {} |\n", technique.id, technique.name,
                       bits_text(technique, stored_bits(technique, {})),
                       bits_text(technique, bits_with_factor(technique, {})), passes_text(technique),
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
