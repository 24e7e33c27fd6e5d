// Numbers and curves of glTF in every form that the format has [glTF 2.0, 3.6.2, 3.11, appendix C].

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>
#include <numbers>

#include "engine/base/base64.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

Json& Sampler(Json* document) { return (*document)["animations"][0]["samplers"][0]; }
Json& Channel(Json* document) { return (*document)["animations"][0]["channels"][0]; }
Json& Primitive(Json* document) { return (*document)["meshes"][0]["primitives"][0]; }

// A view of a new buffer.
size_t AddView(const std::string& bytes, Json* document) {
  Json& buffers = (*document)["buffers"];
  buffers.push_back({{"byteLength", bytes.size()},
                     {"uri", "data:application/octet-stream;base64," + ToBase64(bytes)}});
  Json& views = (*document)["bufferViews"];
  views.push_back({{"buffer", buffers.size() - 1}, {"byteLength", bytes.size()}});
  return views.size() - 1;
}

template <typename T>
std::string BytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

size_t AddAccessor(const Json& accessor, Json* document) {
  (*document)["accessors"].push_back(accessor);
  return (*document)["accessors"].size() - 1;
}

template <typename T>
size_t Add(const std::vector<T>& values, size_t width, int component, Json* document) {
  const char* type = width == 1 ? "SCALAR" : width == 3 ? "VEC3" : "VEC4";
  return AddAccessor({{"bufferView", AddView(BytesOf(values), document)},
                      {"componentType", component},
                      {"count", values.size() / width},
                      {"type", type}},
                     document);
}

// Rotations about z by angles [deg], as whole numbers of which `one` is 1.
template <typename T>
size_t AddTurns(const std::vector<double>& angles, double one, int component, Json* document) {
  std::vector<T> values;
  for (const double angle : angles) {
    const double half = 0.5 * angle * std::numbers::pi / 180.0;
    for (const double part : {0.0, 0.0, std::sin(half), std::cos(half)})
      values.push_back(static_cast<T>(std::round(part * one)));
  }
  const size_t accessor = Add(values, 4, component, document);
  (*document)["accessors"][accessor]["normalized"] = true;
  return accessor;
}

TEST(GltfAccessors, RotationsAreReadFromWholeNumbers) {
  const auto read_angle = [](auto add, double tolerance) {
    Json document = test::SmallGltf();
    Sampler(&document)["output"] = add(&document);
    const Character c = test::ReadSmall("a.gltf", document.dump());
    EXPECT_NEAR(test::UpperTurnAt(c, 0), -40.0, tolerance);
    EXPECT_NEAR(test::UpperTurnAt(c, 15), 90.0, tolerance);
    EXPECT_TRUE(c.warnings.empty());
  };
  const std::vector<double> angles = {-40.0, 90.0};
  read_angle([&](Json* d) { return AddTurns<int8_t>(angles, 127.0, 5120, d); }, 0.5);
  read_angle([&](Json* d) { return AddTurns<int16_t>(angles, 32767.0, 5122, d); }, 0.002);
}

// Without signs a quaternion can only turn the one way.
TEST(GltfAccessors, RotationsAreReadFromWholeNumbersWithoutSigns) {
  Json document = test::SmallGltf();
  Sampler(&document)["output"] = AddTurns<uint8_t>({20.0, 90.0}, 255.0, 5121, &document);
  EXPECT_NEAR(test::UpperTurnAt(test::ReadSmall("a.gltf", document.dump()), 0), 20.0, 0.3);
  Sampler(&document)["output"] = AddTurns<uint16_t>({20.0, 90.0}, 65535.0, 5123, &document);
  EXPECT_NEAR(test::UpperTurnAt(test::ReadSmall("a.gltf", document.dump()), 15), 90.0, 0.002);
}

// The most negative number is -1, too.
TEST(GltfAccessors, TheMostNegativeNumberIsMinusOne) {
  Json document = test::SmallGltf();
  const size_t places = Add<int8_t>({-128, 0, 127, -127, 0, 127}, 3, 5120, &document);
  document["accessors"][places]["normalized"] = true;
  Sampler(&document)["output"] = places;
  Channel(&document)["target"]["path"] = "translation";
  const Character c = test::ReadSmall("a.gltf", document.dump());
  for (const Vec3& place : c.clips.at(0).tracks.at(1).translations)
    EXPECT_EQ(place, Vec3(-1, 0, 1));
}

