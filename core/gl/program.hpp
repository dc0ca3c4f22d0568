// program.hpp -- makes GL programs from the files of shaders/.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/gl/capabilities.hpp"
#include "core/gl/handle.hpp"
#include "core/gl/shader_text.hpp"

namespace momentscope {

/// Compiles and links, with the loops of shaders written out (loop_writer.hpp). Throws Error with the first
/// line of the log of the driver. `notes` gets a sentence for each shader that keeps its loops, which says
/// why.
GlProgram link_program(std::string_view vertex, std::string_view fragment, const ShaderVariant& variant,
                       ShaderLanguage language = {}, std::vector<std::string>* notes = nullptr);
GlProgram link_compute_program(std::string_view compute, const ShaderVariant& variant = {});

/// A cache of programs with few files and many variants, for one GL. Each is linked at first use.
class ProgramCache {
public:
    /// gl: what the current context is capable of, or less, to see what is then missing.
    explicit ProgramCache(const Capabilities& gl = capabilities()) : gl_(gl) {}

    const Capabilities& gl() const { return gl_; }

    /// Throws Error if the driver does not compile it.
    GLuint get(const char* vertex, const char* fragment, const ShaderVariant& variant = {});

    /// Returns the notes since the last call, for a log.
    std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

private:
    Capabilities gl_;
    std::map<std::tuple<std::string, std::string, ShaderVariant>, GlProgram> programs_;
    std::vector<std::string> notes_;
};

/// Everything is drawn with this program from now on; 0: with none.
void use_program(GLuint program);

/// Set a uniform of the program in use, by its name in the shader.
void set_uniform(GLuint program, const char* name, int value);
void set_uniform(GLuint program, const char* name, glm::ivec2 value);

}  // namespace momentscope
