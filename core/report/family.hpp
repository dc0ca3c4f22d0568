// family.hpp -- families of techniques, each with a colour and a shape in charts.
#pragma once
#include <glm/glm.hpp>
#include <span>

#include "core/report/drawing.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// One family. Colours are those of Okabe and Ito, darkened if they would be too pale on white. Shapes
/// differ, too, so families can be told apart without colours.
struct Family {
    const char* name;
    glm::vec3 color;
    MarkShape shape;
    bool (*holds)(const Technique&);
};

/// All families, in the order of a legend. The last one holds every technique.
std::span<const Family> families();

/// The first family that holds the technique.
const Family& family_of(const Technique& technique);

}  // namespace momentscope
