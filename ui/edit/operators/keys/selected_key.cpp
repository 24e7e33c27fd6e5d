// The selected keys. Values are degrees, of root positions metres; rates are per second.

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/project/edits/key_selection.h"
#include "engine/project/edits/keys.h"
#include "engine/project/items.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kSubframe = {"subframe", kYesNo, false,
                                 "true: keys may land between frames; else on the nearest"};
// So that what is dragged across comes back.
const ParameterInfo kDragFromStart = {
    "drag", kText, false,
    "edits in a row with the same text are one undo step, and each counts from where it began"};

double Snapped(double frame, const Parameters& p) {
  return p.yes("subframe") ? frame : std::round(frame);
}

// Selected keys of one curve, and where an edit put them.
struct SelectedCurve {
  const std::string& name;
  const std::set<double>& frames;
  ProjectCurve* curve;
  std::set<double>* selected_after;
};

// Sets curves and items of all kinds to what they were when a drag began.
void TakeFramesOf(const Project& start, Project* project) {
  project->root.curves = start.root.curves;
  project->joints = start.joints;
  ForEachItemList([](auto, auto& now, const auto& before) { now = before; }, *project, start);
}

// Removes generated keys where keys of the animator are moved in time: they are made anew.
void DropGenerated(ProjectCurve* curve, std::set<double>* selected) {
  const auto is_generated = [](const ProjectKey& key) { return key.type == KeyType::kGenerated; };
  const bool moves = std::any_of(curve->keys.begin(), curve->keys.end(), [&](const auto& key) {
    return selected->contains(key.frame) && !is_generated(key);
  });
  if (!moves) return;
  for (const ProjectKey& key : curve->keys) {
    if (is_generated(key)) selected->erase(key.frame);
  }
  std::erase_if(curve->keys, is_generated);
}

// `edit(curve)` for each curve with selected keys, as they were when the drag began. `id`: the
// operator's. `to`: where frames go, if they go anywhere.
template <typename EditCurve>
Result<Done> EditSelected(Session* session, const std::string& id, const std::string& drag,
                          EditCurve edit, const FrameMap& to = nullptr) {
  const std::string merge = drag.empty() ? "" : id + " " + drag;
  return session->Edit(
      FindOperator(id)->label,
      [&](Project* project) -> Result<Done> {
        KeySelection selected = session->selected_keys(), after;
        if (const Document::State* start = session->document().drag_start(merge)) {
          TakeFramesOf(start->project, project);
          selected = start->keys;
        }
        if (selected.empty()) return Refusal("", "no key is selected");
        if (to) CarryAlong(selected, session->figure(), to, project);
        for (auto& [name, frames] : selected) {
          const Result<ProjectCurve*> curve = CurveNamed(name, session->figure(), project);
          if (!curve.ok()) return curve.error();
          if (to) DropGenerated(curve.value(), &frames);
          Result<Done> done = edit(SelectedCurve{name, frames, curve.value(), &after[name]});
          if (!done.ok()) return done;
        }
        session->set_selected_keys(std::move(after));
        return Done();
      },
      merge);
}

std::vector<ProjectKey> SelectedOf(const SelectedCurve& of) {
  std::vector<ProjectKey> keys;
  for (const ProjectKey& key : of.curve->keys) {
    if (of.frames.contains(key.frame)) keys.push_back(key);
  }
  return keys;
}

// Puts keys in their places; those that lay there give way. Refuses two on one frame.
Result<Done> PutKeys(std::vector<ProjectKey> keys, const SelectedCurve& of) {
  for (const ProjectKey& key : keys) {
    if (of.selected_after->insert(key.frame).second) continue;
    return Refusal("", "two selected keys of \"" + of.name + "\" would land on frame " +
                           FormatShort(key.frame) + "; subframe keeps them apart");
  }
  std::erase_if(of.curve->keys,
                [&](const ProjectKey& key) { return of.selected_after->contains(key.frame); });
  keys.insert(keys.end(), of.curve->keys.begin(), of.curve->keys.end());
  std::sort(keys.begin(), keys.end(),
            [](const ProjectKey& a, const ProjectKey& b) { return a.frame < b.frame; });
  of.curve->keys = std::move(keys);
  return Done();
}

void TakeSelected(const SelectedCurve& of) {
  std::erase_if(of.curve->keys,
                [&](const ProjectKey& key) { return of.frames.contains(key.frame); });
}

// Up or down alone it stays on its frame, which may lie between frames.
void Shift(const Parameters& p, ProjectKey* key) {
  if (p.number("frames") != 0.0) key->frame = Snapped(key->frame + p.number("frames"), p);
  key->value += p.number("value");
}

