// gl_fixture.hpp -- one headless context for all tests of a program.
#pragma once
#include <gtest/gtest.h>

#include "app/gl_context.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/camera.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/error.hpp"

namespace momentscope::test {

inline GlContext& shared_context() {
    static const std::unique_ptr<GlContext> context = make_headless_context({64, 64});
    return *context;
}

/// The programs of all renderers in this context. Linking them takes longer than drawing the pictures of most
/// tests.
inline const std::shared_ptr<ProgramCache>& shared_programs() {
    shared_context();  // must outlive the programs
    static const auto programs = std::make_shared<ProgramCache>();
    return programs;
}

/// The GL of this machine without what `change` takes from it.
template <typename Change>
std::shared_ptr<ProgramCache> lesser(const Change& change) {
    Capabilities gl = shared_programs()->gl();
    change(gl);
    return std::make_shared<ProgramCache>(gl);
}

inline std::shared_ptr<ProgramCache> without_storage() {
    return lesser([](Capabilities& gl) { gl.storage = false; });
}

/// A fixture whose tests may call GL.
template <typename Base = testing::Test>
class GlTest : public Base {
protected:
    void SetUp() override { shared_context(); }
    void TearDown() override { EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)); }
};

inline View view_of(const Scene& scene, const char* technique, glm::ivec2 size) {
    return {scene.camera, size, &require_technique(technique), {}};
}

}  // namespace momentscope::test
