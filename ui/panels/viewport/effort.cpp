#include "ui/panels/viewport/effort.h"

#include <algorithm>
#include <cmath>

#include "engine/base/filled.h"
#include "ui/panels/viewport/scene.h"

namespace hazumi::ui {

namespace {

constexpr float kTintShare = 0.8f;
constexpr SrgbColor kNone = render::FromHex(0x2f9e44), kHalf = render::FromHex(0xf2c037),
                    kAll = render::FromHex(0xe03131), kBeyond = render::FromHex(0x86108a);

SrgbColor Between(const SrgbColor& a, const SrgbColor& b, float t) {
  return {std::lerp(a.r, b.r, t), std::lerp(a.g, b.g, t), std::lerp(a.b, b.b, t), a.a};
}

double ShareOf(const FrameEffort& effort, const JointGroup& joint) {
  return LargestShare(effort, joint.first, joint.size);
}

// The effort may be of a figure that is no more.
bool IsOf(const FrameEffort& effort, const Figure& figure) {
  return effort.share.size() == figure.num_joints();
}

}  // namespace

SrgbColor EffortColor(double share) {
  const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
  if (share > 1.0) return kBeyond;
  return s < 0.5f ? Between(kNone, kHalf, 2.0f * s) : Between(kHalf, kAll, 2.0f * s - 1.0f);
}

std::vector<render::BoneTint> EffortTints(const Figure& figure, const FrameEffort& effort) {
  std::vector<render::BoneTint> tints(static_cast<size_t>(figure.num_joints()),
                                      render::BoneTint{0.0f, 0.0f, 0.0f, 0.0f});
  if (!IsOf(effort, figure)) return tints;
  for (const JointGroup& joint : figure.groups()) {
    const double share = ShareOf(effort, joint);
    if (share < 0.0) continue;
    render::BoneTint tint = EffortColor(share);
    tint.a = kTintShare;
    std::fill_n(tints.begin() + joint.first.value(), joint.size, tint);
  }
  return tints;
}

std::vector<EffortMark> EffortMarks(const Figure& figure, const FrameEffort& effort) {
  std::vector<EffortMark> marks;
  if (!IsOf(effort, figure)) return marks;
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    const double share = ShareOf(effort, figure.group(GroupIndex(g)));
    if (share > 1.0) marks.push_back({GroupIndex(g), share});
  }
  return marks;
}

std::string EffortText(const Figure& figure, const EffortWatch& effort, int frame) {
  if (!HasStrengths(figure)) return Tr("How strong this figure is, is not known");
  const FrameEffort* at = effort.At(frame);
  if (!at || !IsOf(*at, figure)) {
    return effort.is_busy() ? Tr("Torques are being computed") : Tr("No torques are known");
  }
  Eigen::Index hardest = 0;
  const double share = at->share.maxCoeff(&hardest);
  const Joint& hinge = figure.joints()[static_cast<size_t>(hardest)];
  return Filled(Tr("Effort: most at %s, %.0f %%"), figure.group(hinge.group).name.c_str(),
                100.0 * share);
}

std::string EffortOfJoint(const Editor& editor, GroupIndex joint) {
  if (!editor.viewport.overlays.effort) return "";
  const Figure& figure = editor.session().figure();
  const FrameEffort* at = editor.effort.At(FrameShown(editor));
  if (!at || !IsOf(*at, figure)) return "";
  const double share = ShareOf(*at, figure.group(joint));
  return share < 0.0 ? "" : Filled(Tr("%.0f %% of its strength"), 100.0 * share);
}

}  // namespace hazumi::ui
