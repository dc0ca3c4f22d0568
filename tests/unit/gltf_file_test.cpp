// gltf_file_test.cpp -- glTF files: placement of meshes, required features, and the files that belong to
// them.
#include "core/scene/gltf_file.hpp"
#include "tests/unit/mesh_folder.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

using namespace momentscope;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The bytes of three panes of 2 by 1.6 at z = -1, 0 and 1, with each coordinate passed through `change`, and
/// (0, 0, 5) for each corner.
template <class Change>
std::string panes_bytes(const Change& change) {
    std::string bytes;
    const auto add = [&](auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    for (const std::uint16_t index : std::array<std::uint16_t, 6>{0, 1, 2, 0, 2, 3}) add(index);
    for (const float z : {-1.0f, 0.0f, 1.0f})
        for (const glm::vec3 p : {glm::vec3(-1, -0.8f, z), {1, -0.8f, z}, {1, 0.8f, z}, {-1, 0.8f, z}})
            for (const float coordinate : {p.x, p.y, p.z}) add(static_cast<float>(change(coordinate)));
    for (int corner = 0; corner < 4; ++corner)
        for (const float change_of_shape : {0.0f, 0.0f, 5.0f}) add(change_of_shape);
    return bytes;
}

std::string panes_bytes() {
    return panes_bytes([](float x) { return x; });
}

/// Three nodes with one pane each; accessor 4 holds (0, 0, 5).
json panes_json(const std::string& uri) {
    json file = {
        {"asset", {{"version", "2.0"}}},
        {"scene", 0},
        {"scenes", {{{"nodes", {0, 1, 2}}}}},
        {"buffers", {{{"byteLength", 204}, {"uri", uri}}}},
        {"bufferViews", {{{"buffer", 0}, {"byteLength", 12}}}},
        {"accessors", {{{"bufferView", 0}, {"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}}}}};
    for (int i = 1; i <= 4; ++i) {
        file["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 48 * i - 36}, {"byteLength", 48}});
        file["accessors"].push_back(
            {{"bufferView", i}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
    }
    for (int i = 0; i < 3; ++i) {
        file["nodes"].push_back({{"mesh", i}});
        file["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", i + 1}}}, {"indices", 0}}}}});
    }
    return file;
}

const std::vector<double> THREE_DEPTHS = {1.9635, 2.6967, 3.4299};

class GltfMesh : public MeshFolder {
protected:
    GltfMesh() { write("panes.bin", panes_bytes()); }

    fs::path write_json(const json& file, const std::string& name = "panes.gltf") const {
        return write(name, file.dump());
    }
    fs::path write_with_uri(const std::string& uri, const std::string& name = "panes.gltf") const {
        return write_json(panes_json(uri), name);
    }
    fs::path write_binary(json file) const {
        file["buffers"][0].erase("uri");
        std::string text = file.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const auto word = [](std::size_t value) {
            const auto number = static_cast<std::uint32_t>(value);
            return std::string(reinterpret_cast<const char*>(&number), 4);
        };
        const std::string bytes = panes_bytes();
        return write("panes.glb", "glTF" + word(2) + word(28 + text.size() + bytes.size()) +
                                      word(text.size()) + "JSON" + text + word(bytes.size()) +
                                      std::string("BIN\0", 4) + bytes);
    }
};

TEST_F(GltfMesh, IsReadAsTextAndBinaryFromFilesAndUris) {
    expect_depths(write_with_uri("panes.bin"), THREE_DEPTHS);
    expect_depths(write_binary(panes_json("")), THREE_DEPTHS);
    expect_depths(write_with_uri("panes.bin", "no-such-ending"), THREE_DEPTHS);
    expect_depths(write("mark.gltf", "\xef\xbb\xbf" + panes_json("panes.bin").dump()), THREE_DEPTHS);
    std::string wide = "\xff\xfe";
    for (const char c : panes_json("panes.bin").dump()) wide += {c, '\0'};
    expect_depths(write("wide.gltf", wide), THREE_DEPTHS);
    // A buffer that begins like UTF-16 text is still binary.
    write("mark.bin", "\xff\xfe" + panes_bytes());
    json file = panes_json("mark.bin");
    file["buffers"][0]["byteLength"] = 206;
    for (json& view : file["bufferViews"]) view["byteOffset"] = view.value("byteOffset", 0) + 2;
    expect_depths(write_json(file), THREE_DEPTHS);
}

TEST_F(GltfMesh, UrisArePercentEncoded) {
    write("\u00fcn\u00efcode \u2764.bin", panes_bytes());
    write("100%25 of it.bin", panes_bytes());
    write("100% of it.bin", "other");
    write("sub folder/x.bin", panes_bytes());
    expect_depths(write_with_uri("%C3%BCn%C3%AFcode%20%E2%9D%A4.bin"), THREE_DEPTHS);
    expect_depths(write_with_uri("%c3%bcn\u00efcode \u2764.bin"), THREE_DEPTHS);
    expect_depths(write_with_uri("100%2525%20of it.bin"), THREE_DEPTHS);
    expect_depths(write_with_uri("./sub%20folder/../sub folder/x.bin"), THREE_DEPTHS);
    expect_depths(write_with_uri("file://" + (folder_ / "panes.bin").string()), THREE_DEPTHS);
}

TEST_F(GltfMesh, OpensNothingOutsideItsFolder) {
    const std::string outside = (folder_ / "panes.bin").string();
    fs::create_directories(folder_ / "in");
    fs::create_symlink(outside, folder_ / "in/link.bin");
    fs::create_directory_symlink(folder_, folder_ / "in/up");
    for (const std::string& uri :
         {std::string("../panes.bin"), std::string("%2e%2e%2fpanes.bin"), std::string("%2E./panes.bin"),
          std::string("x/../../panes.bin"), outside, "file://" + outside, "file://localhost" + outside,
          std::string("link.bin"), std::string("up/panes.bin"), std::string("../in/../panes.bin")})
        expect_refused(write_with_uri(uri, "in/panes.gltf"), "'" + uri + "', which lies outside its folder");
    for (const char* uri : {"none.bin", "../none.bin", "http://localhost/panes.bin", "/dev/zero", "."})
        expect_error([&] { read_mesh_file(write_with_uri(uri, "in/panes.gltf")); }, uri);
}

TEST_F(GltfMesh, RefusesExtensionsThatItNeedsByName) {
    for (const char* name : {"KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression",
                             "EXT_meshopt_compression", "KHR_node_visibility", "XYZ_unknown"}) {
        json file = panes_json("panes.bin");
        file["extensionsUsed"] = file["extensionsRequired"] = {name};
        expect_refused(write_json(file), name);
        expect_refused(write_binary(file), name);
        file.erase("extensionsRequired");
        expect_warning(write_json(file), name);
    }
    json file = panes_json("panes.bin");
    file["extensionsRequired"] = {"XYZ_b", "KHR_materials_unlit", "XYZ_a"};
    expect_refused(write_json(file), "needs the glTF extensions XYZ_a, XYZ_b, which are not read");
    file["extensionsUsed"] =
        file["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform", "KHR_technique_webgl"};
    expect_depths(write_json(file), THREE_DEPTHS);
    file = panes_json("panes.bin");
    file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 4;  // unlisted
    expect_warning(write_json(file), "EXT_mesh_gpu_instancing");
}

TEST_F(GltfMesh, RefusesWhatIsNoJson) {
    expect_refused(write("nan.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"a\": NaN}"),
                   "not valid JSON at byte");
    expect_refused(write("far.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"a\": 1e999}"),
                   "a value that JSON cannot represent");
}

TEST_F(GltfMesh, RefusesNestingWithoutFollowingIt) {
    std::string extras;
    for (int i = 0; i < 200'000; ++i) extras += "{\"a\":";
    expect_refused(write("deep.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"x\": " + extras + "1" +
                                          std::string(200'001, '}')),
                   "nested too deeply");
}

TEST_F(GltfMesh, RefusesAShapeLargerThanNumbers) {
    json file = panes_json("panes.bin");
    for (const int node : {0, 1}) {
        const double end = node == 0 ? 1.5e308 : -1.5e308;
        file["nodes"][node]["translation"] = {end, end, 0.0};
    }
    expect_refused(write_json(file), "is larger than any number can be");
}

TEST_F(GltfMesh, RefusesPositionsThatAreNoFloats) {
    json file = panes_json("panes.bin");
    file["accessors"][2]["componentType"] = 5122;
    expect_refused(write_json(file), "KHR_mesh_quantization");
    file = panes_json("panes.bin");
    file["accessors"][2].erase("bufferView");
    expect_refused(write_json(file), "compressed");
}

TEST_F(GltfMesh, NodesAreInDouble) {
    const json far = {448261.35, 4.2, 5411932.68};
    json file = panes_json("panes.bin");
    for (json& node : file["nodes"]) node["translation"] = far;
    expect_depths(write_json(file), THREE_DEPTHS);
    // The same placement by a parent and a grandparent, with a scale, and a rotation that is undone.
    file = panes_json("panes.bin");
    file["nodes"].push_back({{"children", {0, 1, 2}}, {"translation", far}, {"rotation", {0, 1, 0, 0}}});
    file["nodes"].push_back({{"children", {3}}, {"scale", {1e-3, 1e-3, 1e-3}}, {"rotation", {0, -1, 0, 0}}});
    file["scenes"][0]["nodes"] = {4};
    expect_depths(write_json(file), THREE_DEPTHS);
    // Panes that are far apart only by their nodes, with a matrix and with a translation.
    file = panes_json("panes.bin");
    for (json& node : file["nodes"]) node["mesh"] = 1;
    file["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 448261.35, 0, 5411931.68, 1};
    file["nodes"][1]["translation"] = {448261.35, 0, 5411932.68};
    file["nodes"][2]["translation"] = {448261.35, 0, 5411933.68};
    expect_depths(write_json(file), THREE_DEPTHS);
}

TEST_F(GltfMesh, NodesOfNoScaleLeaveTheOthers) {
    json file = panes_json("panes.bin");
    file["nodes"].push_back({{"mesh", 0}, {"scale", {0, 0, 0}}});
    file["nodes"].push_back({{"mesh", 0}, {"scale", {0, 0, 1}}});
    file["scenes"][0]["nodes"] = {0, 3, 1, 4, 2};
    expect_depths(write_json(file), THREE_DEPTHS);
    for (json& node : file["nodes"]) node["scale"] = {0, 0, 0};
    expect_refused(write_json(file), "in one point");
    for (json& node : file["nodes"]) node["scale"] = {1e300, 1e300, 1e-300};
    EXPECT_NO_THROW(read_mesh_file(write_json(file)));
    file["nodes"][0]["translation"] = {1e308, 0, 0};
    file["nodes"].push_back({{"children", {0}}, {"scale", {10, 1, 1}}});
    file["scenes"][0]["nodes"] = {5, 1, 2};
    expect_refused(write_json(file), "infinite or NaN");
}

TEST_F(GltfMesh, DefaultWeightsOfMorphTargetsAreApplied) {
    const std::vector<double> morphed = {1.9635, 2.3301, 3.4299};  // the middle pane is moved by 0.1 * 5
    json file = panes_json("panes.bin");
    file["meshes"][1]["primitives"][0]["targets"] = {{{"POSITION", 4}}};
    expect_depths(write_json(file), THREE_DEPTHS);
    file["meshes"][1]["weights"] = {0.1};
    expect_depths(write_json(file), morphed);
    expect_depths(write_binary(file), morphed);
    file["nodes"][1]["weights"] = {0.0};  // as many as the node needs
    expect_depths(write_json(file), THREE_DEPTHS);
    file["meshes"][1]["weights"] = {0.0};
    file["nodes"][1]["weights"] = {0.1};
    expect_depths(write_json(file), morphed);
    file["nodes"][1]["weights"] = {0.1, 0.2};  // for a missing target
    expect_depths(write_json(file), morphed, true);
}

TEST_F(GltfMesh, SkeletonsAreSaid) {
    std::string bytes = panes_bytes() + std::string(16, '\0');  // joints
    for (int corner = 0; corner < 4; ++corner)
        bytes += std::string("\0\0\x80\x3f", 4) + std::string(12, '\0');  // weights 1, 0, 0, 0
    for (int i = 0; i < 16; ++i) bytes += std::string(i % 5 == 0 ? "\0\0\x80\x3f" : "\0\0\0\0", 4);
    write("panes.bin", bytes);
    json file = panes_json("panes.bin");
    file["buffers"][0]["byteLength"] = 348;
    file["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 204}, {"byteLength", 16}});
    file["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 220}, {"byteLength", 64}});
    file["accessors"].push_back({{"bufferView", 5}, {"componentType", 5121}, {"count", 4}, {"type", "VEC4"}});
    file["accessors"].push_back({{"bufferView", 6}, {"componentType", 5126}, {"count", 4}, {"type", "VEC4"}});
    file["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 284}, {"byteLength", 64}});
    file["accessors"].push_back({{"bufferView", 7}, {"componentType", 5126}, {"count", 1}, {"type", "MAT4"}});
    json& attributes = file["meshes"][1]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = 5;
    attributes["WEIGHTS_0"] = 6;
    file["skins"] = {{{"joints", {0}}, {"inverseBindMatrices", 7}}};
    file["nodes"][1]["skin"] = 0;
    expect_warning(write_json(file), "skeleton");
}

TEST_F(GltfMesh, NumbersThatFloatsCannotHoldAreSaid) {
    write("panes.bin", panes_bytes([](float x) { return x + 5411932.0f; }));
    expect_warning(write_with_uri("panes.bin"), "as large as 5411933");
    write("panes.bin", panes_bytes([](float x) { return 1e-42f * x; }));
    expect_warning(write_with_uri("panes.bin"), "half diagonal of only 1.6");
    write("panes.bin", panes_bytes([](float x) { return x + 1000.0f; }));
    expect_depths(write_with_uri("panes.bin"), THREE_DEPTHS);
    for (const float scale : {1e-37f, 1e-20f, 1e-6f, 1e30f}) {
        write("panes.bin", panes_bytes([&](float x) { return scale * x; }));
        expect_depths(write_with_uri("panes.bin"), THREE_DEPTHS);
    }
    write("panes.bin", panes_bytes([](float x) { return x > 0.9f ? std::bit_cast<float>(0x7fc00000) : x; }));
    EXPECT_THROW(read_mesh_file(write_with_uri("panes.bin")), Error);
}

TEST(GltfFile, IsNothingElse) {
    EXPECT_FALSE(read_gltf("", "x"));
    EXPECT_FALSE(read_gltf("{", "x"));
    EXPECT_FALSE(read_gltf("{\"a\": 1}", "x"));
    EXPECT_FALSE(read_gltf("[]", "x"));
    EXPECT_FALSE(read_gltf("{\"asset\": {\"version\": \"1.0\"}}", "x"));
    EXPECT_FALSE(read_gltf(std::string("glTF\2\0\0\0\xff\xff\xff\xff\xff\xff\xff\xffJSON", 20), "x"));
    const auto odd = read_gltf(
        "{\"asset\": {\"version\": \"2.0\"}, \"scene\": -1, \"scenes\": [{\"nodes\": [0, 7, \"a\"]}], \"meshes\": 3,"
        "\"nodes\": [{\"children\": [9], \"translation\": [1], \"weights\": {}, \"rotation\": [0, 0, 0, 0]}, 5]}",
        "x");
    ASSERT_TRUE(odd);
    EXPECT_EQ(odd->nodes.size(), 2u);
    EXPECT_EQ(odd->roots, std::vector<std::uint32_t>{0});
    EXPECT_EQ(odd->nodes[0].local, glm::dmat4(1.0));
}

}  // namespace
