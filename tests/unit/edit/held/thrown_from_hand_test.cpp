// A ball that is thrown leaves the hand without going through it: what is measured is the skin that
// is drawn.

#include <algorithm>
#include <string>

#include "engine/dynamics/kinematics.h"
#include "engine/project/project_figure.h"
#include "render/mesh/linear_blend.h"
#include "render/motion/figure_skin.h"
#include "tests/unit/edit/held/throws.h"

namespace hazumi::test {
namespace {

using edit::Session;
using render::FigureSkin;
using render::SkinnedVertex;

FigureSkin SkinOf(const Figure& figure) {
  const auto model = render::MakeSkinModel(MeshesOf(ShippedSkin::kHuman));
  EXPECT_TRUE(model.ok());
  Result<FigureSkin> skin = PutOn(figure, model.value());
  EXPECT_TRUE(skin.ok());
  return std::move(skin).value();
}

// How deep the ball is in the skin, of all its vertices; negative: how far away [m].
double Depth(const MotionFrame& frame, double radius, const Figure& figure,
             const FigureSkin& skin) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  std::vector<SkinnedVertex> vertices;
  PoseSkin({skin.model, skin.PosesIn(figure, frame.q, ws), {}, 1.0f}, &vertices);
  double nearest = 1e9;
  for (const SkinnedVertex& v : vertices) {
    const Vec3 p(v.position[0], v.position[1], v.position[2]);
    nearest = std::min(nearest, (p - frame.objects[0].X_WO.p).norm());
  }
  return radius - nearest;
}

TEST(AddThrow, TheBallDoesNotGoThroughTheHand) {
  constexpr double kRadius = 0.037;  // [m]
  struct Case {
    const char *hand, *style;
    double skin_gives;  // [m]
  };
  for (const auto& [hand, style, skin_gives] :
       {Case{"r_wrist", "underarm", 0.005}, Case{"l_wrist", "underarm", 0.005},
        Case{"r_wrist", "overarm", 0.008}, Case{"r_wrist", "push", 0.008}}) {
    for (const Vec3& spot : {Vec3(1.5, -0.4, 0.0), Vec3(2.2, 0.0, 0.0), Vec3(3.0, 0.8, 0.0),
                             Vec3(4.5, 0.0, 0.0), Vec3(1.8, -1.5, 0.5)}) {
      SCOPED_TRACE(std::string(style) + " by " + hand + ", " + std::to_string(spot.x()) +
                   " m ahead");
      Session session;
      Do(&session, "held.add_ball", {{"joint", hand}});
      Do(&session, "throw.add",
         {{"object", "ball"}, {"x", spot.x()}, {"y", spot.y()}, {"z", spot.z()}, {"style", style}});
      const FigureSkin skin = SkinOf(session.figure());
      const Motion& motion = ThrowMotion(&session);
      const auto let_go = std::find_if(motion.frames.begin(), motion.frames.end(),
                                       [](const auto& f) { return !f.objects[0].is_held(); });
      ASSERT_LT(let_go + 5, motion.frames.end());
      // Held it lies in the palm's flesh, from which it comes in the frame after.
      const double held = Depth(*let_go, kRadius, session.figure(), skin);
      EXPECT_LT(held, 0.012);
      EXPECT_LT(Depth(*(let_go + 1), kRadius, session.figure(), skin), held);
      for (int i = 1; i < 5; ++i) {
        EXPECT_LT(Depth(*(let_go + i), kRadius, session.figure(), skin), skin_gives) << i;
      }
    }
  }
}

}  // namespace
}  // namespace hazumi::test
