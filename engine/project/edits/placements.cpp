#include "engine/project/edits/placements.h"

#include <algorithm>
#include <utility>

#include "engine/project/edits/entries.h"

namespace hazumi {

namespace {

// Cuts the frames of a new span out of the others.
void CutOut(int first, int last, std::vector<ProjectPlacement>* spans) {
  std::vector<ProjectPlacement> kept;
  for (ProjectPlacement& span : *spans) {
    ProjectPlacement before = span, after = span;
    before.last_frame = std::min(span.last_frame, first);
    after.first_frame = std::max(span.first_frame, last);
    if (before.first_frame < before.last_frame) kept.push_back(before);
    if (after.first_frame < after.last_frame) kept.push_back(after);
  }
  *spans = std::move(kept);
}

}  // namespace

Result<Done> PutPlacement(ProjectPlacement span, bool is_said,
                          std::vector<ProjectPlacement>* spans) {
  if (span.first_frame >= span.last_frame) {
    return Refusal(
        "last", "must be later than the first frame, which is " + std::to_string(span.first_frame));
  }
  CutOut(span.first_frame, span.last_frame, spans);
  if (!is_said) return Done();
  const auto later = [](const ProjectPlacement& a, const ProjectPlacement& b) {
    return a.first_frame < b.first_frame;
  };
  spans->insert(std::upper_bound(spans->begin(), spans->end(), span, later), std::move(span));
  return Done();
}

}  // namespace hazumi
