// shader_writer.cpp -- writes every shader of every technique, expanded, into a folder, for linting.
#include <fmt/format.h>

#include <cstdio>

#include "core/error.hpp"
#include "core/gl/program.hpp"
#include "core/output_file.hpp"
#include "core/render/moment_passes.hpp"

namespace {

using namespace momentscope;

constexpr const char* PLAIN[] = {
    "passes/scene.vert",     "passes/fullscreen.vert",    "passes/opaque.frag",
    "passes/composite.frag", "passes/display.frag",       "passes/capture.frag",
    "passes/sorted.frag",    "passes/peel.frag",          "passes/peel_composite.frag",
    "passes/copy.frag",      "passes/failure_colors.frag"};
constexpr const char* PER_TECHNIQUE[] = {"passes/moments.frag", "passes/color.frag",
                                         "passes/capture.frag", "passes/failures.frag",
                                         "tests/evaluate.comp", "tests/evaluate.frag"};

void write(const std::filesystem::path& folder, const std::string& prefix, const std::string& path,
           const ShaderVariant& variant) {
    const std::string name = std::filesystem::path(path).filename().string();
    write_text_file(expand_shader(path, variant),
                    folder / (prefix + "." + name));  // glslang reads the stage from the end
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 1;
    try {
        for (const char* path : PLAIN) write(argv[1], "plain", path, {});
        for (const Technique& technique : techniques()) {
            if (technique.kernel == nullptr) continue;
            ShaderVariant variant = moment_variant(technique);
            variant.defines["WITH_TRANSMITTANCE"] = "1";
            for (const char* path : PER_TECHNIQUE) write(argv[1], technique.id, path, variant);
        }
    } catch (const Error& error) {
        std::fputs(fmt::format("momentscope_shaders: {}\n", error.what()).c_str(), stderr);
        return 1;
    }
}
