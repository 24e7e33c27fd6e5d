#include "ui/panels/parameter_form.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/base/text.h"
#include "ui/edit/session.h"
#include "ui/panels/actions.h"

namespace hazumi::ui {

namespace {

using edit::ParameterInfo;
using edit::ParameterKind;

std::string TextOf(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return FormatShort(value.get<double>());
  std::string list;
  if (value.is_array()) {
    for (const Json& item : value) list += (list.empty() ? "" : ", ") + TextOf(item);
  }
  return list;
}

// What is meant most of the time.
Json Suggestion(const ParameterInfo& info, const edit::Session& session) {
  const std::string name = info.name;
  const Project& project = session.project();
  const double now = std::round(session.frame());
  if (name == "first") return now;
  if (name == "frame" || name == "to_first") return now;
  if (name == "last" || name == "to_last") return project.frames.last;
  if (name == "region" && !project.regions.empty()) return project.regions.front().name;
  if (name == "object" && !project.scene.objects.empty()) {
    return project.scene.objects.back().name;
  }
  const std::set<std::string>& joints = session.selected_joints();
  const bool is_one = name == "joint" || name == "curve";
  return is_one && !joints.empty() ? Json(*joints.begin()) : Json();
}

std::vector<std::string> Parts(const std::string& text) {
  std::vector<std::string> parts;
  size_t first = 0;
  while (first <= text.size()) {
    const size_t comma = std::min(text.find(',', first), text.size());
    std::string part = text.substr(first, comma - first);
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    if (!part.empty()) parts.push_back(std::move(part));
    first = comma + 1;
  }
  return parts;
}

Result<Json> NumberIn(const std::string& text, const ParameterInfo& info) {
  double number = 0.0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc() || end != text.data() + text.size()) {
    return Error{ErrorCode::kSchema, "", info.name,
                 "\"" + text + "\" must be " + edit::Describe(info.kind)};
  }
  return Json(number);
}

Result<Json> NumbersIn(const std::string& text, const ParameterInfo& info) {
  Json list = Json::array();
  for (const std::string& part : Parts(text)) {
    Result<Json> number = NumberIn(part, info);
    if (!number.ok()) return number;
    list.push_back(number.value());
  }
  return list;
}

Result<Json> ValueOf(const FormField& field) {
  switch (field.info.kind) {
    case ParameterKind::kText:
      return Json(field.text);
    case ParameterKind::kYesNo:
      return Json(field.yes);
    case ParameterKind::kNames:
      return Json(Parts(field.text));
    case ParameterKind::kNumbers:
      return NumbersIn(field.text, field.info);
    case ParameterKind::kNumber:
    case ParameterKind::kInteger:
      break;
  }
  return NumberIn(field.text, field.info);
}

}  // namespace

const std::vector<ParameterInfo>& ParametersOf(const std::string& id) {
  static const std::vector<ParameterInfo> none;
  if (const Action* action = FindAction(id)) return action->parameters;
  const edit::Operator* op = edit::FindOperator(id);
  return op ? op->parameters : none;
}

bool NeedsForm(const std::string& id, const Json& given) {
  const std::vector<ParameterInfo>& infos = ParametersOf(id);
  return std::any_of(infos.begin(), infos.end(), [&](const ParameterInfo& info) {
    return info.is_required && !given.contains(info.name);
  });
}

FormState MakeForm(const std::string& id, const Json& given, edit::Session* session) {
  FormState form;
  form.id = id;
  for (const ParameterInfo& info : ParametersOf(id)) {
    if (std::string(info.name) == "drag") continue;
    FormField field{info, "", false};
    const bool is_given = given.contains(info.name);
    const Json value = is_given           ? given[info.name]
                       : info.is_required ? Suggestion(info, *session)
                                          : Json();
    field.text = TextOf(value);
    field.yes = value.is_boolean() && value.get<bool>();
    form.fields.push_back(std::move(field));
  }
  std::stable_partition(form.fields.begin(), form.fields.end(),
                        [](const FormField& field) { return field.info.is_required; });
  return form;
}

Result<Json> ValuesOf(const FormState& form) {
  Json values = Json::object();
  for (const FormField& field : form.fields) {
    const bool is_ticked = field.info.kind == ParameterKind::kYesNo;
    const bool is_empty = is_ticked ? !field.yes : field.text.empty();
    if (is_empty && !(is_ticked && field.info.is_required)) continue;
    const Result<Json> value = ValueOf(field);
    if (!value.ok()) return value.error();
    values[field.info.name] = value.value();
  }
  return values;
}

}  // namespace hazumi::ui
