// Changed bones in files: what an independent reader of whole characters (tests/cli/onto_test.py)
// does not come to.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/exchange/bvh/bvh_file.h"
#include "engine/exchange/gltf/glb_chunks.h"
#include "engine/exchange/onto/bvh_onto.h"
#include "engine/exchange/onto/gltf_onto.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

// One bone, turned about x by 0.1 a frame, in three frames from frame 0 on.
EditedClip Turned(int node) {
  EditedClip clip;
  clip.index = 0;
  clip.name = "wave";
  clip.num_frames = clip.num_source_frames = 3;
  clip.start_s = 0.5;
  clip.seconds_per_frame = 0.1;
  EditedBone bone;
  bone.name = "arm";
  bone.node = node;
  for (int f = 0; f < 3; ++f) {
    bone.rotations.emplace_back(Eigen::AngleAxisd(0.1 * f, Vec3::UnitX()));
    bone.is_changed.push_back(f > 0);
  }
  clip.bones.push_back(std::move(bone));
  return clip;
}

Json Document() {
  return Json::parse(R"({"asset": {"version": "2.0"}, "extras": {"mine": [1.5, "x"]},
    "nodes": [{"name": "hips", "children": [1]},
              {"name": "arm", "matrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 1,2,3,1]}],
    "accessors": [{"componentType": 5126, "count": 1, "type": "SCALAR", "min": [0], "max": [0]},
                  {"componentType": 5126, "count": 1, "type": "VEC4"}],
    "animations": [{"name": "wave",
      "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}},
                   {"sampler": 0, "target": {"node": 1, "path": "rotation"}}],
      "samplers": [{"input": 0, "output": 1}]},
      {"name": "other", "channels": [], "samplers": []}]})");
}

TEST(GltfOnto, ChannelThatSharesItsSamplerGetsOneOfItsOwn) {
  const Result<std::string> written = GltfOnto(Document().dump(), Turned(1));
  ASSERT_TRUE(written.ok()) << written.error().ToString();
  const Json json = Json::parse(written.value());
  const Json& clip = json["animations"][0];
  EXPECT_EQ(clip["channels"][0], Document()["animations"][0]["channels"][0]);
  EXPECT_EQ(clip["channels"][1]["sampler"], 1);
  EXPECT_EQ(clip["samplers"][0], Document()["animations"][0]["samplers"][0]);
  EXPECT_EQ(json["animations"][1], Document()["animations"][1]);
  EXPECT_EQ(json["extras"], Document()["extras"]);
  EXPECT_EQ(json["accessors"][2]["count"], 3);
  EXPECT_FLOAT_EQ(json["accessors"][2]["min"][0].get<float>(), 0.5f);
}

TEST(GltfOnto, MatrixOfAnAnimatedNodeBecomesItsParts) {
  const Result<std::string> written = GltfOnto(Document().dump(), Turned(1));
  ASSERT_TRUE(written.ok());
  const Json node = Json::parse(written.value())["nodes"][1];
  EXPECT_FALSE(node.contains("matrix"));
  EXPECT_EQ(node["translation"], Json({1.0, 2.0, 3.0}));
  EXPECT_EQ(node["scale"], Json({2.0, 2.0, 2.0}));
  EXPECT_EQ(node["rotation"], Json({0.0, 0.0, 0.0, 1.0}));
}

TEST(GltfOnto, NodeWithoutAChannelGetsOne) {
  Json document = Document();
  document["animations"][0]["channels"].erase(1);
  const Result<std::string> written = GltfOnto(document.dump(), Turned(1));
  ASSERT_TRUE(written.ok());
  const Json channels = Json::parse(written.value())["animations"][0]["channels"];
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels[1]["target"], Json({{"node", 1}, {"path", "rotation"}}));
}

