#include "ui/edit/session_state.h"

#include <cmath>

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

Result<std::set<std::string>> SelectedIn(const Json& state, const Figure& figure) {
  const auto names = state.find("selected_joints");
  if (names == state.end() || !names->is_array()) {
    return Wrong("selected_joints", "must be a list of hinges");
  }
  std::set<std::string> selected;
  for (const Json& name : *names) {
    if (!name.is_string() || !figure.FindJoint(name.get<std::string>())) {
      return Wrong("selected_joints", "the figure has no hinge " + name.dump());
    }
    selected.insert(name.get<std::string>());
  }
  return selected;
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

}  // namespace

Json StateOf(const Session& session) {
  Json clipboard = Json::object();
  for (const Named<double>& angle : session.clipboard()) clipboard[angle.name] = angle.value;
  return {{"frame", session.frame()},
          {"selected_joints", session.selected_joints()},
          {"clipboard", std::move(clipboard)}};
}

Result<Done> RestoreState(const Json& state, Session* session) {
  if (!state.is_object()) return Wrong("", "must be an object");
  const Result<double> frame = FrameIn(state);
  if (!frame.ok()) return frame.error();
  Result<std::set<std::string>> selected = SelectedIn(state, session->figure());
  if (!selected.ok()) return selected.error();
  Result<Pose> clipboard = ClipboardIn(state);
  if (!clipboard.ok()) return clipboard.error();
  session->set_frame(frame.value());
  session->set_selected_joints(std::move(selected).value());
  session->set_clipboard(std::move(clipboard).value());
  return Done();
}

}  // namespace hazumi::edit
