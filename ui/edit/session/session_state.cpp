#include "ui/edit/session/session_state.h"

#include <cmath>

#include "engine/project/enum_names.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

Error Wrong(const char* place, const std::string& message) {
  return {ErrorCode::kSchema, "", place, message};
}

Result<double> FrameIn(const Json& state) {
  const auto frame = state.find("frame");
  if (frame == state.end() || !frame->is_number() || !std::isfinite(frame->get<double>())) {
    return Wrong("frame", "must be a number");
  }
  return frame->get<double>();
}

Result<std::set<std::string>> HingesIn(const Json& state, const char* field, const Figure& figure) {
  const auto names = state.find(field);
  if (names == state.end() || !names->is_array()) return Wrong(field, "must be a list of hinges");
  std::set<std::string> hinges;
  for (const Json& name : *names) {
    const bool is_root = name == figure.root_name();
    if (!name.is_string() || (!is_root && !figure.FindJoint(name.get<std::string>()))) {
      return Wrong(field, "the figure has no hinge " + name.dump());
    }
    hinges.insert(name.get<std::string>());
  }
  return hinges;
}

Result<Pose> ClipboardIn(const Json& state) {
  const auto angles = state.find("clipboard");
  if (angles == state.end() || !angles->is_object()) {
    return Wrong("clipboard", "must be an object of hinges and angles");
  }
  Pose pose;
  for (const auto& [name, angle] : angles->items()) {
    if (!angle.is_number()) return Wrong("clipboard", "the angle of " + name + " must be a number");
    pose.push_back({name, angle.get<double>()});
  }
  return pose;
}

Json JsonOf(const KeySelection& keys) {
  Json json = Json::object();
  for (const auto& [curve, frames] : keys) json[curve] = frames;
  return json;
}

Result<KeySelection> SelectedKeysIn(const Json& state) {
  const Error wrong = Wrong("selected_keys", "must be an object of curves and lists of frames");
  const auto curves = state.find("selected_keys");
  if (curves == state.end() || !curves->is_object()) return wrong;
  KeySelection keys;
  for (const auto& [curve, frames] : curves->items()) {
    if (!frames.is_array()) return wrong;
    for (const Json& frame : frames) {
      if (!frame.is_number()) return wrong;
      keys[curve].insert(frame.get<double>());
    }
  }
  return keys;
}

Json JsonOf(const Named<ProjectKey>& copied) {
  Json json = {{"curve", copied.name}, {"frame", copied.value.frame}};
  ForEachField(copied.value, [&](const Field& field, const auto& value) {
    const Json said = edit::JsonOf(value);
    if (!said.is_null()) json[ParameterOf(field)] = said;
  });
  return json;
}

Result<std::vector<Named<ProjectKey>>> CopiedKeysIn(const Json& state) {
  const auto list = state.find("copied_keys");
  if (list == state.end() || !list->is_array()) return Wrong("copied_keys", "must be a list");
  const ParameterInfos infos = Joined(
      {{{"curve", ParameterKind::kText, true, ""}, {"frame", ParameterKind::kNumber, true, ""}},
       Requiring({"value", "interpolation"}, FieldsOf<ProjectKey>())});
  std::vector<Named<ProjectKey>> keys;
  for (const Json& json : *list) {
    const Result<Parameters> p = Parameters::Check(infos, json);
    if (!p.ok()) return Wrong("copied_keys", p.error().ToString());
    ProjectKey key;
    key.frame = p.value().number("frame");
    if (const Result<Done> set = SetFields(p.value(), &key); !set.ok()) {
      return Wrong("copied_keys", set.error().ToString());
    }
    keys.push_back({p.value().text("curve"), key});
  }
  return keys;
}

}  // namespace

Json StateOf(const Session& session) {
  Json clipboard = Json::object();
  for (const Named<double>& angle : session.clipboard()) clipboard[angle.name] = angle.value;
  Json copied = Json::array();
  for (const Named<ProjectKey>& key : session.key_clipboard()) copied.push_back(JsonOf(key));
  return {{"frame", session.frame()},
          {"selected_joints", session.selected_joints()},
          {"hidden_joints", session.hidden_joints()},
          {"locked_joints", session.locked_joints()},
          {"clipboard", std::move(clipboard)},
          {"selected_keys", JsonOf(session.selected_keys())},
          {"copied_keys", std::move(copied)}};
}

Result<Done> RestoreState(const Json& state, Session* session) {
  if (!state.is_object()) return Wrong("", "must be an object");
  const Result<double> frame = FrameIn(state);
  if (!frame.ok()) return frame.error();
  const Figure& figure = session->figure();
  Result<std::set<std::string>> selected = HingesIn(state, "selected_joints", figure);
  if (!selected.ok()) return selected.error();
  Result<std::set<std::string>> hidden = HingesIn(state, "hidden_joints", figure);
  if (!hidden.ok()) return hidden.error();
  Result<std::set<std::string>> locked = HingesIn(state, "locked_joints", figure);
  if (!locked.ok()) return locked.error();
  Result<Pose> clipboard = ClipboardIn(state);
  if (!clipboard.ok()) return clipboard.error();
  Result<KeySelection> selected_keys = SelectedKeysIn(state);
  if (!selected_keys.ok()) return selected_keys.error();
  Result<std::vector<Named<ProjectKey>>> copied = CopiedKeysIn(state);
  if (!copied.ok()) return copied.error();
  session->set_frame(frame.value());
  session->set_selected_joints(std::move(selected).value());
  session->set_hidden_joints(std::move(hidden).value());
  session->set_locked_joints(std::move(locked).value());
  session->set_clipboard(std::move(clipboard).value());
  session->set_selected_keys(std::move(selected_keys).value());
  session->set_key_clipboard(std::move(copied).value());
  return Done();
}

}  // namespace hazumi::edit
