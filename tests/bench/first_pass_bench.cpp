// first_pass_bench.cpp -- compares the milliseconds of the first pass with plain additive blending of the
// same bytes, in interleaved rounds of one run, on teapots and ship.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string_view>
#include <vector>

#include "app/gl_context.hpp"
#include "core/gl/query.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/scenes.hpp"
#include "tests/bench/bench.hpp"

namespace momentscope {
namespace {

/// The pass without its mathematics. The Frame block is the one that the renderer bound last.
class BlendOnly {
public:
    BlendOnly(const Scene& scene, int floats) : scene_(scene), count_(floats > 4 ? 3 : 2) {
        textures_.push_back(make_texture(GL_R32F, BENCH_SIZE));
        textures_.push_back(make_texture(GL_RGBA32F, BENCH_SIZE));
        if (floats > 4) textures_.push_back(make_texture(floats > 6 ? GL_RGBA32F : GL_RG32F, BENCH_SIZE));
        std::vector<GLuint> colors;
        for (const GlTexture& texture : textures_) colors.push_back(texture);
        depth_ = make_texture(GL_DEPTH_COMPONENT32F, BENCH_SIZE);
        target_ = make_framebuffer(colors, depth_);
        opaque_color_ = make_texture(GL_RGBA16F, BENCH_SIZE);
        opaque_target_ = make_framebuffer({opaque_color_}, depth_);
    }

    void draw_opaque() {
        clear_depth(opaque_target_, 1);
        set_draw_state({.depth = DepthTest::nearer});
        bind_framebuffer(opaque_target_);
        set_viewport(BENCH_SIZE);
        use_program(programs_.get("passes/scene.vert", "passes/opaque.frag"));
        scene_.draw(Surfaces::opaque);
    }

    double milliseconds() {
        set_viewport(BENCH_SIZE);
        finish_gl();
        const auto begin = std::chrono::steady_clock::now();
        clear_colors(target_, count_);
        ShaderVariant variant;
        if (!scene_.has_alpha_maps()) variant.defines["NO_ALPHA_MAPS"] = "1";
        use_program(programs_.get("passes/scene.vert", "tests/blend_only.frag", variant));
        draw_transparent(scene_, target_, {.blending = Blending::add});
        finish_gl();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    }

private:
    SceneBuffers scene_;
    int count_;
    ProgramCache programs_;
    std::vector<GlTexture> textures_;
    GlTexture depth_, opaque_color_;
    GlFramebuffer target_, opaque_target_;
};

struct Times {
    double blending, moments;
};

Times median_times(const Scene& scene, const Technique& technique, int rounds) {
    Renderer renderer;
    renderer.set_scene(scene);
    renderer.render({scene.camera, BENCH_SIZE, &technique, {}});
    BlendOnly plain(scene, technique.moment_kernel().moment_floats);
    plain.draw_opaque();
    std::vector<double> moments, blending;
    for (int round = 0; round <= rounds; ++round) {
        renderer.redraw();
        const double blended = plain.milliseconds();
        if (round == 0) continue;  // this round links programs
        moments.push_back(renderer.pass_times().moments);
        blending.push_back(blended);
    }
    return {median(blending), median(moments)};
}

void run(int rounds, std::string_view only) {
    const auto context = make_headless_context({16, 16});
    fmt::print("{}\nms at {}x{}\n{:<10}{:<12}{:>12}{:>12}{:>8}\n",
               reinterpret_cast<const char*>(glGetString(GL_RENDERER)), BENCH_SIZE.x, BENCH_SIZE.y, "scene",
               "technique", "blending", "first pass", "ratio");
    for (const char* id : {"teapots", "ship"}) {
        const Scene scene = load_scene(id, BENCH_OPACITY);
        median_times(scene, require_technique("cheb4-32"), 1);  // the first measurement takes twice as long
        for (const Technique* technique : moment_based_techniques()) {
            if (technique->moment_kernel().bits != 32) continue;
            if (!is_wanted(only, technique->id)) continue;
            const Times times = median_times(scene, *technique, rounds);
            fmt::print("{:<10}{:<12}{:>12.1f}{:>12.1f}{:>8.2f}\n", id, technique->id, times.blending,
                       times.moments, times.moments / times.blending);
        }
    }
}

}  // namespace
}  // namespace momentscope

int main(int argc, char** argv) {
    return momentscope::bench_main(argc, argv, "first_pass_bench", 9, momentscope::run);
}
