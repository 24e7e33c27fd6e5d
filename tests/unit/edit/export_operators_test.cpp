#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/base/atomic_file.h"
#include "engine/exchange/bvh/bvh_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"
#include "ui/edit/operators/foreign_files.h"

namespace hazumi::test {
namespace {

namespace fs = std::filesystem;
using edit::Json;
using edit::Session;

class FileExport : public testing::Test {
 protected:
  void SetUp() override {
    Do(&session_, "file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/throw.kfa"}});
    // What the editor makes of the capsules; here one triangle.
    session_.set_capsules([](const Figure& figure) {
      Skin skin;
      skin.bones = {figure.root_name()};
      SkinMesh mesh;
      mesh.name = "capsules";
      mesh.binds.push_back({});
      for (const float x : {0.0f, 1.0f, 2.0f}) {
        mesh.positions.emplace_back(x, x * x, 0.0f);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
        mesh.bind_indices.push_back({0, 0, 0, 0});
        mesh.weights.push_back({1.0f, 0.0f, 0.0f, 0.0f});
      }
      mesh.triangles.push_back({0, 1, 2});
      skin.materials.push_back({"grey", {0.5f, 0.5f, 0.5f, 1.0f}, -1});
      mesh.material = 0;
      skin.meshes.push_back(mesh);
      return skin;
    });
  }

