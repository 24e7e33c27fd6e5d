#include "engine/analysis/loaded_figure.h"

#include "engine/bake/pose/held_objects.h"

namespace hazumi {

namespace {

std::vector<int> HoldersAt(const MotionFrame& frame) {
  std::vector<int> holders;
  for (const ObjectPose& object : frame.objects) holders.push_back(object.holder);
  return holders;
}

Figure With(const Animation& animation, const std::vector<int>& holders) {
  Figure figure = *animation.figure;
  for (size_t i = 0; i < holders.size(); ++i) {
    figure = WithObject(figure, animation.held_objects[i], holders[i]);
  }
  return figure;
}

}  // namespace

LoadedFigure::LoadedFigure(const Animation& animation, const MotionFrame& frame)
    : holders_(HoldersAt(frame)),
      figure_(With(animation, holders_)),
      dynamics_(figure_),
      scratch_(dynamics_.MakeScratch()) {}

bool LoadedFigure::IsThatOf(const MotionFrame& frame) const { return holders_ == HoldersAt(frame); }

Wrench LoadedFigure::Demand(const MotionLimit& at, RootMotion root, const VecX& qdd, double gravity,
                            VecX* tau) {
  root.a.z() += gravity;
  tau->resize(figure_.num_joints());
  dynamics_.InverseDynamics(at.X_WR, root, at.q, at.qd, qdd, nullptr, &scratch_, tau);
  return dynamics_.RootWrench(at.X_WR, root, scratch_);
}

// tau_i -= axis_i . (n + (p - p_i) x f)
void RelieveHinges(const Figure& figure, const PlacedFrame& placed, JointIndex joint, const Vec3& p,
                   const Wrench& push, VecX* tau) {
  for (JointIndex j = joint; j.is_valid(); j = figure.joint(j).parent) {
    (*tau)[j.value()] -= placed.axis(j).dot(push.moment + (p - placed.p(j)).cross(push.force));
  }
}

}  // namespace hazumi