TEST(GltfAccessors, SparseOnesReplaceSomeElements) {
  const double half = 0.25 * std::numbers::pi;
  const auto sin = static_cast<float>(std::sin(half)), cos = static_cast<float>(std::cos(half));
  for (const bool has_base : {true, false}) {
    Json document = test::SmallGltf();
    Json accessor = {{"componentType", 5126}, {"count", 2}, {"type", "VEC4"}};
    const std::vector<float> base = {0, 0, 0, 1, 1, 0, 0, 0};
    if (has_base) accessor["bufferView"] = AddView(BytesOf(base), &document);
    // Of the one without a base both, which are zeros else.
    const std::vector<uint16_t> at =
        has_base ? std::vector<uint16_t>{1} : std::vector<uint16_t>{0, 1};
    std::vector<float> values = {0, 0, sin, cos};
    if (!has_base) values.insert(values.begin(), {0, 0, 0, 1});
    accessor["sparse"] = {
        {"count", at.size()},
        {"indices", {{"bufferView", AddView(BytesOf(at), &document)}, {"componentType", 5123}}},
        {"values", {{"bufferView", AddView(BytesOf(values), &document)}}}};
    Sampler(&document)["output"] = AddAccessor(accessor, &document);
    const Character c = test::ReadSmall("a.gltf", document.dump());
    EXPECT_NEAR(test::UpperTurnAt(c, 0), 0.0, 1e-4) << has_base;
    EXPECT_NEAR(test::UpperTurnAt(c, 15), 90.0, 1e-4) << has_base;
  }
}

TEST(GltfAccessors, ElementsMayLieApart) {
  Json document = test::SmallGltf();
  // A rotation and eight bytes of something else, twice.
  const float root = std::sqrt(0.5f);
  const std::vector<float> bytes = {7, 0, 0, 0, 1, 7, 7, 0, 0, root, root, 7};
  const size_t view = AddView(BytesOf(bytes), &document);
  document["bufferViews"][view]["byteStride"] = 24;
  Sampler(&document)["output"] = AddAccessor({{"bufferView", view},
                                              {"byteOffset", 4},
                                              {"componentType", 5126},
                                              {"count", 2},
                                              {"type", "VEC4"}},
                                             &document);
  const Character c = test::ReadSmall("a.gltf", document.dump());
  EXPECT_NEAR(test::UpperTurnAt(c, 0), 0.0, 1e-4);
  EXPECT_NEAR(test::UpperTurnAt(c, 15), 90.0, 1e-4);
}

TEST(GltfAccessors, WhatReachesBeyondItsBytesIsRefusedByItsPlace) {
  for (const Json& change :
       {Json{{"count", 3}}, Json{{"byteOffset", 8}}, Json{{"count", uint64_t{1} << 62}}}) {
    Json document = test::SmallGltf();
    const size_t output = Sampler(&document)["output"];
    document["accessors"][output].update(change);
    const Error error = test::ErrorOfSmall("a.gltf", document.dump());
    EXPECT_EQ(error.place, "accessors[" + std::to_string(output) + "]") << change;
    EXPECT_NE(error.message.find("export it again"), std::string::npos);
  }
}

// Positions of 16 bits, a mesh that its node makes as large as it was.
TEST(GltfMeshes, QuantizedPositionsAreRead) {
  Json document = test::SmallGltf();
  const Character expected = test::ReadSmall("a.gltf", document.dump());
  const size_t positions =
      Add<int16_t>({0, 0, 0, 16384, 0, 0, 0, 32767, 0, 16384, 32767, 0}, 3, 5122, &document);
  document["accessors"][positions]["normalized"] = true;
  Primitive(&document)["attributes"]["POSITION"] = positions;
  document["extensionsRequired"] = {"KHR_mesh_quantization"};
  const Character c = test::ReadSmall("a.gltf", document.dump());
  ASSERT_EQ(c.meshes.size(), 1u);
  for (size_t v = 0; v < 4; ++v)
    EXPECT_TRUE((2.0f * c.meshes[0].positions[v]).isApprox(expected.meshes[0].positions[v], 1e-4f));
}

TEST(GltfMeshes, StripsAndFansAreTriangles) {
  Json document = test::SmallGltf();
  Primitive(&document)["indices"] = Add<uint16_t>({0, 1, 2, 3}, 1, 5123, &document);
  Primitive(&document)["mode"] = 5;
  using Triangles = std::vector<std::array<uint32_t, 3>>;
  EXPECT_EQ(test::ReadSmall("a.gltf", document.dump()).meshes.at(0).triangles,
            (Triangles{{0, 1, 2}, {2, 1, 3}}));
  Primitive(&document)["indices"] = Add<uint16_t>({0, 1, 3, 2}, 1, 5123, &document);
  Primitive(&document)["mode"] = 6;
  EXPECT_EQ(test::ReadSmall("a.gltf", document.dump()).meshes.at(0).triangles,
            (Triangles{{0, 1, 3}, {0, 3, 2}}));
}

