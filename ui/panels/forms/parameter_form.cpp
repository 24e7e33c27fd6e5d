#include "ui/panels/forms/parameter_form.h"

#include <algorithm>
#include <charconv>

#include "engine/base/text.h"
#include "ui/edit/session/session.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/forms/offers.h"
#include "ui/panels/forms/texts.h"

namespace hazumi::ui {

namespace {

using edit::ParameterInfo;
using edit::ParameterKind;

// Operators that change what they are told, and nothing that they are not.
bool DoesNothingAlone(const std::string& id) {
  return id == "time.range" || id == "solver.set" || id == "audio.set" || id == "reference.set";
}

}  // namespace

std::string TextOf(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return FormatNumber(value.get<double>());
  std::string list;
  if (value.is_array()) {
    for (const Json& item : value) list += (list.empty() ? "" : ", ") + TextOf(item);
  }
  return list;
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

namespace {

// A tick that is as it would be without it need not be given.
bool IsGiven(const FormField& field) {
  if (field.info.kind != ParameterKind::kYesNo) return !field.text.empty();
  return field.info.is_required || field.yes != field.info.offer.is_on;
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
  if (given.empty() && DoesNothingAlone(id)) return true;
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
    FormField field{info, "", false,
                    info.is_required || IsMain(id, info.name) || DoesNothingAlone(id)};
    const bool is_given = given.contains(info.name);
    const Json value = is_given        ? given[info.name]
                       : field.is_main ? Suggestion(id, info, session)
                                       : Json();
    field.text = TextOf(value);
    field.yes = value.is_boolean() ? value.get<bool>() : info.offer.is_on;
    form.fields.push_back(std::move(field));
  }
  const auto others = std::stable_partition(form.fields.begin(), form.fields.end(),
                                            [](const FormField& field) { return field.is_main; });
  std::stable_partition(form.fields.begin(), others,
                        [](const FormField& field) { return field.info.is_required; });
  return form;
}

bool IsAsked(const FormState& form, const FormField& field) {
  if (form.id != "placement.set") return true;
  const std::string name = field.info.name;
  const std::string& kind = form.fields.front().text;
  return name == "landing_pin" ? kind == "gravity" : name != "pin" || kind != "keyed";
}

std::vector<FormRow> RowsOf(FormState* form) {
  std::vector<FormRow> rows;
  std::vector<std::string> expected;  // in the present row
  for (FormField& field : form->fields) {
    if (!IsAsked(*form, field)) continue;
    const bool is_next = !expected.empty() && expected.front() == field.info.name &&
                         rows.back().fields.front()->is_main == field.is_main;
    if (is_next) {
      rows.back().fields.push_back(&field);
      expected.erase(expected.begin());
      continue;
    }
    const std::string label = LabelOfRow(form->id, field.info.name);
    rows.push_back({label.empty() ? LabelOf(field.info) : label, {&field}});
    expected = NamesInRow(field.info.name);
    if (!expected.empty()) expected.erase(expected.begin());
  }
  return rows;
}

Result<Json> ValuesOf(const FormState& form) {
  Json values = Json::object();
  for (const FormField& field : form.fields) {
    if (!IsAsked(form, field)) continue;
    if (!IsGiven(field)) continue;
    const Result<Json> value = ValueOf(field);
    if (!value.ok()) return value.error();
    values[field.info.name] = value.value();
  }
  return values;
}

}  // namespace hazumi::ui
