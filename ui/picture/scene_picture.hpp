// scene_picture.hpp -- what stands in the picture's place: the picture, a draft, the reference or a map, with
// what is drawn over it.
#pragma once
#include <optional>
#include <string>

#include "core/render/failure_marks.hpp"
#include "ui/picture/lens_content.hpp"
#include "ui/picture/scene_comparison.hpp"

namespace momentscope::ui {

/// Textures are GL names of the picture's size.
struct ScenePicture {
    unsigned texture = 0;
    unsigned overlay = 0;               // the failures, or 0
    unsigned beside = 0;                // the reference on its side of a wipe, or 0
    std::optional<ColorLegend> legend;  // legend of the false colours that replace the picture
    std::optional<FailureCounts> failures;
    std::string title;  // text in the corner, such as "reference: ..."; may be empty
    Lens lens;
    Camera scene_camera;  // the scene's own
};

/// Updates everything that is stale after a change of the full picture. Throws Error if the GL fails.
void update_scene_picture(ScenePicture& picture, const Update& update, const PictureChange& change,
                          Renderer& renderer, const PictureComparison& comparison, glm::ivec2 picked);

/// Shows a draft.
void show_draft(ScenePicture& picture, const DraftPicture& draft);

}  // namespace momentscope::ui