Result<Done> MoveSelected(Session* session, const Parameters& p) {
  return EditSelected(
      session, "keys.move", p.text("drag"),
      [&](const SelectedCurve& of) {
        std::vector<ProjectKey> keys = SelectedOf(of);
        TakeSelected(of);
        for (ProjectKey& key : keys) Shift(p, &key);
        return PutKeys(std::move(keys), of);
      },
      [&](double frame) { return frame + p.number("frames"); });
}

Result<Done> DuplicateSelected(Session* session, const Parameters& p) {
  return EditSelected(session, "keys.duplicate", p.text("drag"), [&](const SelectedCurve& of) {
    std::vector<ProjectKey> copies = SelectedOf(of);
    for (ProjectKey& key : copies) Shift(p, &key);
    return PutKeys(std::move(copies), of);
  });
}

double MeanValue(const std::vector<ProjectKey>& keys) {
  double sum = 0.0;
  for (const ProjectKey& key : keys) sum += key.value;
  return keys.empty() ? 0.0 : sum / static_cast<double>(keys.size());
}

// Given rates follow, so that the curve keeps its shape.
Result<Done> ScaleSelected(Session* session, const Parameters& p) {
  const double about = p.number("about", session->frame()), factor = p.number("factor", 1.0);
  const double values = p.number("values", 1.0);
  if (factor <= 0.0) return Refusal("factor", "must be greater than 0");
  const auto to = [&](double frame) { return about + factor * (frame - about); };
  return EditSelected(
      session, "keys.scale", p.text("drag"),
      [&](const SelectedCurve& of) {
        std::vector<ProjectKey> keys = SelectedOf(of);
        TakeSelected(of);
        const double mean = MeanValue(keys);
        for (ProjectKey& key : keys) {
          if (factor != 1.0) key.frame = Snapped(to(key.frame), p);
          if (values != 1.0) key.value = mean + values * (key.value - mean);
          if (key.rate) *key.rate *= values / factor;
          if (key.rate_in) *key.rate_in *= values / factor;
        }
        return PutKeys(std::move(keys), of);
      },
      to);
}

Result<Done> DeleteSelected(Session* session, const Parameters&) {
  return EditSelected(session, "keys.delete", "", [](const SelectedCurve& of) {
    TakeSelected(of);
    return Result<Done>(Done());
  });
}

constexpr const char* kHandleKinds = "auto flat aligned broken free_length fixed_length";

// `change(key)` for each selected key; all stay where they are.
template <typename Change>
Result<Done> ChangeKeys(Session* session, const std::string& id, Change change) {
  return EditSelected(session, id, "", [&](const SelectedCurve& of) {
    for (ProjectKey& key : of.curve->keys) {
      if (of.frames.contains(key.frame)) change(&key);
    }
    *of.selected_after = of.frames;
    return Result<Done>(Done());
  });
}

// What is given of these fields, to each selected key.
Result<Done> SetSelected(Session* session, const Parameters& p, const char* id) {
  ProjectKey probe;
  if (Result<Done> set = SetFields(p, &probe); !set.ok()) return set;
  return ChangeKeys(session, id, [&](ProjectKey* key) { (void)SetFields(p, key); });
}
Result<Done> InterpolateSelected(Session* session, const Parameters& p) {
  return SetSelected(session, p, "keys.interpolation");
}
Result<Done> EaseSelected(Session* session, const Parameters& p) {
  return SetSelected(session, p, "keys.easing");
}
Result<Done> SetSelectedType(Session* session, const Parameters& p) {
  return SetSelected(session, p, "keys.type");
}

// The curve runs as before where only more is said of it.
void SetHandles(const std::string& kind, const RatesOfKey& now, ProjectKey* key) {
  constexpr double kThird = 1.0 / 3.0;
  if (kind == "auto") return SetAutomatic(key);
  if (kind == "fixed_length") {
    key->length_in.reset();
    key->length_out.reset();
    return;
  }
  if (kind == "free_length") {
    if (!key->length_in) key->length_in = kThird;
    if (!key->length_out) key->length_out = kThird;
    return;
  }
  if (kind == "broken" && !key->rate_in) key->rate_in = key->rate.value_or(now.before);
  if (kind == "aligned" || kind == "flat") key->rate_in.reset();
  if (kind == "flat") key->rate = 0.0;
  if (!key->rate) key->rate = now.after;
}

