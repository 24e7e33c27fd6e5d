#include "tests/unit/edit/random/random_projects.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "engine/project/json/text_file.h"
#include "engine/project/project_writer.h"
#include "tests/support/capture_skeletons.h"
#include "tests/unit/edit/sessions.h"
#include "tests/unit/project/skin_sample.h"

namespace hazumi::test {

namespace {

// Bones of a tree of joints, none of which has a name that says where it is.
std::vector<CaptureBone> RandomBones(Random* random) {
  static const char* const kNames[] = {"a", "b", "c", "d", "e", "f"};
  std::vector<CaptureBone> bones;
  for (const char* name : kNames) {
    const int parent = random->Integer(-1, static_cast<int>(bones.size()) - 1);
    const Vec3 from = parent < 0 ? Vec3(Vec3::Zero()) : bones[parent].at;
    bones.push_back({name, parent < 0 ? "Hips" : bones[parent].name,
                     from + Vec3(0.0, 0.0, 0.3) + random->Vector3(0.2)});
    if (random->Chance(0.2) && bones.size() > 2) break;
  }
  return bones;
}

std::string Numbers(const Vec3& v) {
  return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
}

// In centimetres, y up: x to the left, z ahead.
Vec3 InFile(const Vec3& v) { return 100.0 * Vec3(v.y(), v.z(), v.x()); }

class BvhText {
 public:
  explicit BvhText(const std::vector<CaptureBone>& bones) : bones_(bones) {
    text_ = "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition " +
            std::string(kTurns) + "\n";
    AddChildren("Hips", Vec3::Zero());
    text_ += "}\nMOTION\n";
  }

  void AddFrames(int count, int fps, Random* random) {
    text_ +=
        "Frames: " + std::to_string(count) + "\nFrame Time: " + std::to_string(1.0 / fps) + "\n";
    const VecX amplitude = random->Vector(3 * (num_joints_ + 1), 25.0);
    const double speed = random->Uniform(0.05, 0.3);
    for (int i = 0; i < count; ++i) {
      text_ += Numbers(Vec3(i, 95.0 + 5.0 * std::sin(speed * i), 2.0 * i));
      for (int k = 0; k < amplitude.size(); ++k) {
        text_ += " " + std::to_string(amplitude[k] * std::sin(speed * i + k));
      }
      text_ += "\n";
    }
  }
  const std::string& text() const { return text_; }

 private:
  static constexpr const char* kTurns = "Zrotation Xrotation Yrotation";

  void AddChildren(const std::string& parent, const Vec3& at) {
    bool is_last = true;
    for (const CaptureBone& bone : bones_) {
      if (bone.parent != parent) continue;
      is_last = false;
      ++num_joints_;
      text_ += std::string("JOINT ") + bone.name + "\n{\nOFFSET " + Numbers(InFile(bone.at - at)) +
               "\nCHANNELS 3 " + kTurns + "\n";
      AddChildren(bone.name, bone.at);
      text_ += "}\n";
    }
    if (is_last) text_ += "End Site\n{\nOFFSET 0 8 2\n}\n";
  }

  std::vector<CaptureBone> bones_;
  int num_joints_ = 0;
  std::string text_;
};

namespace fs = std::filesystem;

constexpr const char* kKept = "kept";    // the folder of copies in a folder of random files
constexpr const char* kStamp = "stamp";  // among them: whatever is younger was written by a test

void Write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void CopyOver(const fs::path& from, const fs::path& to) {
  fs::copy_file(from, to, fs::copy_options::overwrite_existing);
}

void Keep(const RandomFiles& files) {
  const fs::path kept = fs::path(files.folder) / kKept;
  fs::create_directory(kept);
  for (const auto& entry : fs::directory_iterator(files.folder)) {
    if (entry.is_regular_file()) CopyOver(entry.path(), kept / entry.path().filename());
  }
  Write(kept / kStamp, "");
}

// What each file is made by is a session's own work: nothing else writes projects.
void Save(edit::Session* session, const std::string& path, RandomFiles* files) {
  Do(session, "file.save", {{"path", path}});
  files->projects.push_back(path);
}

void AddExample(const std::string& name, RandomFiles* files) {
  edit::Session session;
  Do(&session, "file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/" + name + ".kfa"}});
  if (name == "throw") {
    Do(&session, "figure.embed");
    Do(&session, "drive.add",
       {{"region", "arms"}, {"joints", {"r_elbow_flexion"}}, {"kind", "torque"}});
    Do(&session, "drive.key", {{"region", "arms"}, {"number", 0}, {"frame", 8}, {"torque", 2}});
    Do(&session, "drive.add", {{"region", "arms"}, {"joints", {"l_elbow+"}}});
    const std::string& ball = session.project().held_objects[0].name;
    for (const int frame : {4, 20}) {
      const char* joint = frame == 4 ? "l_wrist" : "r_wrist";
      Do(&session, "held.pass", {{"object", ball}, {"joint", joint}, {"frame", frame}});
    }
  }
  Save(&session, files->folder + "/" + name + ".kfa", files);
}

// Somebody who stands with a ball that can be thrown.
void AddStanding(RandomFiles* files) {
  edit::Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 40}});
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}});
  Save(&session, files->folder + "/standing.kfa", files);
}

// A throw that can be aimed.
void AddThrown(RandomFiles* files) {
  edit::Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 30}});
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", 10}});
  Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 2}, {"value", -40}});
  Do(&session, "region.add",
     {{"name", "arm"}, {"first", 2}, {"last", 14}, {"joints", {"r_shoulder+"}}});
  Save(&session, files->folder + "/thrown.kfa", files);
}