TEST(GltfMeshes, NormalsThatAreMissingAreThoseOfTheTriangles) {
  const Character c = test::ReadSmall("a.gltf", test::SmallGltf().dump());
  for (const Eigen::Vector3f& normal : c.meshes.at(0).normals)
    EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
}

TEST(GltfMeshes, TrianglesAndWeightsOfNothingAreRefused) {
  Json document = test::SmallGltf();
  Primitive(&document)["indices"] = Add<uint16_t>({0, 1, 4}, 1, 5123, &document);
  EXPECT_NE(test::ErrorOfSmall("a.gltf", document.dump()).message.find("without a vertex"),
            std::string::npos);
  document = test::SmallGltf();
  Primitive(&document)["attributes"]["JOINTS_0"] =
      Add<uint8_t>({0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0}, 4, 5121, &document);
  const size_t weights =
      Add<float>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 4, 5126, &document);
  Primitive(&document)["attributes"]["WEIGHTS_0"] = weights;
  EXPECT_NE(test::ErrorOfSmall("a.gltf", document.dump()).message.find("joint that is not there"),
            std::string::npos);
}

// Encoded here by meshopt itself.
TEST(GltfMeshes, ThoseOfMeshoptAreDecoded) {
  Json document = test::SmallGltf();
  const Character expected = test::ReadSmall("a.gltf", document.dump());
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 2, 0, 1, 2, 0};
  std::string bytes(meshopt_encodeVertexBufferBound(4, 12), '\0');
  bytes.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(bytes.data()),
                                          bytes.size(), positions.data(), 4, 12));
  const size_t view = AddView(bytes, &document);
  const Json buffer = document["bufferViews"][view]["buffer"];
  document["bufferViews"][view]["extensions"]["EXT_meshopt_compression"] = {
      {"buffer", buffer},
      {"byteLength", bytes.size()},
      {"byteStride", 12},
      {"count", 4},
      {"mode", "ATTRIBUTES"}};
  document["extensionsRequired"] = {"EXT_meshopt_compression"};
  Primitive(&document)["attributes"]["POSITION"] = AddAccessor(
      {{"bufferView", view}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}}, &document);
  const Character c = test::ReadSmall("a.gltf", document.dump());
  EXPECT_EQ(c.meshes.at(0).positions, expected.meshes.at(0).positions);
  document["bufferViews"][view]["extensions"]["EXT_meshopt_compression"]["byteLength"] = 9;
  EXPECT_NE(test::ErrorOfSmall("a.gltf", document.dump()).message.find("decoded by meshopt"),
            std::string::npos);
}

TEST(Gltf, ExtensionsThatAreNotKnownAreRefusedByTheirName) {
  Json document = test::SmallGltf();
  document["extensionsUsed"] = {"ACME_teapots"};
  EXPECT_TRUE(test::ReadSmall("a.gltf", document.dump()).warnings.empty()) << "it is not required";
  document["extensionsRequired"] = {"KHR_materials_unlit", "ACME_teapots"};
  const Error error = test::ErrorOfSmall("a.gltf", document.dump());
  EXPECT_EQ(error.place, "extensionsRequired");
  EXPECT_NE(error.message.find("requires ACME_teapots"), std::string::npos) << error.message;
}

TEST(GltfClips, AChannelWithoutANodeIsLeftOut) {
  Json document = test::SmallGltf();
  Json channels = document["animations"][0]["channels"];
  channels.push_back({{"sampler", 0}, {"target", {{"path", "rotation"}}}});
  document["animations"][0]["channels"] = channels;
  const Character c = test::ReadSmall("a.gltf", document.dump());
  EXPECT_TRUE(c.clips.at(0).tracks.at(0).rotations.empty());
  EXPECT_NEAR(test::UpperTurnAt(c, 15), 90.0, 1e-4);
}

