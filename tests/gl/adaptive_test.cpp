// adaptive_test.cpp -- fragments that choose their own number of moments: their result lies between those of
// the fixed numbers, close to the greater number, and is steady while the camera moves.
#include <fmt/format.h>

#include <cmath>

#include "core/chart/camera_path.hpp"
#include "core/compare/difference.hpp"
#include "core/scene/scenes.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

class AdaptiveTest : public GlTest<testing::Test> {
protected:
    static constexpr glm::ivec2 SIZE{160, 90};

    void SetUp() override {
        GlTest::SetUp();
        renderer_.emplace(shared_programs());
    }

    Image picture(const Camera& camera, const char* technique, std::optional<float> tolerance = {}) {
        ParameterValues values;
        if (tolerance) values.set(ParameterId::tolerance, tolerance);
        // The technique with the same moments gets the same bias.
        if (std::string_view(technique).starts_with("cheb"))
            values.set(ParameterId::alpha, require_technique("adaptive").moments().recommended_bias);
        renderer_->render({camera, SIZE, &require_technique(technique), values});
        return renderer_->read_picture();
    }

    std::vector<Image> pictures_along(const std::vector<Camera>& path, const char* technique) {
        std::vector<Image> pictures;
        for (const Camera& camera : path) pictures.push_back(picture(camera, technique));
        return pictures;
    }

    /// The largest change of a pixel's error between successive frames, as a root mean square over all
    /// pixels.
    static double largest_jump(const std::vector<Image>& truths, const std::vector<Image>& pictures) {
        std::vector<float> before;
        double most = 0;
        for (std::size_t frame = 0; frame < truths.size(); ++frame) {
            const std::vector<float> error = difference_map(truths[frame], pictures[frame], Metric::rmse);
            double squares = 0;
            for (std::size_t i = 0; i < before.size(); ++i)
                squares += std::pow(static_cast<double>(error[i]) - static_cast<double>(before[i]), 2);
            if (!before.empty())
                most = std::max(most, std::sqrt(squares / static_cast<double>(error.size())));
            before = error;
        }
        return most;
    }

    std::optional<Renderer> renderer_;  // declared after the context that it needs
};

TEST_F(AdaptiveTest, IsFourMomentsAtOneEndAndEightAtTheOther) {
    for (const char* id : {"teapots", "spheres"}) {
        const Scene scene = load_scene(id, 0.4f);
        renderer_->set_scene(scene);
        const Image of_4 = picture(scene.camera, "cheb4-32"), of_8 = picture(scene.camera, "cheb8-32");
        const double apart = mean_difference(of_4, of_8, Metric::rmse);
        // Weighted colours are rounded to half floats.
        EXPECT_LE(mean_difference(of_4, picture(scene.camera, "adaptive", 1.0f), Metric::rmse), 0.02 * apart)
            << id;
        EXPECT_LE(mean_difference(of_8, picture(scene.camera, "adaptive", 1e-4f), Metric::rmse), 0.02 * apart)
            << id;
        EXPECT_GT(apart, 1e-3) << id;
    }
}

TEST_F(AdaptiveTest, DrawsNearlyWhatEightMomentsDo) {
    for (const char* id : {"teapots", "ship", "spheres", "foliage"}) {
        const Scene scene = load_scene(id, 0.4f);
        renderer_->set_scene(scene);
        const Image truth = picture(scene.camera, "sorted");
        const double of_8 = mean_difference(truth, picture(scene.camera, "cheb8-32"), Metric::rmse);
        EXPECT_LE(mean_difference(truth, picture(scene.camera, "adaptive"), Metric::rmse), 1.05 * of_8) << id;
    }
}

// Nothing pops. Compared with eight moments with the same bias, the choice increases the change of the error
// between frames by at most a quarter; compared with power moments with their bias, by at most half.
TEST_F(AdaptiveTest, IsAsSteadyAsAFixedNumberOfMoments) {
    for (const char* id : {"teapots", "spheres", "ship"}) {
        const Scene scene = load_scene(id, 0.4f);
        renderer_->set_scene(scene);
        const std::vector<Camera> path = camera_path(scene.camera);
        const std::vector<Image> truths = pictures_along(path, "sorted");
        const auto jump = [&](const char* technique) {
            return largest_jump(truths, pictures_along(path, technique));
        };
        const double power = jump("power8-32"), chebyshev = jump("cheb8-32"), adaptive = jump("adaptive");
        fmt::print(
            "{}: largest change of error from frame to frame: power8-32 {:.2e}, cheb8-32 {:.2e}, adaptive {:.2e}\n",
            id, power, chebyshev, adaptive);
        EXPECT_LE(adaptive, 1.25 * chebyshev) << id;
        EXPECT_LE(adaptive, 1.5 * power) << id;
    }
}

}  // namespace
}  // namespace momentscope::test
