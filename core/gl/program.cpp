#include "core/gl/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <span>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr std::size_t MAX_WRITTEN_OUT = 1 << 20;  // bytes of a shader

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
GlShader compile(GLenum kind, std::string_view path, const ShaderText& text,
                 std::vector<std::string>& notes) {
    GlShader shader(glCreateShader(kind));
    const bool fits = text.text.size() <= MAX_WRITTEN_OUT;
    if (fits && compiles(shader, text.text)) return shader;
    if (!text.with_loops.empty()) {
        notes.push_back(
            fmt::format("{} keeps its loops: {}", path,
                        fits ? "this GL does not compile it with loops written out"
                             : fmt::format("written out it would have {} bytes", text.text.size())));
        if (compiles(shader, text.with_loops)) return shader;
    }
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    std::string numbered;
    for (std::size_t i = 0; i < text.files.size(); ++i) numbered += fmt::format(" {} = {}", i, text.files[i]);
    throw Error(fmt::format("This GL does not compile {}: {} (files:{})", path, log.substr(0, log.find('\n')),
                            numbered));
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

// Each sampler of an array reads the unit after that of the one before it.
void set_bindings(GLuint program, const ShaderBindings& bindings) {
    use_program(program);
    for (const auto& [name, number] : bindings) {
        const GLuint block = glGetUniformBlockIndex(program, name.c_str());
        if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, static_cast<GLuint>(number));
        const GLint first = glGetUniformLocation(program, name.c_str());
        if (first >= 0) glUniform1i(first, number);
        for (int i = 1; first >= 0; ++i) {
            const GLint location = glGetUniformLocation(program, fmt::format("{}[{}]", name, i).c_str());
            if (location < 0) break;
            glUniform1i(location, number + i);
        }
    }
    use_program(0);
}

struct Stage {
    GLenum kind;
    std::string_view path;
};

GlProgram link_stages(std::initializer_list<Stage> stages, const ShaderVariant& variant,
                      ShaderLanguage language, std::vector<std::string>* notes) {
    std::vector<std::string> said;
    std::vector<GlShader> shaders;
    ShaderBindings bindings;
    for (const Stage& stage : stages) {
        const ShaderText text = shader_text(stage.path, variant, language);
        shaders.push_back(compile(stage.kind, stage.path, text, said));
        bindings.insert(text.bindings.begin(), text.bindings.end());
    }
    if (notes != nullptr) std::ranges::move(said, std::back_inserter(*notes));
    GlProgram program = link(shaders, std::prev(stages.end())->path);
    set_bindings(program, bindings);
    return program;
}

}  // namespace

GlProgram link_program(std::string_view vertex, std::string_view fragment, const ShaderVariant& variant,
                       ShaderLanguage language, std::vector<std::string>* notes) {
    return link_stages({{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}, variant, language,
                       notes);
}

GlProgram link_compute_program(std::string_view path, const ShaderVariant& variant) {
    return link_stages({{GL_COMPUTE_SHADER, path}}, variant, {}, nullptr);
}

GLuint ProgramCache::get(const char* vertex, const char* fragment, const ShaderVariant& variant) {
    const auto key = std::tuple(std::string(vertex), std::string(fragment), variant);
    auto found = programs_.find(key);
    if (found == programs_.end())
        found = programs_.emplace(key, link_program(vertex, fragment, variant, gl_.language, &notes_)).first;
    return found->second;
}

void use_program(GLuint program) {
    glUseProgram(program);
}

void set_uniform(GLuint program, const char* name, int value) {
    glUniform1i(glGetUniformLocation(program, name), value);
}

void set_uniform(GLuint program, const char* name, glm::ivec2 value) {
    glUniform2i(glGetUniformLocation(program, name), value.x, value.y);
}

}  // namespace momentscope