TEST(GltfClips, PointersToNodesMoveThemAndOthersAreNamed) {
  const auto pointer = [](const std::string& to) {
    return Json{{"path", "pointer"},
                {"extensions", {{"KHR_animation_pointer", {{"pointer", to}}}}}};
  };
  Json document = test::SmallGltf();
  Channel(&document)["target"] = pointer("/nodes/2/rotation");
  const Character c = test::ReadSmall("a.gltf", document.dump());
  EXPECT_NEAR(test::UpperTurnAt(c, 15), 90.0, 1e-4);
  EXPECT_TRUE(c.warnings.empty());
  for (const char* to : {"/materials/0/alphaCutoff", "/nodes/2", "/nodes/two/rotation", ""}) {
    document["animations"][0]["channels"][1] = {{"sampler", 0}, {"target", pointer(to)}};
    const Character other = test::ReadSmall("a.gltf", document.dump());
    EXPECT_NEAR(test::UpperTurnAt(other, 15), 90.0, 1e-4);
    ASSERT_EQ(other.warnings.size(), 1u) << to;
    EXPECT_NE(other.warnings[0].message.find(std::string("left out: ") + to), std::string::npos);
  }
}

// Tangents a before and b behind a key, as the format has them: a, v, b. Between 0 s and 1 s the
// place is the polynomial 3 s^2 - s^3 along x and s^3 along y.
TEST(GltfClips, SplinesFollowTheirTangents) {
  Json document = test::SmallGltf();
  Sampler(&document) = {
      {"input", Add<float>({0, 1}, 1, 5126, &document)},
      {"output",
       Add<float>({9, 9, 9, 0, 0, 0, 0, 0, 0, 3, 3, 0, 2, 1, 0, 9, 9, 9}, 3, 5126, &document)},
      {"interpolation", "CUBICSPLINE"}};
  Channel(&document)["target"]["path"] = "translation";
  const Character c = test::ReadSmall("a.gltf", document.dump());
  ASSERT_EQ(c.clips.at(0).num_frames, 31);
  EXPECT_TRUE(c.warnings.empty());
  for (int frame = 0; frame <= 30; ++frame) {
    const double s = frame / 30.0;
    const Vec3 expected(3 * s * s - s * s * s, s * s * s, 0);
    const Vec3 place = c.clips[0].tracks.at(1).translations.at(static_cast<size_t>(frame));
    EXPECT_TRUE((place - expected).norm() < 1e-6) << frame << ": " << place.transpose();
  }
}

TEST(GltfClips, SplinesOfRotationsAreNormalized) {
  Json document = test::SmallGltf();
  const float root = std::sqrt(0.5f);
  Sampler(&document) = {{"input", Add<float>({0, 1}, 1, 5126, &document)},
                        {"output", Add<float>({0, 0, 0, 0, 0, 0, 0,    1,    0, 0, 0, 0,
                                               0, 0, 0, 0, 0, 0, root, root, 0, 0, 0, 0},
                                              4, 5126, &document)},
                        {"interpolation", "CUBICSPLINE"}};
  const Character c = test::ReadSmall("a.gltf", document.dump());
  for (int frame = 0; frame <= 30; ++frame) {
    const double s = frame / 30.0, h = 3 * s * s - 2 * s * s * s;  // without tangents
    const double z = h * root, w = 1 - h + h * root;
    EXPECT_NEAR(test::UpperTurnAt(c, static_cast<size_t>(frame)),
                2 * std::atan2(z, w) * 180 / std::numbers::pi, 1e-4);
  }
}

// Times in single precision lie beside the frames.
TEST(GltfClips, StepsAreOnTheirFrames) {
  for (const double rate : {30.0, 24.0, 60.0}) {
    std::vector<float> times;
    for (int i = 0; i < 100; ++i) times.push_back(static_cast<float>(i / rate));
    Json document = test::SmallGltfWithTimes(times);
    Sampler(&document)["interpolation"] = "STEP";
    const Character c = test::ReadSmall("a.gltf", document.dump());
    for (size_t i = 0; i < 100; ++i)
      EXPECT_NEAR(test::UpperTurnAt(c, i), 90.0 * static_cast<double>(i) / 99.0, 1e-3)
          << rate << " " << i;
  }
}

TEST(GltfClips, AsManyValuesAsTimesAreWanted) {
  Json document = test::SmallGltf();
  Sampler(&document)["input"] = Add<float>({0, 1, 2}, 1, 5126, &document);
  const Error error = test::ErrorOfSmall("a.gltf", document.dump());
  EXPECT_EQ(error.place, "clip turn");
  EXPECT_NE(error.message.find("3 times and 2 values"), std::string::npos) << error.message;
}

TEST(GltfNodes, AreChildrenOnce) {
  Json document = test::SmallGltf();
  document["nodes"][2]["children"] = {1};
  const Error error = test::ErrorOfSmall("a.gltf", document.dump());
  EXPECT_EQ(error.place, "nodes[1]");
  EXPECT_NE(error.message.find("child of two nodes"), std::string::npos) << error.message;
}

}  // namespace
}  // namespace hazumi
