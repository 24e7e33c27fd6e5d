// Keys of curves. Values are degrees, of root positions metres; rates are per second.

#include <algorithm>

#include "engine/base/text.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kCurve = {"curve", kText, true, "a hinge, or root.x to root.angle_x",
                              Thing::kCurve};
const ParameterInfo kFrame = {"frame", kNumber, true, "the key's frame"};

Error NoKey(const std::string& curve, double frame) {
  return Refusal("frame", "\"" + curve + "\" has no key on frame " + FormatShort(frame));
}

// The curve and its key, by the parameters "curve" and "frame".
struct Place {
  ProjectCurve* curve;
  ProjectKey* key;
};
Result<Place> PlaceOf(const Parameters& p, const Figure& figure, Project* project) {
  const Result<ProjectCurve*> curve = CurveNamed(p.text("curve"), figure, project);
  if (!curve.ok()) return curve.error();
  ProjectKey* key = KeyOn(p.number("frame"), curve.value());
  if (!key) return NoKey(p.text("curve"), p.number("frame"));
  return Place{curve.value(), key};
}

// What is not given stays as it is at a key on the frame.
Result<Done> SetKey(Session* session, const Parameters& p) {
  return session->Edit(
      "Set key",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectCurve*> curve = CurveNamed(p.text("curve"), session->figure(), project);
        if (!curve.ok()) return curve.error();
        ProjectKey key = KeyToChange(p.number("frame"), *curve.value());
        if (Result<Done> set = SetFields(p, &key); !set.ok()) return set;
        if (p.yes("auto_rate")) SetAutomatic(&key);
        PutKey(key, curve.value());
        return Done();
      },
      p.text("drag"));
}

// Both sides of the key, unless one of them is given or it is broken already.
Result<Done> SetTangent(const Parameters& p, ProjectKey* key) {
  const std::string side = p.text("side");
  if (!side.empty() && side != "before" && side != "after") {
    return Refusal("side", "\"" + side + "\" is none of before, after");
  }
  if (side == "before" && key->rate_in) {
    key->rate_in = p.number("rate");
  } else {
    key->rate = p.number("rate");
    if (side.empty()) key->rate_in.reset();
  }
  if (!p.has("length")) return Done();
  if (side.empty()) return Refusal("side", "say whose length it is: before or after");
  const double length = p.number("length");
  if (length < kTangentLength.lower || length > kTangentLength.upper) {
    return Refusal("length", "must be between " + FormatShort(kTangentLength.lower) + " and " +
                                 FormatShort(kTangentLength.upper));
  }
  (side == "before" ? key->length_in : key->length_out) = length;
  return Done();
}

Result<Done> SetKeyRate(Session* session, const Parameters& p) {
  return session->Edit(
      "Set rate of key",
      [&](Project* project) -> Result<Done> {
        const Result<Place> place = PlaceOf(p, session->figure(), project);
        if (!place.ok()) return place.error();
        return SetTangent(p, place.value().key);
      },
      p.text("drag"));
}

// On the curves that are chosen and have one there.
Result<Done> DeleteKey(Session* session, const Parameters& p) {
  const double frame = p.number("frame", session->frame());
  const std::vector<std::string> names =
      p.has("curve") ? std::vector{p.text("curve")} : ChosenCurves(*session, p);
  return session->Edit("Delete key", [&](Project* project) -> Result<Done> {
    size_t count = 0;
    for (const std::string& name : names) {
      if (!p.has("curve") && !FindCurve(name, *project)) continue;
      const Result<ProjectCurve*> curve = CurveNamed(name, session->figure(), project);
      if (!curve.ok()) return curve.error();
      count += std::erase_if(curve.value()->keys,
                             [&](const ProjectKey& key) { return key.frame == frame; });
    }
    if (count > 0) return Done();
    if (p.has("curve")) return NoKey(p.text("curve"), frame);
    const bool is_part = !session->selected_joints().empty();
    return Refusal(
        "frame", (is_part ? "what is selected has no key on frame " : "there is no key on frame ") +
                     FormatShort(frame));
  });
}

// Onto another key: it takes its place.
Result<Done> MoveKey(Session* session, const Parameters& p) {
  return session->Edit(
      "Move key",
      [&](Project* project) -> Result<Done> {
        const Result<Place> place = PlaceOf(p, session->figure(), project);
        if (!place.ok()) return place.error();
        ProjectKey key = *place.value().key;
        auto& keys = place.value().curve->keys;
        keys.erase(keys.begin() + (place.value().key - keys.data()));
        key.frame = p.number("to", key.frame);
        key.value += p.number("by");
        PutKey(key, place.value().curve);
        return Done();
      },
      p.text("drag"));
}