// A hand that holds on to a bar, and elbows that keep their distance, while the arms swing.
void AddConstrained(RandomFiles* files) {
  edit::Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 30}});
  Do(&session, "region.add",
     {{"name", "arms"}, {"first", 0}, {"last", 20}, {"joints", {"r_shoulder+", "l_shoulder+"}}});
  Do(&session, "object.add_box", {{"name", "bar"}, {"x", 0.8}, {"z", 1.5}});
  Do(&session, "constraint.hold_on", {{"object", "bar"}, {"joint", "r_wrist"}, {"last", 20}});
  Do(&session, "constraint.add",
     {{"kind", "distance"},
      {"a_joint", "r_elbow"},
      {"b_joint", "l_elbow"},
      {"last", 12},
      {"arrive", 2},
      {"break_force", 500}});
  Save(&session, files->folder + "/constrained.kfa", files);
}

// An arm that comes down on a table.
void AddTouching(RandomFiles* files) {
  edit::Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 30}});
  Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", 100}});
  Do(&session, "object.add_box",
     {{"name", "table"}, {"x", 0.5}, {"y", -0.2}, {"z", 0.5}, {"friction_coefficient", 0.4}});
  Do(&session, "region.add",
     {{"name", "arm"},
      {"first", 0},
      {"last", 20},
      {"joints", {"r_shoulder+"}},
      {"contacts", true},
      {"contacts_self", true}});
  Save(&session, files->folder + "/touching.kfa", files);
}

// With a jump that can be aimed, and forces that the regions to come may feel.
void AddSkinned(RandomFiles* files) {
  edit::Session session;
  for (const char* kind : {"wind", "attract"}) Do(&session, "force.add", {{"kind", kind}});
  Do(&session, "jump.add", {{"x", 0.6}, {"y", 0.0}});
  Project project = session.project();
  project.skin = {.skin = std::make_shared<const Skin>(testing::SampleSkin())};
  session.Replace(project, "");
  Save(&session, files->folder + "/skinned.kfa", files);
}

void AddImported(const std::string& character, RandomFiles* files) {
  edit::Session session;
  const Result<Done> done = session.Run("file.import", {{"path", character}});
  ASSERT_TRUE(done.ok()) << character << ": " << done.error().ToString();
  Save(&session, character + ".kfa", files);
}

// Regions, placements, holds, markers and selection sets at random; what is refused stays away.
void Furnish(edit::Session* session, const RandomFiles& files, Random* random) {
  static const char* const kIds[] = {"region.add",     "region.set",     "region.friction",
                                     "hold.add",       "placement.set",  "marker.add",
                                     "object.add_box", "key.set",        "region.split",
                                     "select.joints",  "select.save_set"};
  for (int i = 0; i < 25; ++i) {
    const edit::Operator& op = *edit::FindOperator(kIds[random->Integer(0, std::size(kIds) - 1)]);
    (void)session->Run(op.id, RandomParameters(op.id, op.parameters, *session, files, random));
  }
  for (size_t i = 0; i < session->project().regions.size(); ++i) {
    (void)session->Run("region.set", {{"region", session->project().regions[i].name},
                                      {"method", i % 2 == 0 ? "paper" : "exact"}});
  }
}

}  // namespace

std::string RandomBvh(bool is_person, Random* random) {
  BvhText bvh(is_person ? CaptureBones() : RandomBones(random));
  bvh.AddFrames(random->Integer(2, 24), 30, random);
  return bvh.text();
}

RandomFiles WriteRandomFiles(const std::string& folder, uint64_t seed) {
  Random random(seed);
  RandomFiles files;
  files.folder = folder;
  files.mesh = folder + "/wedge.obj";
  Write(files.mesh,
        "v 0 0 0\nv 0.2 0 0\nv 0 0.1 0\nv 0 0 0.3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  for (const char* name : {"throw", "jump"}) AddExample(name, &files);
  AddThrown(&files);
  AddSkinned(&files);
  AddConstrained(&files);
  AddTouching(&files);
  AddStanding(&files);
  for (int i = 0; i < 4; ++i) {
    files.characters.push_back(folder + "/clip_" + std::to_string(i) + ".bvh");
    Write(files.characters.back(), RandomBvh(i % 2 == 0, &random));
    AddImported(files.characters.back(), &files);
  }
  for (const std::string& plain : std::vector(files.projects)) {
    edit::Session session;
    Do(&session, "file.open", {{"path", plain}});
    Furnish(&session, files, &random);
    Save(&session, plain + ".furnished.kfa", &files);
  }
  Keep(files);
  return files;
}

void RestoreRandomFiles(const RandomFiles& files) {
  for (const auto& entry : fs::directory_iterator(files.folder)) {
    const fs::path kept = fs::path(files.folder) / kKept / entry.path().filename();
    if (entry.is_regular_file() && !fs::exists(kept)) fs::remove(entry.path());
  }
  const fs::path stamp = fs::path(files.folder) / kKept / kStamp;
  for (const std::string& project : files.projects) {
    const bool is_as_it_was =
        fs::exists(project) && fs::last_write_time(project) < fs::last_write_time(stamp);
    if (!is_as_it_was) CopyOver(stamp.parent_path() / fs::path(project).filename(), project);
  }
  Write(stamp, "");
}

}  // namespace hazumi::test
