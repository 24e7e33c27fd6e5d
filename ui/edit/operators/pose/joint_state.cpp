// What of the figure is hidden or locked while it is posed. No part of the document.

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

// By the parameter "joints"; not given: what is selected.
Result<std::set<std::string>> Chosen(const Session& session, const Parameters& p) {
  if (!p.has("joints")) {
    if (!session.selected_joints().empty()) return session.selected_joints();
    return Refusal("joints", "no joint is selected; click one");
  }
  std::set<std::string> chosen;
  for (const std::string& name : p.names("joints")) {
    const Result<std::vector<std::string>> hinges = HingesNamed(name, session.figure());
    if (!hinges.ok()) return hinges.error();
    chosen.insert(hinges.value().begin(), hinges.value().end());
  }
  return chosen;
}

std::set<std::string> With(std::set<std::string> names, const std::set<std::string>& more) {
  names.insert(more.begin(), more.end());
  return names;
}

std::set<std::string> Without(std::set<std::string> names, const std::set<std::string>& fewer) {
  for (const std::string& name : fewer) names.erase(name);
  return names;
}

Result<Done> Hide(Session* session, const Parameters& p) {
  const Result<std::set<std::string>> chosen = Chosen(*session, p);
  if (!chosen.ok()) return chosen.error();
  const std::set<std::string>& hidden = session->hidden_joints();
  if (!p.yes("on", true)) {
    session->set_hidden_joints(Without(hidden, chosen.value()));
    return Done();
  }
  session->set_hidden_joints(With(hidden, chosen.value()));
  session->set_selected_joints(Without(session->selected_joints(), chosen.value()));
  return Done();
}

Result<Done> ShowAll(Session* session, const Parameters&) {
  session->set_hidden_joints({});
  return Done();
}

Result<Done> Lock(Session* session, const Parameters& p) {
  const Result<std::set<std::string>> chosen = Chosen(*session, p);
  if (!chosen.ok()) return chosen.error();
  const std::set<std::string>& locked = session->locked_joints();
  session->set_locked_joints(p.yes("on", true) ? With(locked, chosen.value())
                                               : Without(locked, chosen.value()));
  return Done();
}

}  // namespace

std::vector<Operator> JointStateOperators() {
  const ParameterInfo joints = {"joints", kNames, false, "joints; not given: the selected ones",
                                Thing::kJoint};
  return {{"joint.hide",
           "Hide joints",
           "Takes the marks of joints away, so that they are not in the way of others.",
           {joints, {"on", kYesNo, false, "false: shows them again", kOnUnlessGiven}},
           Hide},
          {"joint.show_all", "Show all joints", "Shows what was hidden again.", {}, ShowAll},
          {"joint.lock",
           "Lock joints",
           "Keeps joints from being posed.",
           {joints, {"on", kYesNo, false, "false: unlocks them", kOnUnlessGiven}},
           Lock}};
}

}  // namespace hazumi::edit
