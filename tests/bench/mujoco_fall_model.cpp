#include "tests/bench/mujoco_fall_model.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "engine/base/assert.h"
#include "engine/base/text.h"
#include "tests/bench/subject.h"
#include "tests/support/mujoco_figure.h"

namespace hazumi::bench {

namespace {

std::string Attribute(const char* name, const Eigen::Ref<const VecX>& x) {
  std::string text = std::string(" ") + name + "=\"";
  for (const double value : x) text += FormatNumber(value) + " ";
  text.back() = '"';
  return text;
}

std::string Turned(const Mat3& R) {
  const Eigen::Quaterniond q(R);
  return Attribute("quat", Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
}

std::string Inertial(const RigidInertia& body) {
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(body.I_com);
  Mat3 R = principal.eigenvectors();
  if (R.determinant() < 0.0) R.col(2) = -R.col(2);
  return "<inertial mass=\"" + FormatNumber(body.mass) + "\"" + Attribute("pos", body.com) +
         Turned(R) + Attribute("diaginertia", principal.eigenvalues()) + "/>";
}

// What the floor touches of a body: the capsules of its links.
std::string Geoms(const Figure& figure, JointIndex joint) {
  std::string text;
  for (const Link& link : figure.links()) {
    if (link.joint != joint) continue;
    const Capsule& capsule = link.capsule;
    Eigen::Matrix<double, 6, 1> ends;
    ends << capsule.a, capsule.b;
    const bool is_ball = (capsule.b - capsule.a).norm() < 1e-9;
    text += std::string("<geom type=\"") + (is_ball ? "sphere\"" : "capsule\"") +
            (is_ball ? Attribute("pos", capsule.a) : Attribute("fromto", ends)) + " size=\"" +
            FormatNumber(capsule.radius) +
            "\" contype=\"0\" conaffinity=\"1\" friction=\"0.8 0.005 0.0001\"/>";
  }
  return text;
}

std::string Children(const Figure& figure, JointIndex parent);

std::string Group(const Figure& figure, const JointGroup& group) {
  const Pose& X_PJ = figure.joint(group.first).X_PJ;
  std::string text = "<body" + Attribute("pos", X_PJ.p) + Turned(X_PJ.R) + ">" +
                     Inertial(figure.body(group.last()));
  for (int j = group.first.value(); j <= group.last().value(); ++j) {
    const Joint& joint = figure.joints()[j];
    text += "<joint type=\"hinge\" limited=\"true\"" + Attribute("axis", joint.axis) +
            Attribute("range", Eigen::Vector2d(joint.lower, joint.upper)) + "/>";
  }
  return text + Geoms(figure, group.last()) + Children(figure, group.last()) + "</body>\n";
}

std::string Children(const Figure& figure, JointIndex parent) {
  std::string text;
  for (const JointGroup& group : figure.groups()) {
    if (figure.joint(group.first).parent == parent) text += Group(figure, group);
  }
  return text;
}

std::string Mjcf(const Figure& figure) {
  return "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n<option" +
         Attribute("gravity", Vec3(0.0, 0.0, -kGravity)) +
         "/><worldbody>\n<geom type=\"plane\" size=\"10 10 1\" contype=\"1\" conaffinity=\"0\" "
         "friction=\"0.8 0.005 0.0001\"/>\n<body><freejoint/>" +
         Inertial(figure.root_body()) + Geoms(figure, JointIndex()) +
         Children(figure, JointIndex()) + "</body></worldbody></mujoco>\n";
}

}  // namespace

std::shared_ptr<mjModel> LoadMujocoFall(const Figure& figure) {
  std::shared_ptr<mjModel> model = test::LoadMujocoModel(Mjcf(figure));
  HAZUMI_DEMAND_EQ(model->nv, 6 + figure.num_joints());
  return model;
}

}  // namespace hazumi::bench
