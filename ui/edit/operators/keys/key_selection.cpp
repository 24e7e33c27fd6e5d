// Which keys are selected.

#include <cmath>

#include "engine/base/text.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kMode = {"mode", kText, false,
                             "replace (what was selected), add, remove or toggle",
                             "replace add remove toggle"};
const ParameterInfo kCurves = {"curves", kNames, false, "only these curves; not given: all",
                               Thing::kCurve};

// What becomes of the selected keys when `chosen` ones are named.
Result<Done> Combine(Session* session, const std::string& mode, const KeySelection& chosen) {
  if (mode != "replace" && mode != "add" && mode != "remove" && mode != "toggle") {
    return Refusal("mode", "\"" + mode + "\" is none of replace, add, remove, toggle");
  }
  KeySelection keys;
  if (mode != "replace") keys = session->selected_keys();
  for (const auto& [curve, frames] : chosen) {
    std::set<double>& selected = keys[curve];
    for (const double frame : frames) {
      const bool removes = mode == "remove" || (mode == "toggle" && selected.contains(frame));
      removes ? (void)selected.erase(frame) : (void)selected.insert(frame);
    }
  }
  session->set_selected_keys(std::move(keys));
  return Done();
}

Result<Done> Select(Session* session, const Parameters& p) {
  const std::vector<std::string> curves = p.names("curves");
  const std::vector<double> frames = p.numbers("frames");
  if (curves.size() != frames.size()) {
    return Refusal("frames", "there are " + std::to_string(frames.size()) + " for " +
                                 std::to_string(curves.size()) + " curves; give one for each");
  }
  KeySelection chosen;
  for (size_t i = 0; i < curves.size(); ++i) chosen[curves[i]].insert(frames[i]);
  KeySelection there = chosen;
  DropMissing(session->project(), &there);
  for (const auto& [curve, of_curve] : chosen) {
    for (const double frame : of_curve) {
      if (Contains(there, curve, frame)) continue;
      return Refusal("frames", "\"" + curve + "\" has no key on frame " + FormatShort(frame));
    }
  }
  return Combine(session, p.text("mode", "replace"), chosen);
}

// The keys of the curves asked for on frames that are.
template <typename IsChosen>
Result<Done> SelectOnFrames(Session* session, const Parameters& p, IsChosen is_chosen) {
  KeySelection chosen;
  const std::vector<std::string> names =
      p.has("curves") ? p.names("curves") : CurveNames(session->project());
  for (const std::string& name : names) {
    const ProjectCurve* curve = FindCurve(name, session->project());
    if (!curve) return Refusal("curves", "there is no curve \"" + name + "\" with keys");
    for (const ProjectKey& key : curve->keys) {
      if (is_chosen(key.frame)) chosen[name].insert(key.frame);
    }
  }
  return Combine(session, p.text("mode", "replace"), chosen);
}

Result<Done> SelectAll(Session* session, const Parameters& p) {
  return SelectOnFrames(session, p, [](double) { return true; });
}

Result<Done> SelectColumn(Session* session, const Parameters& p) {
  std::set<double> columns;
  if (p.has("frame")) columns.insert(p.number("frame"));
  for (const auto& [curve, frames] : session->selected_keys()) {
    if (!p.has("frame")) columns.insert(frames.begin(), frames.end());
  }
  if (columns.empty()) return Refusal("frame", "no key is selected; select one or give a frame");
  return SelectOnFrames(session, p, [&](double frame) { return columns.contains(frame); });
}

Result<Done> SelectSide(Session* session, const Parameters& p) {
  const std::string side = p.text("side");
  if (side != "before" && side != "after") {
    return Refusal("side", "\"" + side + "\" is none of before, after");
  }
  const double from = p.number("frame", session->frame());
  return SelectOnFrames(
      session, p, [&](double frame) { return side == "before" ? frame <= from : frame >= from; });
}

}  // namespace

std::vector<Operator> KeySelectionOperators() {
  return {
      {"keys.select",
       "Select keys",
       "Selects keys, each by its curve and frame.",
       {{"curves", kNames, true, "of each key its curve; none of them: no key"},
        {"frames", kNumbers, true, "of each key its frame, in the same order"},
        kMode},
       Select},
      {"keys.select_all", "Select all keys", "Selects all keys.", {kCurves, kMode}, SelectAll},
      {"keys.select_column",
       "Select column of keys",
       "Selects all keys on a frame, or on the frames of the selected keys.",
       {{"frame", kNumber, false, "not given: the frames of the selected keys"}, kCurves, kMode},
       SelectColumn},
      {"keys.select_side",
       "Select keys before or after",
       "Selects all keys on one side of a frame, and on it.",
       {{"side", kText, true, "before or after", "before after"},
        {"frame", kNumber, false, "not given: the current frame"},
        kCurves,
        kMode},
       SelectSide}};
}

}  // namespace hazumi::edit