Result<Done> SetSelectedHandles(Session* session, const Parameters& p) {
  const std::string kind = p.text("kind");
  const std::vector<std::string> kinds = WordsOf(Offer(kHandleKinds));
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    std::string list;
    for (const std::string& other : kinds) list += (list.empty() ? "" : ", ") + other;
    return Refusal("kind", "\"" + kind + "\" is none of " + list);
  }
  return EditSelected(session, "keys.handles", "", [&](const SelectedCurve& of) {
    const std::vector<RatesOfKey> now = RatesOf(*of.curve, session->project().fps);
    for (size_t i = 0; i < of.curve->keys.size(); ++i) {
      ProjectKey* key = &of.curve->keys[i];
      if (of.frames.contains(key->frame)) SetHandles(kind, now[i], key);
    }
    *of.selected_after = of.frames;
    return Result<Done>(Done());
  });
}

Result<Done> CopySelected(Session* session, const Parameters&) {
  std::vector<Named<ProjectKey>> keys;
  for (const auto& [name, frames] : session->selected_keys()) {
    const ProjectCurve* curve = FindCurve(name, session->project());
    for (const double frame : frames) keys.push_back({name, *KeyOn(frame, *curve)});
  }
  if (keys.empty()) return Refusal("", "no key is selected");
  session->set_key_clipboard(std::move(keys));
  return Done();
}

// The earliest lands on the current frame.
Result<Done> PasteSelected(Session* session, const Parameters&) {
  const std::vector<Named<ProjectKey>>& keys = session->key_clipboard();
  if (keys.empty()) return Refusal("", "no key has been copied");
  const auto earlier = [](const auto& a, const auto& b) { return a.value.frame < b.value.frame; };
  const double first = std::min_element(keys.begin(), keys.end(), earlier)->value.frame;
  return session->Edit("Paste keys", [&](Project* project) -> Result<Done> {
    KeySelection pasted;
    for (const Named<ProjectKey>& entry : keys) {
      const Result<ProjectCurve*> curve = CurveNamed(entry.name, session->figure(), project);
      if (!curve.ok()) return curve.error();
      ProjectKey key = entry.value;
      key.frame += session->frame() - first;
      PutKey(key, curve.value());
      pasted[entry.name].insert(key.frame);
    }
    session->set_selected_keys(std::move(pasted));
    return Done();
  });
}

}  // namespace

std::vector<Operator> SelectedKeyOperators() {
  const ParameterInfo frames = {"frames", kNumber, false, "how many frames later"};
  const ParameterInfo value = {"value", kNumber, false, "what is added to the values"};
  return {
      {"keys.move",
       "Move keys",
       "Moves the selected keys; those that they land on give way. Bars and markers between them go"
       " along if all keys there are selected, a region also if all of its joints' are.",
       {frames, value, kSubframe, kDragFromStart},
       MoveSelected},
      {"keys.scale",
       "Scale keys",
       "Stretches the selected keys in time, or their values about each curve's mean. Bars and"
       " markers between them go along if all keys there are selected, a region also if all of"
       " its joints' are.",
       {{"factor", kNumber, false, "of time, greater than 0; 2: twice as long"},
        {"about", kNumber, false, "the frame that stays; not given: the current one"},
        {"values", kNumber, false, "of values; 2: twice as far from the mean"},
        kSubframe,
        kDragFromStart},
       ScaleSelected},
      {"keys.duplicate",
       "Duplicate keys",
       "Copies the selected keys to other frames and selects the copies.",
       {{"frames", kNumber, true, "how many frames later"}, value, kSubframe, kDragFromStart},
       DuplicateSelected},
      {"keys.delete", "Delete keys", "Takes the selected keys away.", {}, DeleteSelected},
      {"keys.copy", "Copy keys", "Copies the selected keys.", {}, CopySelected},
      {"keys.paste",
       "Paste keys",
       "Puts the copied keys so that the earliest lies on the current frame, and selects them.",
       {},
       PasteSelected},
      {"keys.interpolation", "Interpolation of keys",
       "Sets how the curve goes on from the selected keys.",
       Requiring({"interpolation"}, Only({"interpolation", "easing"}, FieldsOf<ProjectKey>())),
       InterpolateSelected},
      {"keys.easing", "Easing of keys", "Sets on which end the curves of eased keys lie.",
       Requiring({"easing"}, Only({"easing"}, FieldsOf<ProjectKey>())), EaseSelected},
      {"keys.type", "Type of keys",
       "Sets what the selected keys are to you; they are coloured by it, nothing moves.",
       Requiring({"type"}, Only({"type"}, FieldsOf<ProjectKey>())), SetSelectedType},
      {"keys.handles",
       "Handles of keys",
       "Sets the tangents at the selected keys.",
       {{"kind", kText, true,
         "auto: from the neighbours; flat: rate 0; aligned: one line; broken: each side its own; "
         "free_length, fixed_length: whether they reach as far as you say",
         kHandleKinds}},
       SetSelectedHandles}};
}

}  // namespace hazumi::edit
