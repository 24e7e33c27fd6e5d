// Dynamics regions on figures made from bones.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/exchange/import/import_project.h"
#include "tests/unit/exchange/made_characters.h"

namespace hazumi::test {
namespace {

// These joints swing from frame 3 to 30, with the friction that the editor gives a region.
Project Swinging(const std::vector<JointRef>& joints) {
  Project project = ImportWell(Hand()).project;
  ProjectRegion region;
  region.name = "loose";
  region.first_frame = 3;
  region.last_frame = 30;
  region.joints = joints;
  region.friction.default_factor = 0.8;
  project.regions = {region};
  return project;
}

void ExpectSwing(const Motion& motion) {
  ASSERT_EQ(motion.frames.size(), 31u);
  double most = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_TRUE(frame.q.allFinite() && frame.after.qd.allFinite());
    most = std::max(most, frame.q.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(most, 0.02);
}

TEST(ImportRegion, FingersSwing) {
  ExpectSwing(BakeWell(
      Swinging({{"LeftFinger0", true, {}}, {"LeftFinger1", true, {}}, {"LeftFinger2", true, {}}})));
}

TEST(ImportRegion, ABoneOfNoLengthSwings) {
  ExpectSwing(BakeWell(Swinging({{"LeftHand", true, {}}})));
}

}  // namespace
}  // namespace hazumi::test
