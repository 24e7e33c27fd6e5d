#include "render/motion/figure_skin.h"

#include <utility>

namespace hazumi::render {
namespace {

const BodyScratch& BodyIn(const DynamicsWorkspace& ws, JointIndex j) {
  return j.is_valid() ? ws.body(j) : ws.bodies[0];
}

Pose PoseOf(const Figure& figure, const FigureBone& bone, const VecX& q,
            const DynamicsWorkspace& ws) {
  const BodyScratch& body = BodyIn(ws, bone.body);
  if (bone.is_body) return {body.R, body.p};
  const JointGroup& group = figure.group(figure.joint(bone.body).group);
  const BodyScratch& before = BodyIn(ws, figure.joint(group.first).parent);
  return {before.R * TurnOf(figure, bone, q), body.p};
}

}  // namespace

std::vector<Pose> FigureSkin::PosesIn(const Figure& figure, const VecX& q,
                                      const DynamicsWorkspace& ws) const {
  std::vector<Pose> poses;
  for (const FigureBone& bone : bones) poses.push_back(PoseOf(figure, bone, q, ws));
  return poses;
}

Result<FigureSkin> PutOn(const Figure& figure, std::shared_ptr<const SkinModel> model) {
  FigureSkin skin;
  for (const SkinBone& bone : model->skin->bones) {
    const std::optional<FigureBone> found = FindBone(figure, bone);
    if (!found) {
      return Error{ErrorCode::kSemantics, "", "skin.bones",
                   "the figure \"" + figure.name() + "\" has no joint \"" + bone.joint +
                       "\"; rename the joint back, or import the character anew"};
    }
    skin.bones.push_back(*found);
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