TEST(GltfOnto, PointerIsAChannelToo) {
  Json document = Document();
  document["animations"][0]["channels"][1] = {
      {"sampler", 0},
      {"target",
       {{"path", "pointer"},
        {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/1/rotation"}}}}}}}};
  const Result<std::string> written = GltfOnto(document.dump(), Turned(1));
  ASSERT_TRUE(written.ok());
  const Json channels = Json::parse(written.value())["animations"][0]["channels"];
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels[1]["sampler"], 1);
  EXPECT_EQ(channels[1]["target"]["path"], "pointer");
}

TEST(GltfOnto, BufferAndUnknownChunksOfAGlbStay) {
  Json document = Document();
  document["buffers"] = {{{"byteLength", 5}}};
  const std::string other("\4\0\0\0ODDSabcd", 12);
  const Result<std::string> glb = GlbFile(document.dump(), "12345", other);
  ASSERT_TRUE(glb.ok());
  const Result<std::string> written = GltfOnto(glb.value(), Turned(1));
  ASSERT_TRUE(written.ok()) << written.error().ToString();
  const std::string_view binary = ChunkOf(written.value(), GlbChunk::kBinary);
  EXPECT_TRUE(binary.starts_with("12345"));
  EXPECT_EQ(OtherChunks(written.value()), other);
  const Json json = Json::parse(ChunkOf(written.value(), GlbChunk::kJson));
  EXPECT_EQ(json["buffers"][0]["byteLength"], 8 + 3 * 4 + 3 * 16);
  EXPECT_EQ(json["bufferViews"][0]["byteOffset"], 8);
}

TEST(GltfOnto, FrameBeforeTimeZeroIsRefused) {
  EditedClip clip = Turned(1);
  clip.first = -6;
  const Result<std::string> written = GltfOnto(Document().dump(), clip);
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().message.find("from -5 on"), std::string::npos)
      << written.error().message;
}

TEST(GltfOnto, FileThatHasChangedSinceIsRefused) {
  Json document = Document();
  document["nodes"].erase(1);
  EXPECT_FALSE(GltfOnto(document.dump(), Turned(1)).ok());
  document.erase("animations");
  EXPECT_FALSE(GltfOnto(document.dump(), Turned(0)).ok());
  EXPECT_FALSE(GltfOnto("{", Turned(0)).ok());
}

TEST(GltfOnto, FilesBesideAreFound) {
  Json document = Document();
  EXPECT_FALSE(HasFilesBeside(document.dump()).value());
  document["images"] = {{{"uri", "data:image/png;base64,AAAA"}}};
  EXPECT_FALSE(HasFilesBeside(document.dump()).value());
  document["buffers"] = {{{"uri", "a.bin"}, {"byteLength", 4}}};
  EXPECT_TRUE(HasFilesBeside(document.dump()).value());
}

constexpr const char* kBvh =
    "HIERARCHY\r\nROOT hips\r\n{\r\n OFFSET 0 0 0\r\n CHANNELS 6 Xposition Yposition Zposition "
    "Zrotation Xrotation Yrotation\r\n JOINT arm\r\n {\r\n  OFFSET 0 1 0\r\n  CHANNELS 1 "
    "Xrotation\r\n  End Site\r\n  {\r\n   OFFSET 0 1 0\r\n  }\r\n }\r\n}\r\nMOTION\r\nFrames: 3\r\n"
    "Frame Time: 0.1\r\n0 1 0 0 0 0 7.5\r\n0 1.0 0 0 0 0 7.5\r\n0 1 0 0 0 0   7.5\r\n";

Character ReadSample() { return ReadBvh(kBvh, "a.bvh").value(); }

TEST(BvhOnto, OnlyChangedNumbersChange) {
  const Result<std::string> written = BvhOnto(kBvh, ReadSample(), Turned(1));
  ASSERT_TRUE(written.ok()) << written.error().ToString();
  std::string expected = kBvh;
  const size_t second = expected.find("7.5\r\n0 1 0 0 0 0   7.5");
  const std::string rows = "5.729578\r\n0 1 0 0 0 0   11.459156";
  expected.replace(second, std::string("7.5\r\n0 1 0 0 0 0   7.5").size(), rows);
  EXPECT_EQ(written.value(), expected);
}

TEST(BvhOnto, FramesBeyondTheLastAreMoreRows) {
  EditedClip clip = Turned(1);
  clip.num_frames = 4;
  clip.bones[0].rotations.push_back(clip.bones[0].rotations.back());
  clip.bones[0].is_changed.push_back(1);
  const Result<std::string> written = BvhOnto(kBvh, ReadSample(), clip);
  ASSERT_TRUE(written.ok()) << written.error().ToString();
  EXPECT_NE(written.value().find("Frames: 4\r\n"), std::string::npos);
  const Result<Character> read = ReadBvh(written.value(), "b.bvh");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value().clips[0].num_frames, 4);
  EXPECT_NEAR(read.value().clips[0].tracks[1].angles[3][0], 0.2, 1e-7);
}

TEST(BvhOnto, TurnThatTheChannelsCannotSayIsRefused) {
  EditedClip clip = Turned(1);
  clip.bones[0].rotations[1] = Eigen::AngleAxisd(0.3, Vec3::UnitY());
  const Result<std::string> written = BvhOnto(kBvh, ReadSample(), clip);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().place, "arm");
}

TEST(BvhOnto, RowsThatAreNotTheFramesAreRefused) {
  EditedClip clip = Turned(1);
  clip.num_source_frames = 2;
  EXPECT_FALSE(BvhOnto(kBvh, ReadSample(), clip).ok());
}

}  // namespace
}  // namespace hazumi
