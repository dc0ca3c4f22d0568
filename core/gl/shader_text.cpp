#include "core/gl/shader_text.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "core/gl/loop_writer.hpp"
#include "core/gl/shader_namespace.hpp"
#include "core/gl/shader_sources.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

// What a define needs in fragment shaders. Extensions stand before everything else.
constexpr std::pair<const char*, const char*> EXTENSIONS[] = {
    {"INTERLOCK", "GL_ARB_fragment_shader_interlock"},
    {"FRAMEBUFFER_FETCH", "GL_EXT_shader_framebuffer_fetch"},
};

// Hides a value from a driver that re-associates: it cannot know that the uniform, which nothing sets, is 0.
constexpr const char* GUARD =
    "uniform uint rounding_guard;\n"
    "float guarded(float x) { return uintBitsToFloat(floatBitsToUint(x) ^ rounding_guard); }\n";

std::string_view source_of(std::string_view path) {
    const auto& sources = shader_sources();
    const auto found = sources.find(path);
    if (found == sources.end()) throw Error(fmt::format("There is no shader '{}' in shaders/.", path));
    return found->second;
}

/// The meaning of `#include "technique"` in a part of a shader.
struct Scope {
    const ShaderVariant& variant;
    const std::string& technique;
    const std::string& constants;
};

// The path of an #include line. "technique" means that of the scope, or an empty path if it has none. All
// other names are relative to the folder of the including file, or to shaders/.
std::string included_path(std::string_view line, std::string_view includer, const Scope& scope) {
    const std::size_t open = line.find('"');
    const std::size_t close = line.rfind('"');
    const std::string name(line.substr(open + 1, close - open - 1));
    if (name == "technique") return scope.technique;
    const std::string beside = std::string(includer.substr(0, includer.rfind('/') + 1)) + name;
    return shader_sources().contains(beside) ? beside : name;
}

std::string defines_text(const std::map<std::string, std::string>& defines) {
    std::string text;
    for (const auto& [name, value] : defines) text += fmt::format("#define {} {}\n", name, value);
    return text;
}

void append_file(std::string& text, std::string_view path, const Scope& scope,
                 std::vector<std::string>& files);

// Appends the lines of a file up to its end, or to the end of the namespace.
void append_lines(std::string& text, std::istringstream& lines, int& at, std::string_view path,
                  std::size_t number, const Scope& scope, std::vector<std::string>& files) {
    for (std::string line; std::getline(lines, line); ++at) {
        if (line == "#endnamespace") return;
        if (line.starts_with("#include ")) {
            const std::string included = included_path(line, path, scope);
            if (!included.empty() && included == scope.technique) text += scope.constants;
            if (!included.empty()) append_file(text, included, scope, files);
            text += fmt::format("#line {} {}\n", at + 1, number);
        } else if (line.starts_with("#namespace ")) {
            const std::string name = line.substr(std::string_view("#namespace ").size());
            const auto found = scope.variant.namespaces.find(name);
            static const ShaderNamespace NOTHING;
            const ShaderNamespace& inner = found == scope.variant.namespaces.end() ? NOTHING : found->second;
            std::string block = defines_text(inner.defines);
            append_lines(block, lines, ++at, path, number, {scope.variant, inner.technique, inner.constants},
                         files);
            if (found != scope.variant.namespaces.end()) text += in_namespace(block, name);
            text += fmt::format("#line {} {}\n", at + 1, number);
        } else {
            text += line + "\n";
        }
    }
}

void append_file(std::string& text, std::string_view path, const Scope& scope,
                 std::vector<std::string>& files) {
    const std::size_t number = files.size();
    files.emplace_back(path);
    text += fmt::format("#line 1 {}\n", number);
    std::istringstream lines{std::string(source_of(path))};
    int at = 1;
    append_lines(text, lines, at, path, number, scope, files);
}

}  // namespace

ShaderText shader_text(std::string_view path, const ShaderVariant& variant, ShaderLanguage language) {
    const DialectRow& dialect = row_of(language.dialect);
    const bool guarded = language.rounding == Rounding::guarded;
    ShaderText result;
    std::string text = dialect.version;
    for (const auto& [define, extension] : EXTENSIONS)
        if (variant.defines.contains(define) && !path.ends_with(".vert"))
            text += fmt::format("#extension {} : require\n", extension);
    text += dialect.precisions + defines_text(dialect.words) + defines_text(variant.defines);
    if (guarded) text += GUARD;
    const Scope scope = {variant, variant.technique, variant.constants};
    append_file(text, "prelude.glsl", scope, result.files);
    append_file(text, path, scope, result.files);
    PortableShader portable = portable_shader(text, guarded);
    WrittenOut written = with_loops_written_out(portable.text);
    result.bindings = std::move(portable.bindings);
    result.loops_left = written.left;
    result.text = std::move(written.text);
    if (written.loops > 0) result.with_loops = std::move(portable.text);
    return result;
}

}  // namespace momentscope
