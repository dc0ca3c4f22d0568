// dialect.hpp -- the languages that shaders are written in. All are made from the same files.
#pragma once
#include <map>
#include <span>
#include <string>

namespace momentscope {

/// A language: GLSL 4.50, GLSL 4.10 (macOS), GLSL 3.30, or the ESSL 3.00 of OpenGL ES 3.0 and WebGL 2.
enum class Dialect { glsl_450, glsl_410, glsl_330, essl_300 };

/// How the driver is kept from re-associating what is declared PRECISE: by the word `precise`; not at all,
/// because it does not re-associate; by hiding each such value behind an operation whose result the driver
/// cannot foresee; or not at all, although it re-associates.
enum class Rounding { precise, unguarded, guarded, lost };

/// What a shader begins with, and what the words of its files mean.
struct DialectRow {
    const char* key;         // of file names and tables
    const char* name;        // for people
    std::string version;     // the first line
    std::string precisions;  // that have no default
    std::map<std::string, std::string> words;
    Dialect dialect;
    bool has_precise;
    bool has_storage;  // images and buffers that shaders may write
};

std::span<const DialectRow> dialects();
const DialectRow& row_of(Dialect dialect);

/// A dialect, and how it keeps the order of operations.
struct ShaderLanguage {
    Dialect dialect = Dialect::glsl_450;
    Rounding rounding = Rounding::precise;
};

/// The language of a dialect, with `precise` where it has the word.
ShaderLanguage language_of(Dialect dialect);

}  // namespace momentscope
