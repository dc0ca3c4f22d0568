// mesh_folder.hpp -- a temporary folder for the mesh files of a test, and checks of the visible surfaces.
#pragma once
#include "core/scene/mesh_file.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/error.hpp"
#include "tests/unit/expect_error.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace momentscope {

/// A folder for the files of each test, which is removed with the test.
class MeshFolder : public testing::Test {
protected:
    MeshFolder()
        : folder_(std::filesystem::temp_directory_path() /
                  ("momentscope_mesh_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~MeshFolder() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    std::filesystem::path write(const std::string& name, const std::string& content) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }

    /// Expects the file to be refused with one plain sentence that names it and contains `part`.
    static void expect_refused(const std::filesystem::path& path, const std::string& part) {
        try {
            read_mesh_file(path);
            ADD_FAILURE() << path << " was read";
        } catch (const Error& error) {
            const std::string sentence = error.what();
            expect_one_sentence(sentence);
            EXPECT_TRUE(sentence.starts_with("The mesh file '" + path.string() + "' ")) << sentence;
            EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
        }
    }

    /// Expects the file to be read with one warning, a sentence that names it and contains `part`.
    static void expect_warning(const std::filesystem::path& path, const std::string& part) {
        const std::vector<std::string> warnings = read_mesh_file(path).warnings;
        ASSERT_EQ(warnings.size(), 1u) << path << testing::PrintToString(warnings);
        expect_one_sentence(warnings[0]);
        EXPECT_NE(warnings[0].find(path.string()), std::string::npos) << warnings[0];
        EXPECT_NE(warnings[0].find(part), std::string::npos) << warnings[0];
    }

    /// Expects that the middle pixel of a picture of 160 x 90 shows the mesh at these depths, without a
    /// warning.
    static void expect_depths(const std::filesystem::path& path, const std::vector<double>& depths,
                              bool with_warning = false) {
        const Scene scene = load_scene(path.string(), 0.4f);
        EXPECT_EQ(!scene.warnings.empty(), with_warning) << testing::PrintToString(scene.warnings);
        const std::vector<double> seen = depths_of(scene);
        ASSERT_EQ(seen.size(), depths.size()) << path << testing::PrintToString(seen);
        for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_NEAR(seen[i], depths[i], 1e-4) << path;
    }

    /// The view depths at which the ray through the middle of pixel (80, 45) of 160 x 90 meets the triangles.
    static std::vector<double> depths_of(const Scene& scene) {
        const Camera& camera = scene.camera;
        const double azimuth = camera.azimuth, elevation = camera.elevation;
        const glm::dvec3 back(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                              std::cos(azimuth) * std::cos(elevation));
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
        const double half = std::tan(0.5 * static_cast<double>(camera.field_of_view));
        const glm::dvec3 ray = -back + half / 90.0 * (right - glm::cross(back, right));  // half a pixel off
        const glm::dvec3 eye = static_cast<double>(camera.distance) * back;
        const Mesh& mesh = scene.meshes.front();
        std::vector<double> depths;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const auto corner = [&](std::size_t i) {
                return glm::dvec3(mesh.positions[mesh.indices[t + i]]);
            };
            // eye + depth * ray = a + u (b - a) + v (c - a)
            const glm::dvec3 a = corner(0);
            const glm::dmat3 sides(-ray, corner(1) - a, corner(2) - a);
            if (glm::determinant(sides) == 0.0) continue;
            const glm::dvec3 solution = glm::inverse(sides) * (eye - a);
            if (solution.y >= 0.0 && solution.z >= 0.0 && solution.y + solution.z <= 1.0)
                depths.push_back(solution.x);
        }
        std::ranges::sort(depths);
        return depths;
    }

    std::filesystem::path folder_;
};

}  // namespace momentscope
