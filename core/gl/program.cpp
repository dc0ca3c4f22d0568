#include "core/gl/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "core/gl/loop_writer.hpp"
#include "core/gl/shader_namespace.hpp"
#include "core/gl/shader_sources.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr std::size_t MAX_WRITTEN_OUT = 1 << 20;  // bytes of a shader

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

bool compiles(const GlShader& shader, const std::string& text) {
    const char* begin = text.c_str();
    glShaderSource(shader, 1, &begin, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    return compiled != 0;
}

// Compiles a shader with its loops written out. If the text is too large or the driver does not compile it,
// loops are kept and a note says so.
GlShader compile(GLenum kind, std::string_view path, const ShaderVariant& variant,
                 std::vector<std::string>& notes) {
    std::vector<std::string> files;
    const std::string text = expand_shader(path, variant, &files);
    GlShader shader(glCreateShader(kind));
    const WrittenOut written = with_loops_written_out(text);
    const bool fits = written.text.size() <= MAX_WRITTEN_OUT;
    if (fits && compiles(shader, written.text)) return shader;
    if (written.loops > 0)
        notes.push_back(
            fmt::format("{} keeps its loops: {}", path,
                        fits ? "this GL does not compile it with loops written out"
                             : fmt::format("written out it would have {} bytes", written.text.size())));
    if (!compiles(shader, text)) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        std::string numbered;
        for (std::size_t i = 0; i < files.size(); ++i) numbered += fmt::format(" {} = {}", i, files[i]);
        throw Error(fmt::format("This GL does not compile {}: {} (files:{})", path,
                                log.substr(0, log.find('\n')), numbered));
    }
    return shader;
}

GlProgram link(std::span<const GlShader> shaders, std::string_view name) {
    GlProgram program(glCreateProgram());
    for (const GlShader& shader : shaders) glAttachShader(program, shader);
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        std::string log(4096, '\0');
        glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw Error(fmt::format("This GL does not link {}: {}", name, log.substr(0, log.find('\n'))));
    }
    return program;
}

}  // namespace

std::string expand_shader(std::string_view path, const ShaderVariant& variant,
                          std::vector<std::string>* files) {
    std::vector<std::string> numbered;
    std::string text = "#version 450 core\n" + defines_text(variant.defines);
    const Scope scope = {variant, variant.technique, variant.constants};
    append_file(text, "prelude.glsl", scope, numbered);
    append_file(text, path, scope, numbered);
    if (files != nullptr) *files = numbered;
    return text;
}

GlProgram link_program(std::string_view vertex, std::string_view fragment, const ShaderVariant& variant,
                       std::vector<std::string>* notes) {
    std::vector<std::string> said;
    std::vector<GlShader> shaders;
    shaders.push_back(compile(GL_VERTEX_SHADER, vertex, variant, said));
    shaders.push_back(compile(GL_FRAGMENT_SHADER, fragment, variant, said));
    if (notes != nullptr) std::ranges::move(said, std::back_inserter(*notes));
    return link(shaders, fragment);
}

GlProgram link_compute_program(std::string_view path, const ShaderVariant& variant) {
    std::vector<std::string> notes;
    std::vector<GlShader> shaders;
    shaders.push_back(compile(GL_COMPUTE_SHADER, path, variant, notes));
    return link(shaders, path);
}

GLuint ProgramCache::get(const char* vertex, const char* fragment, const ShaderVariant& variant) {
    const auto key = std::tuple(std::string(vertex), std::string(fragment), variant);
    auto found = programs_.find(key);
    if (found == programs_.end())
        found = programs_.emplace(key, link_program(vertex, fragment, variant, &notes_)).first;
    return found->second;
}

void use_program(GLuint program) {
    glUseProgram(program);
}

void set_uniform(GLint location, int value) {
    glUniform1i(location, value);
}

void set_uniform(GLint location, glm::ivec2 value) {
    glUniform2i(location, value.x, value.y);
}

}  // namespace momentscope