  std::string File(const std::string& name) const { return folder_ / name; }
  std::string Written(const std::string& name, Json parameters = Json::object()) {
    parameters["path"] = File(name);
    Do(&session_, "file.export", parameters);
    std::ifstream stream(File(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  Error Refused(Json parameters) {
    return hazumi::test::Refused(&session_, "file.export", parameters);
  }
  Error RefusedFor(const std::string& name, Json parameters = Json::object()) {
    parameters["path"] = File(name);
    return Refused(parameters);
  }
  int num_frames() const {
    const ProjectFrames& frames = session_.project().frames;
    return frames.last - frames.first + 1;
  }

  TemporaryFolder folder_;
  Session session_;
};

TEST_F(FileExport, WritesEachFormatAndChangesNothing) {
  const std::string before = WriteProject(session_.project());
  EXPECT_TRUE(Written("a.bvh").starts_with("HIERARCHY"));
  EXPECT_TRUE(Written("a.glb").starts_with("glTF"));
  EXPECT_EQ(Json::parse(Written("a.gltf")).at("asset").at("version"), "2.0");
  EXPECT_TRUE(Written("a.CSV").starts_with("frame,time_s,root_x_m"));
  EXPECT_EQ(Json::parse(Written("a.json")).at("frames").size(), static_cast<size_t>(num_frames()));
  EXPECT_EQ(WriteProject(session_.project()), before);
  EXPECT_TRUE(session_.document().is_saved());
  EXPECT_EQ(session_.document().num_steps(), 0u);
  EXPECT_EQ(folder_.num_entries(), 5u);  // nothing beside them
}

TEST_F(FileExport, TablesHaveTheTorquesThatAreAskedFor) {
  EXPECT_EQ(Written("a.csv").find("r_knee_n_m"), std::string::npos);
  EXPECT_NE(Written("a.csv", {{"torques", true}}).find("r_knee_n_m"), std::string::npos);
  EXPECT_TRUE(
      Json::parse(Written("a.json", {{"torques", true}})).at("frames")[0].contains("torques_n_m"));
}

TEST_F(FileExport, BvhHasTheChosenFramesUnitAndAxes) {
  const auto read = [&](const Json& parameters) {
    Result<Character> character = ReadBvh(Written("a.bvh", parameters), "a.bvh");
    EXPECT_TRUE(character.ok());
    return std::move(character).value();
  };
  const Vec3 p = session_.WholeMotion().value()->frames.at(4).X_WR.p;
  const Character whole = read({});
  EXPECT_EQ(whole.clips.at(0).num_frames, num_frames());
  const Character part = read({{"first", 4}, {"last", 9}, {"up", "z"}, {"unit", 1.0}});
  EXPECT_EQ(part.clips.at(0).num_frames, 6);
  const auto& places = part.clips.at(0).tracks.at(0).translations;
  ASSERT_FALSE(places.empty());
  EXPECT_LT((places.front() - p).norm(), 1e-5);
  const auto& usual = whole.clips.at(0).tracks.at(0).translations.at(4);
  EXPECT_LT((0.01 * usual - Vec3(p.y(), p.z(), p.x())).norm(), 1e-5);
}

TEST_F(FileExport, GltfHasTheSkinThatIsAskedForAndTheRegions) {
  const auto written = [&](const Json& parameters) {
    return Json::parse(Written("a.gltf", parameters));
  };
  Do(&session_, "figure.skin", {{"skin", "none"}});
  const size_t num_held = session_.project().held_objects.size();
  EXPECT_EQ(written({}).at("meshes").size(), 1 + num_held);
  const Json bare = written({{"skin", "none"}});
  EXPECT_EQ(bare.at("meshes").size(), num_held);
  EXPECT_EQ(bare.at("animations").at(0).at("extras").at("hazumi").at("regions").size(),
            session_.project().regions.size());
  EXPECT_EQ(RefusedFor("a.gltf", {{"skin", "character"}}).place, "file.export.skin");
  session_.set_capsules(nullptr);
  EXPECT_EQ(written({}).at("meshes").size(), num_held);
  EXPECT_EQ(RefusedFor("a.gltf", {{"skin", "capsules"}}).place, "file.export.skin");
}

TEST_F(FileExport, FollowsAnEditWithoutBeingAskedToBake) {
  const std::string before = Written("a.csv");
  Do(&session_, "key.set", {{"curve", "r_knee"}, {"frame", 3}, {"value", 55}});
  EXPECT_NE(Written("a.csv"), before);
}

TEST_F(FileExport, SaysWhatCannotBeWrittenAndLeavesNothing) {
  const auto says = [](const Error& error, const char* text) {
    EXPECT_NE(error.ToString().find(text), std::string::npos) << error.ToString();
  };
  says(RefusedFor("a.fbx"), "none of .bvh, .gltf, .glb, .csv, .json");
  says(RefusedFor("a"), "none of .bvh");
  says(RefusedFor("a.mp4"), "hazumi --export");
  says(RefusedFor("no/a.bvh"), "there is no folder");
  fs::create_directory(File("b.bvh"));
  says(RefusedFor("b.bvh"), "is a folder");
  const std::string last = std::to_string(session_.project().frames.last);
  says(RefusedFor("a.bvh", {{"last", 1000}}), ("0 to " + last).c_str());
  says(RefusedFor("a.bvh", {{"first", -1}}), "first: ");
  says(RefusedFor("a.bvh", {{"first", 9}, {"last", 8}}), "must not come after");
  says(RefusedFor("a.bvh", {{"unit", 0}}), "greater than 0");
  says(RefusedFor("a.bvh", {{"up", "x"}}), "none of y, z");
  says(RefusedFor("a.glb", {{"up", "z"}}), "only .bvh");
  says(RefusedFor("a.csv", {{"skin", "none"}}), "only .gltf and .glb");
  says(RefusedFor("a.bvh", {{"torques", true}}), "only .json and .csv");
  EXPECT_EQ(folder_.num_entries(), 1u);  // the folder made here
}

TEST_F(FileExport, KeepsTheOldFileWhereItCannotWriteTheNewOne) {
  std::ofstream(File("a.bvh")) << "old";
  Do(&session_, "key.set", {{"curve", "r_knee"}, {"frame", 3}, {"value", 55}});
  EXPECT_FALSE(session_.Run("file.export", {{"path", File("a.bvh")}, {"skin", "none"}}).ok());
  std::ifstream stream(File("a.bvh"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "old");
  EXPECT_TRUE(Written("a.bvh").starts_with("HIERARCHY"));
}

TEST(WriteFileAtomically, LeavesTheOldFileWhenItIsCancelled) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.bvh";
  ASSERT_TRUE(WriteFileAtomically(path, "old").ok());
  const std::atomic<bool> cancel = true;
  const Result<Done> written = WriteFileAtomically(path, "new", WriteMode::kFast, &cancel);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, ErrorCode::kInterrupted);
  std::ifstream stream(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "old");
  EXPECT_EQ(folder.num_entries(), 1u);
}

}  // namespace
}  // namespace hazumi::test
