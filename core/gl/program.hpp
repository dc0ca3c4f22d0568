// program.hpp -- makes GL programs from the files of shaders/.
#pragma once
#include <compare>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/gl/handle.hpp"

namespace momentscope {

/// A technique in a namespace of its own: what `#include "technique"` means between `#namespace name` and
/// `#endnamespace`, and #defines that are only seen there.
struct ShaderNamespace {
    std::map<std::string, std::string> defines;
    std::string technique = {};
    std::string constants = {};
    friend auto operator<=>(const ShaderNamespace&, const ShaderNamespace&) = default;
};

/// A variant of a shader: #defines, and what `#include "technique"` means.
struct ShaderVariant {
    std::map<std::string, std::string> defines;
    std::string technique = {};                              // a path in shaders/, or empty
    std::string constants = {};                              // declarations before the technique
    std::map<std::string, ShaderNamespace> namespaces = {};  // by name; text in others is left out

    friend auto operator<=>(const ShaderVariant&, const ShaderVariant&) = default;
};

/// The whole text of a shader: version, defines, prelude, and the file with its #includes joined. #line
/// directives give each file its number in `files`. Throws Error for an unknown file.
std::string expand_shader(std::string_view path, const ShaderVariant& variant,
                          std::vector<std::string>* files = nullptr);

/// Compiles and links, with the loops of shaders written out (loop_writer.hpp). Throws Error with the first
/// line of the log of the driver. `notes` gets a sentence for each shader that keeps its loops, which says
/// why.
GlProgram link_program(std::string_view vertex, std::string_view fragment, const ShaderVariant& variant = {},
                       std::vector<std::string>* notes = nullptr);
GlProgram link_compute_program(std::string_view compute, const ShaderVariant& variant = {});

/// A cache of programs with few files and many variants. Each is linked at first use.
class ProgramCache {
public:
    GLuint get(const char* vertex, const char* fragment, const ShaderVariant& variant = {});

    /// Returns the notes since the last call, for a log.
    std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

private:
    std::map<std::tuple<std::string, std::string, ShaderVariant>, GlProgram> programs_;
    std::vector<std::string> notes_;
};

/// Everything is drawn with this program from now on; 0: with none.
void use_program(GLuint program);

/// Set a uniform of the program in use. location: as in the text of the shader.
void set_uniform(GLint location, int value);
void set_uniform(GLint location, glm::ivec2 value);

}  // namespace momentscope
