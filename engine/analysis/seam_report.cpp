#include "engine/analysis/seam_report.h"

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

std::string Where(const Animation& animation, const Seam& seam) {
  const Figure& figure = *animation.figure;
  return "F" + std::to_string(seam.frame) + " " +
         (seam.joint.is_valid() ? figure.joint(seam.joint).name : figure.root_name()) + " (" +
         BorderText(animation, seam) + ")";
}

void Add(double jump, double from, const char* what, const char* unit, std::string* text) {
  if (std::abs(jump) < from) return;
  *text +=
      (text->empty() ? "" : ", ") + std::string(what) + " by " + FormatShort(jump) + " " + unit;
}

std::string JumpText(const Seam& seam) {
  std::string text;
  Add(seam.distance, kNoSeam, "position", "m", &text);
  Add(seam.angle / kDegree, kNoSeam, "angle", "deg", &text);
  Add(seam.speed, kNoSeam, "velocity", "m/s", &text);
  Add(seam.rate / kDegree, kNoSeam, "rate", "deg/s", &text);
  return text;
}

}  // namespace

std::string BorderText(const Animation& animation, const Seam& seam) {
  const std::string does = seam.begins ? " begins" : " ends";
  if (seam.of == SeamOf::kRegion) {
    return "region \"" + animation.regions[static_cast<size_t>(seam.index)].name + "\"" + does;
  }
  return NameOf(seam.of) + (" " + std::to_string(seam.index)) + does;
}

std::string MendText(SeamMend mend) {
  switch (mend) {
    case SeamMend::kNothing:
      return "";
    case SeamMend::kKeyRate:
      return "the key there states a rate: let the curve arrive with it, or leave it out";
    case SeamMend::kFriction:
      return "friction 0 stops it: give it more than 0";
    case SeamMend::kLimits:
      return "its limit stops it: turn it back before, or let the region begin sooner";
    case SeamMend::kKeyAfter:
      return "it has no key after it: give it one, or end later";
    case SeamMend::kTangents:
      return "\"limit_tangents\" slows it: let its next key be later or farther, or leave that out";
    case SeamMend::kCurve:
      return "its curve goes on with a rate of its own: make the key there cubic, without a rate";
    case SeamMend::kRest:
      return "it is to stand still from there on: let its keys bring it to rest";
  }
  return "";
}

double SizeOf(const Seam& seam) {
  constexpr double kShown = 30.0;  // [1/s]
  return std::max(
      {std::abs(seam.rate), seam.speed, kShown * std::abs(seam.angle), kShown * seam.distance});
}

std::vector<std::string> SeamReport(const Animation& animation, const std::vector<Seam>& seams,
                                    size_t most) {
  if (seams.empty()) return {};
  std::vector<const Seam*> sorted;
  sorted.reserve(seams.size());
  for (const Seam& seam : seams) sorted.push_back(&seam);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Seam* a, const Seam* b) { return SizeOf(*a) > SizeOf(*b); });
  std::vector<std::string> lines;
  for (const Seam* seam : sorted) {
    if (lines.size() == most || SizeOf(*seam) < kNoSeam) break;
    const std::string mend = MendText(seam->mend);
    lines.push_back(Where(animation, *seam) + ": " + JumpText(*seam) +
                    (mend.empty() ? "" : "; " + mend));
  }
  if (!lines.empty()) return lines;
  const auto bend = [](const Seam& seam) {
    return std::max(std::abs(seam.acceleration), seam.push);
  };
  const Seam& hardest =
      **std::max_element(sorted.begin(), sorted.end(),
                         [&](const Seam* a, const Seam* b) { return bend(*a) < bend(*b); });
  std::string text;
  Add(hardest.push, kNoSeam, "acceleration", "m/s^2", &text);
  Add(hardest.acceleration / kDegree, kNoSeam, "acceleration", "deg/s^2", &text);
  if (text.empty()) return {"none"};
  return {"none in position or rate; the largest, " + Where(animation, hardest) + ": " + text};
}

}  // namespace hazumi
