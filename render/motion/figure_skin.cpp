#include "render/motion/figure_skin.h"

#include <utility>

namespace hazumi::render {
namespace {

std::optional<JointIndex> FindBody(const Figure& figure, const std::string& name) {
  if (name == figure.root_name()) return JointIndex();
  if (const auto joint = figure.FindJoint(name)) return joint;
  const auto group = figure.FindGroup(name);
  return group ? std::optional(figure.group(*group).last()) : std::nullopt;
}

}  // namespace

std::vector<Pose> FigureSkin::PosesIn(const DynamicsWorkspace& ws) const {
  std::vector<Pose> poses;
  for (const JointIndex j : bodies) {
    const BodyScratch& body = j.is_valid() ? ws.body(j) : ws.bodies[0];
    poses.push_back({body.R, body.p});
  }
  return poses;
}

Result<FigureSkin> PutOn(const Figure& figure, std::shared_ptr<const SkinModel> model) {
  FigureSkin skin;
  for (const std::string& bone : model->skin->bones) {
    const std::optional<JointIndex> body = FindBody(figure, bone);
    if (!body) {
      return Error{ErrorCode::kSemantics, "", "skin.bones",
                   "the figure \"" + figure.name() + "\" has no joint \"" + bone +
                       "\"; rename the joint back, or import the character anew"};
    }
    skin.bodies.push_back(*body);
  }
  skin.model = std::move(model);
  return skin;
}

Result<FigureSkin> SkinCache::On(const Figure& figure, const std::shared_ptr<const Skin>& skin) {
  if (skin == nullptr) {
    model_.reset();
    return FigureSkin();
  }
  if (model_ == nullptr || model_->skin != skin) {
    model_.reset();
    Result<std::shared_ptr<const SkinModel>> model = MakeSkinModel(skin);
    if (!model.ok()) return model.error();
    model_ = std::move(model).value();
    warnings_ = model_->warnings;
  }
  return PutOn(figure, model_);
}

}  // namespace hazumi::render
