// Files of poses: read, written, refused; and those that come with Hazumi.

#include "engine/project/pose_file.h"

#include <gtest/gtest.h>

#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/spatial/degrees.h"
#include "engine/spatial/euler_angles.h"

namespace hazumi::testing {
namespace {

const std::string kAssets = HAZUMI_SOURCE_DIR "/assets/";

constexpr const char* kTwo = R"({
  "format": "hazumi-poses", "version": 1,
  "poses": [
    {"name": "sit", "root": {"height_m": 0.5, "angle_y_deg": 10}, "joints": {"r_knee": 90.5}},
    {"name": "arms", "joints": {"r_elbow_flexion": 20, "l_elbow_flexion": 30}, "mine": [1, 2]}
  ]
})";

std::string ComplaintOf(const std::string& text) {
  const Result<PoseFile> read = ParsePoses(text, "poses.json");
  return read.ok() ? "" : read.error().ToString();
}

std::string With(std::string poses) {
  return R"({"format": "hazumi-poses", "version": 1, "poses": [)" + poses + "]}";
}

TEST(PoseFile, IsReadBackAsItWasWritten) {
  const Result<PoseFile> read = ParsePoses(kTwo, "poses.json");
  ASSERT_TRUE(read.ok()) << read.error().ToString();
  const std::vector<SavedPose>& poses = read.value().poses;
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].root->height_m, 0.5);
  EXPECT_EQ(poses[0].root->angle_y_deg, 10.0);
  EXPECT_FALSE(poses[1].root);
  EXPECT_EQ(poses[1].joints[1].name, "l_elbow_flexion");
  const std::string written = WritePoses(read.value());
  const Result<PoseFile> again = ParsePoses(written, "poses.json");
  ASSERT_TRUE(again.ok());
  EXPECT_TRUE(again.value() == read.value());
  EXPECT_NE(written.find("\"mine\""), std::string::npos);  // of another program
}

TEST(PoseFile, NamesFilePlaceAndRemedyOfWhatIsWrong) {
  EXPECT_EQ(ComplaintOf(R"({"format": "hazumi-project"})"),
            "poses.json: not a file of Hazumi poses: expected an object with \"format\": "
            "\"hazumi-poses\"");
  EXPECT_EQ(ComplaintOf(With(R"({"name": "a"})")),
            "poses.json: poses[0]: the field \"joints\" is missing; add it");
  EXPECT_EQ(ComplaintOf(With(R"({"name": "", "joints": {}})")),
            "poses.json: poses[0].name: must not be empty");
  EXPECT_EQ(ComplaintOf(With(R"({"name": "a", "joints": {"r_knee": "bent"}})")),
            "poses.json: poses[0].joints.r_knee: expected a number, found a string");
  EXPECT_EQ(
      ComplaintOf(With(R"({"name": "a", "joints": {}}, {"name": "a", "joints": {}})")),
      "poses.json: poses[1].name: the name \"a\" is already used by poses[0]; choose another");
  EXPECT_EQ(LoadPoses("/no/such/poses.json").error().code, ErrorCode::kNoInput);
}

Figure Human() { return BuildFigure(LoadFigure(kAssets + "figures/human.json").value()).value(); }

// Lowest points of links whose name contains `part` [m].
double LowestOf(const std::string& part, const Figure& figure, const DynamicsWorkspace& ws) {
  double lowest = 1e9;
  for (const Link& link : figure.links()) {
    if (link.name.find(part) == std::string::npos) continue;
    const BodyScratch& body = ws.body(link.joint);
    for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
      lowest = std::min(lowest, (body.p + body.R * end).z() - link.capsule.radius);
    }
  }
  return lowest;
}

TEST(ShippedPoses, SayEveryHingeOfTheHumanWithinItsLimitsAndNothingElse) {
  const Figure human = Human();
  const Result<PoseFile> file = LoadPoses(kAssets + "poses/human.json");
  ASSERT_TRUE(file.ok()) << file.error().ToString();
  EXPECT_GE(file.value().poses.size(), 12u);
  for (const SavedPose& pose : file.value().poses) {
    EXPECT_EQ(pose.joints.size(), static_cast<size_t>(human.num_joints())) << pose.name;
    for (const Named<double>& angle : pose.joints) {
      const auto hinge = human.FindJoint(angle.name);
      ASSERT_TRUE(hinge) << pose.name << " " << angle.name;
      EXPECT_GE(angle.value, ShortestDegrees(human.joint(*hinge).lower)) << angle.name;
      EXPECT_LE(angle.value, ShortestDegrees(human.joint(*hinge).upper)) << angle.name;
    }
  }
}

// Nothing is inside the ground. A foot is on it, but for the apex of a jump, and of those that
// stand on both feet both are.
TEST(ShippedPoses, StandOnTheGround) {
  const Figure human = Human();
  const Result<PoseFile> file = LoadPoses(kAssets + "poses/human.json");
  ASSERT_TRUE(file.ok()) << file.error().ToString();
  for (const SavedPose& pose : file.value().poses) {
    VecX q = VecX::Zero(human.num_joints());
    for (const auto& angle : pose.joints) q[human.FindJoint(angle.name)->value()] = angle.value;
    q *= kDegree;
    const hazumi::Pose X_WR = {EulerRotation({2, 1, 0}, kDegree * Vec3(0.0, pose.root->angle_y_deg,
                                                                       pose.root->angle_x_deg)),
                               Vec3(0.0, 0.0, pose.root->height_m)};
    DynamicsWorkspace ws(human);
    ComputePositions(human, X_WR, q, &ws);
    EXPECT_GT(LowestOf("", human, ws), -1e-3) << pose.name;
    if (pose.name.starts_with("Apex")) {
      EXPECT_GT(LowestOf("", human, ws), 0.3);
      continue;
    }
    const double right = std::min(LowestOf("r_foot", human, ws), LowestOf("r_toes", human, ws));
    const double left = std::min(LowestOf("l_foot", human, ws), LowestOf("l_toes", human, ws));
    EXPECT_LT(std::min(right, left), 1e-3) << pose.name;
    const bool is_on_one = pose.name == "Walk, passing";
    EXPECT_LT(std::max(right, left), is_on_one ? 0.1 : 2e-3) << pose.name;
  }
}

}  // namespace
}  // namespace hazumi::testing
