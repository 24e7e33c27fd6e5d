#include "tests/bench/mujoco_ball_model.h"

#include "engine/base/assert.h"
#include "engine/base/text.h"
#include "tests/bench/subject.h"
#include "tests/support/mujoco_figure.h"

namespace hazumi::bench {

namespace {

std::string Attribute(const char* name, const Vec3& x) {
  return std::string(" ") + name + "=\"" + FormatNumber(x.x()) + " " + FormatNumber(x.y()) + " " +
         FormatNumber(x.z()) + "\"";
}

std::string Body(const Figure& figure, const JointGroup& group) {
  const Joint& first = figure.joint(group.first);
  const RigidInertia& body = figure.body(group.last());
  HAZUMI_DEMAND(first.parallel_frame && body.I_com.isDiagonal(1e-14));
  std::string text = "<body" + Attribute("pos", first.X_PJ.p) + "><inertial mass=\"" +
                     FormatNumber(body.mass) + "\"" + Attribute("pos", body.com) +
                     Attribute("diaginertia", body.I_com.diagonal()) + "/>";
  if (group.size == 3) text += "<joint type=\"ball\"/>";
  for (int h = 0; h < group.size && group.size < 3; ++h) {
    const Vec3& axis = figure.joints()[group.first.value() + h].axis;
    text += "<joint type=\"hinge\"" + Attribute("axis", axis) + "/>";
  }
  for (const JointGroup& child : figure.groups()) {
    if (figure.joint(child.first).parent == group.last()) text += Body(figure, child);
  }
  return text + "</body>\n";
}

std::string Mjcf(const Figure& figure) {
  std::string text = "<mujoco><option" + Attribute("gravity", Vec3(0, 0, -kGravity)) +
                     "><flag constraint=\"disable\" contact=\"disable\" passive=\"disable\" "
                     "actuation=\"disable\" warmstart=\"disable\" sensor=\"disable\"/></option>\n"
                     "<size njmax=\"1\" nconmax=\"1\"/><worldbody>\n";
  for (const JointGroup& group : figure.groups()) {
    if (!figure.joint(group.first).parent.is_valid()) text += Body(figure, group);
  }
  return text + "</worldbody></mujoco>\n";
}

}  // namespace

std::shared_ptr<mjModel> LoadMujocoModelWithBalls(const Figure& figure) {
  return test::LoadMujocoModel(Mjcf(figure));
}

}  // namespace hazumi::bench