// The keys from one frame to another are moved and stretched in time: first and last come to lie on
// two other frames. Keys that lay in their way give way.
Result<Done> RetimeKeys(Session* session, const Parameters& p) {
  const double first = p.number("first"), last = p.number("last");
  const double to_first = p.number("to_first"), to_last = p.number("to_last");
  if (first > last || to_first > to_last || (first == last) != (to_first == to_last)) {
    return Refusal("first", "first must come before last, and to_first before to_last");
  }
  const double scale = first == last ? 1.0 : (to_last - to_first) / (last - first);
  return session->Edit(
      "Move keys in time",
      [&](Project* project) -> Result<Done> {
        for (const std::string& name : ChosenCurves(*session, p)) {
          const Result<ProjectCurve*> curve = CurveNamed(name, session->figure(), project);
          if (!curve.ok()) return curve.error();
          std::vector<ProjectKey> moved;
          std::erase_if(curve.value()->keys, [&](const ProjectKey& key) {
            if (key.type == KeyType::kGenerated) return true;  // made anew
            if (key.frame < first || key.frame > last) return false;
            moved.push_back(key);
            return true;
          });
          for (ProjectKey& key : moved) {
            key.frame = key.frame == last ? to_last : to_first + scale * (key.frame - first);
            PutKey(key, curve.value());
          }
        }
        return Done();
      },
      p.text("drag"));
}

// The curves that are given, or the selected joints, or the whole pose.
std::vector<std::string> CurvesToKey(const Session& session, const Parameters& p) {
  if (p.has("curves") || !session.selected_joints().empty()) return ChosenCurves(session, p);
  std::vector<std::string> all;
  all.reserve(session.figure().joints().size());
  for (const Joint& joint : session.figure().joints()) all.push_back(joint.name);
  return all;
}

// A key that holds what is seen now, whatever moves the hinge.
Result<Done> InsertKeys(Session* session, const Parameters& p) {
  std::vector<std::pair<std::string, double>> values;
  for (const std::string& name : CurvesToKey(*session, p)) {
    const Result<double> angle = session->ValueNow(name);
    if (!angle.ok()) return angle.error();
    values.emplace_back(name, angle.value());
  }
  return session->Edit("Insert key", [&](Project* project) -> Result<Done> {
    for (const auto& [name, value] : values) {
      const Result<ProjectCurve*> curve = CurveNamed(name, session->figure(), project);
      if (!curve.ok()) return curve.error();
      ProjectKey key = KeyToChange(session->frame(), *curve.value());
      key.value = value;
      PutKey(key, curve.value());
    }
    return Done();
  });
}

}  // namespace

std::vector<std::string> ChosenCurves(const Session& session, const Parameters& p) {
  if (p.has("curves")) return p.names("curves");
  if (session.selected_joints().empty()) return CurveNames(session.project());
  return CurvesOf(session.selected_joints(), session.figure());
}

std::vector<Operator> KeyOperators() {
  const ParameterInfo curves = {"curves", kNames, false,
                                "curves; not given: those of the selected joints, else all",
                                Thing::kCurve};
  const ParameterInfo hinges = {
      "curves", kNames, false,
      "hinges; not given: those of the selected joints, else all of the figure", Thing::kCurve};
  return {
      {"key.set", "Set key", "Sets a key of a curve, or makes one.",
       Joined({{kCurve, kFrame},
               FieldsOf<ProjectKey>(),
               {{"auto_rate", kYesNo, false, "true: the rate follows from the neighbours again"},
                kDrag}}),
       SetKey},
      {"key.rate",
       "Set rate of key",
       "Sets how fast a curve passes a key.",
       {kCurve,
        kFrame,
        {"rate", kNumber, true, "degrees per second, of root positions m/s"},
        {"side", kText, false, "before or after, of a key whose tangent is broken; else both",
         "before after"},
        {"length",
         kNumber,
         false,
         "of the tangent on that side, a share of the time",
         {},
         "",
         "",
         kTangentLength},
        kDrag},
       SetKeyRate},
      {"key.delete",
       "Delete key",
       "Takes the keys of the selected joints, else of all, on this frame away.",
       {{"curve", kText, false, "only of this curve", Thing::kCurve},
        {"frame", kNumber, false, "not given: the current one"}},
       DeleteKey},
      {"key.move",
       "Move key",
       "Moves a key in time, up or down.",
       {kCurve,
        kFrame,
        {"to", kNumber, false, "its new frame"},
        {"by", kNumber, false, "what is added to its value"},
        kDrag},
       MoveKey},
      {"key.retime",
       "Move keys in time",
       "Moves and stretches all keys of some curves from one interval to another.",
       {curves,
        {"first", kNumber, true, "first frame of the keys"},
        {"last", kNumber, true, "last frame of the keys"},
        {"to_first", kNumber, true, "where the first frame comes to lie"},
        {"to_last", kNumber, true, "where the last frame comes to lie"},
        kDrag},
       RetimeKeys},
      {"key.insert",
       "Insert key",
       "Keys the pose as it is at the current frame.",
       {hinges},
       InsertKeys}};
}

}  // namespace hazumi::edit
