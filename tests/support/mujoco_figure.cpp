#include "tests/support/mujoco_figure.h"

#include <mujoco/mujoco.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cstring>

#include "engine/base/assert.h"
#include "engine/base/text.h"

namespace hazumi::test {

namespace {

std::string Numbers(const Eigen::Ref<const VecX>& x) {
  std::string text;
  for (const double value : x) text += (text.empty() ? "" : " ") + FormatNumber(value);
  return text;
}

std::string Attribute(const char* name, const Eigen::Ref<const VecX>& x) {
  return std::string(" ") + name + "=\"" + Numbers(x) + "\"";
}

std::string Quaternion(const Mat3& R) {
  const Eigen::Quaterniond q(R);
  return Attribute("quat", Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
}

// MuJoCo's own diagonalisation of a full inertia stops at 1e-12 kg m^2; this one does not.
std::string Inertial(const RigidInertia& body) {
  if (body.is_massless()) return "";
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(body.I_com);
  Mat3 R = principal.eigenvectors();
  if (R.determinant() < 0.0) R.col(2) = -R.col(2);
  return "<inertial mass=\"" + FormatNumber(body.mass) + "\"" + Attribute("pos", body.com) +
         Quaternion(R) + Attribute("diaginertia", principal.eigenvalues()) + "/>";
}

std::string JointElement(const char* type, const Vec3& axis) {
  return std::string("<joint type=\"") + type + "\"" + Attribute("axis", axis) + "/>";
}

std::string BodyStart(const Pose& X_PB) {
  return "<body" + Attribute("pos", X_PB.p) + Quaternion(X_PB.R) + ">";
}

std::string GroupElement(const Figure& figure, const JointGroup& group);

std::string ChildElements(const Figure& figure, JointIndex parent) {
  std::string text;
  for (const JointGroup& group : figure.groups()) {
    if (figure.joint(group.first).parent == parent) text += GroupElement(figure, group);
  }
  return text;
}

std::string GroupElement(const Figure& figure, const JointGroup& group) {
  std::string text =
      BodyStart(figure.joint(group.first).X_PJ) + Inertial(figure.body(group.last()));
  for (int h = 0; h < group.size; ++h) {
    text += JointElement("hinge", figure.joints()[group.first.value() + h].axis);
  }
  return text + ChildElements(figure, group.last()) + "</body>\n";
}

std::string Mjcf(const Figure& figure, const Pose& X_WR, const std::string& root_joints,
                 const Vec3& gravity) {
  return "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\" boundmass=\"0\" "
         "boundinertia=\"0\" balanceinertia=\"false\"/>\n<option" +
         Attribute("gravity", gravity) +
         "><flag constraint=\"disable\" contact=\"disable\" passive=\"disable\" "
         "actuation=\"disable\" warmstart=\"disable\" sensor=\"disable\"/></option>\n"
         "<size njmax=\"1\" nconmax=\"1\"/><worldbody>\n" +
         BodyStart(X_WR) + Inertial(figure.root_body()) + root_joints +
         ChildElements(figure, JointIndex()) + "</body></worldbody></mujoco>\n";
}

std::string RootJoints() {
  std::string text;
  for (const char* type : {"slide", "hinge"}) {
    for (int i = 0; i < 3; ++i) text += JointElement(type, Vec3::Unit(i));
  }
  return text;
}

}  // namespace

MujocoFigure::MujocoFigure(const Figure& figure, const Pose& X_WR, const Vec3& gravity)
    : figure_(figure), root_dof_(0) {
  Load(Mjcf(figure, X_WR, "", gravity));
}

MujocoFigure::MujocoFigure(const Figure& figure, const Vec3& gravity)
    : figure_(figure), root_dof_(kRootDof) {
  Load(Mjcf(figure, Pose(), RootJoints(), gravity));
}

void MujocoFigure::Load(const std::string& mjcf) {
  model_ = LoadMujocoModel(mjcf);
  HAZUMI_DEMAND_EQ(model_->nv, root_dof_ + figure_.num_joints());
  data_.reset(mj_makeData(model_.get()), mj_deleteData);
}

std::shared_ptr<mjModel_> LoadMujocoModel(const std::string& mjcf) {
  constexpr char kName[] = "figure.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(mjcf.size()));
  std::memcpy(files->filedata[0], mjcf.data(), mjcf.size());
  char error[500] = "";
  const std::shared_ptr<mjModel> model(mj_loadXML(kName, files.get(), error, sizeof error),
                                       mj_deleteModel);
  mj_deleteVFS(files.get());
  if (model == nullptr) std::fprintf(stderr, "MuJoCo: %s\n%s", error, mjcf.c_str());
  HAZUMI_DEMAND(model != nullptr);
  return model;
}

int MujocoFigure::size() const { return model_->nv; }

int MujocoFigure::BodyOf(JointIndex j) const { return model_->jnt_bodyid[root_dof_ + j.value()]; }

VecX MujocoFigure::Join(const Vec3& translation, const Vec3& angles, const VecX& joints) {
  VecX all(kRootDof + joints.size());
  all << translation, angles, joints;
  return all;
}

void MujocoFigure::SetState(const VecX& q, const VecX& qd) {
  mju_copy(data_->qpos, q.data(), size());
  mju_copy(data_->qvel, qd.data(), size());
  mju_zero(data_->qfrc_applied, size());
  mj_forward(model_.get(), data_.get());
}

VecX MujocoFigure::InverseDynamics(const VecX& qdd, const EndForces* ends) {
  mju_copy(data_->qacc, qdd.data(), size());
  mj_inverse(model_.get(), data_.get());
  VecX tau = Eigen::Map<const VecX>(data_->qfrc_inverse, size());
  if (ends != nullptr) tau -= EndForceTorques(*ends);
  return tau;
}

VecX MujocoFigure::Bias() const { return Eigen::Map<const VecX>(data_->qfrc_bias, size()); }

MatX MujocoFigure::InertiaMatrix() const {
  MatX H(size(), size());
  mj_fullM(model_.get(), H.data(), data_->qM);
  return H;
}

VecX MujocoFigure::ForwardDynamics(const VecX& tau, const EndForces* ends) {
  VecX applied = tau;
  if (ends != nullptr) applied += EndForceTorques(*ends);
  mju_copy(data_->qfrc_applied, applied.data(), size());
  mj_forward(model_.get(), data_.get());
  return Eigen::Map<const VecX>(data_->qacc, size());
}

VecX MujocoFigure::EndForceTorques(const EndForces& ends) {
  VecX tau = VecX::Zero(size());
  int end = 0;
  for (const JointIndex j : EndJoints(figure_)) {
    mj_applyFT(model_.get(), data_.get(), ends.Kf.col(end).data(), ends.Kn.col(end).data(),
               data_->xpos + 3 * BodyOf(j), BodyOf(j), tau.data());
    ++end;
  }
  return tau;
}

VecX MujocoFigure::PointForce(JointIndex j, const Vec3& p, const Vec3& force) {
  constexpr int kRootBody = 1;
  const double none[3] = {};
  VecX generalized = VecX::Zero(size());
  mj_applyFT(model_.get(), data_.get(), force.data(), none, p.data(),
             j.is_valid() ? BodyOf(j) : kRootBody, generalized.data());
  return generalized;
}

Mat3 MujocoFigure::RootAxes() const {
  HAZUMI_DEMAND_EQ(root_dof_, kRootDof);
  Mat3 axes;
  for (int i = 0; i < 3; ++i) axes.row(i) = Eigen::Map<const Vec3>(data_->xaxis + 3 * (3 + i));
  return axes;
}

Eigen::Matrix3Xd MujocoFigure::OriginJacobian(JointIndex j) const {
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> J(3, size());
  mj_jac(model_.get(), data_.get(), J.data(), nullptr, data_->xpos + 3 * BodyOf(j), BodyOf(j));
  return J;
}

Vec3 MujocoFigure::OriginBiasAcceleration(JointIndex j) {
  mju_zero(data_->qacc, size());
  mj_rnePostConstraint(model_.get(), data_.get());
  double acceleration[6];  // angular first; MuJoCo counts gravity as an acceleration upwards
  mj_objectAcceleration(model_.get(), data_.get(), mjOBJ_XBODY, BodyOf(j), acceleration, 0);
  return Eigen::Map<const Vec3>(acceleration + 3) + Eigen::Map<const Vec3>(model_->opt.gravity);
}

}  // namespace hazumi::test
