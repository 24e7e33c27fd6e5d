#include "tests/unit/exchange/mass_oracle.h"

#include <regex>
#include <utility>
#include <vector>

namespace hazumi::test {
namespace {

// The first that is found in a name counts. Written down bone by bone from the hierarchies of the
// files and of the made skeletons.
const std::vector<std::pair<std::string, std::regex>>& Spellings() {
  static const std::vector<std::pair<std::string, std::regex>> spellings = {
      {"head and neck",
       std::regex("^(lower|upper)?neck|^Neck|^neck_|^[Hh]ead|^(left|right)Eye$|HeadNub|Helmet")},
      {"trunk",
       std::regex(
           "^(L|R|l|r)(HipJoint|hipjoint|Buttock)$|^(l|r)Collar$|^(l|r)clavicle$|^clavicle_")},
      {"trunk",
       std::regex("^(Left|Right)(Shoulder|Collar)$|^(Left|Right)HipJoint$|^shoulder\\.[LR]$")},
      {"trunk",
       std::regex("Footsteps|^[Hh]ips?$|^[Pp]elvis$|^[Ss]pine|^chest$|^thorax$|^abdomen$")},
      {"trunk", std::regex("^(lowerback|upperback|LowerBack)$|Cape|^root$|^breast")},
      {"foot", std::regex("[Ff]oot|[Tt]oe|Ankle$|^ball_")},
      {"hand",
       std::regex(
           "[Hh]and|[Ww]rist|[Ff]inger|Thumb[0-9]?$|thumb$|(Index|Mid|Ring|Pinky)[12]$|^index_")},
      {"forearm", std::regex("[Ff]ore[Aa]rm|radius$|^lowerarm|Elbow$")},
      {"upper arm", std::regex("Shldr$|humerus$|^upperarm|^upper_arm|^(Left|Right)Arm|UpArm$")},
      {"thigh", std::regex("UpLeg|femur$|[Tt]high|^upperleg")},
      {"shank", std::regex("^(Left|Right)Leg|tibia$|Shin$|^shin|^lowerleg|^calf|Knee$")}};
  return spellings;
}

const std::string kAcclaim = "(femur|tibia|foot|toes|humerus|radius|wrist|hand|fingers|thumb)";

std::string SideByHand(const std::string& bone) {
  static const std::regex left("^(Left|L[A-Z]|Bip01L)|[._][lL]$|^l([A-Z]|" + kAcclaim + ")");
  static const std::regex right("^(Right|R[A-Z]|Bip01R)|[._][rR]$|^r([A-Z]|" + kAcclaim + ")");
  if (std::regex_search(bone, left)) return " L";
  return std::regex_search(bone, right) ? " R" : "";
}

}  // namespace

std::string SegmentByHand(const std::string& bone) {
  for (const auto& [segment, words] : Spellings()) {
    if (!std::regex_search(bone, words)) continue;
    const bool is_pair = segment != "trunk" && segment != "head and neck";
    return is_pair ? segment + SideByHand(bone) : segment;
  }
  return "";
}

std::map<std::string, double> SharesOf(const FigureSpec& figure) {
  std::map<std::string, std::string> segments = {{figure.root_name, "trunk"}};
  std::map<std::string, double> shares;
  double sum = 0.0;
  const auto add = [&](const std::string& segment, const std::vector<LinkSpec>& links) {
    for (const LinkSpec& link : links) {
      shares[segment] += *link.mass;
      sum += *link.mass;
    }
  };
  add("trunk", figure.root_links);
  for (const JointSpec& joint : figure.joints) {
    const std::string own = SegmentByHand(joint.name);
    const std::string segment = own.empty() ? segments[joint.parent] : own;
    segments[joint.name] = segment;
    add(segment, joint.links);
  }
  for (auto& [segment, share] : shares) share *= 100.0 / sum;
  return shares;
}

}  // namespace hazumi::test
