// family.hpp -- kinds of techniques, as a chart colours them.
#pragma once
#include <glm/glm.hpp>
#include <span>

#include "core/chart/drawing.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// One row. Colours are Okabe and Ito's, darker where they would be pale on white; shapes tell families apart
/// without them.
struct Family {
    const char* name;
    glm::vec3 color;
    MarkShape shape;
    bool (*holds)(const Technique&);
};

/// In the order of a legend. The last one holds every technique.
std::span<const Family> families();

/// The first family that holds the technique.
const Family& family_of(const Technique& technique);

}  // namespace momentscope
