#include "engine/project/address/field_address.h"

#include "engine/project/address/addressed_field.h"
#include "engine/project/checks/field_checker.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/json/read_value.h"

namespace hazumi {

namespace {

Error BadAddress(std::string_view text, const std::string& message) {
  return {ErrorCode::kSchema, "", std::string(text), message};
}

// Puts a value from a file in the place of a field's.
class ValueSetter {
 public:
  explicit ValueSetter(const Json* json) : json_(json) {}

  template <typename T>
  std::optional<Error> operator()(const Field& field, T& value) const {
    FirstError errors;
    ReadValue(*json_, Site{"", &errors}, value);
    FieldChecker checker(&errors);
    if (errors.ok()) checker.Required(field, value);
    return errors.error();
  }
  // null: left out.
  template <typename T>
  std::optional<Error> operator()(const Field& field, std::optional<T>& value) const {
    value.reset();
    return json_->is_null() ? std::nullopt : (*this)(field, value.emplace());
  }
  // The list is another, not a longer one.
  std::optional<Error> operator()(const Field& field, std::vector<JointRef>& value) const {
    value.clear();
    return operator()<std::vector<JointRef>>(field, value);
  }

 private:
  const Json* json_;
};

class ValueGetter {
 public:
  explicit ValueGetter(std::string* text) : text_(text) {}

  template <typename T>
  std::optional<Error> operator()(const Field&, const T& value) const {
    *text_ = CompactJson(ToJson(value));
    return std::nullopt;
  }
  template <typename T>
  std::optional<Error> operator()(const Field& field, const std::optional<T>& value) const {
    if (value) return (*this)(field, *value);
    *text_ = "null";
    return std::nullopt;
  }

 private:
  std::string* text_;
};

template <typename Document, typename Visit>
Result<Done> VisitField(const FieldAddress& address, Document& project, const Visit& visit) {
  AddressedField<Visit, std::is_const_v<Document>> field(address, &visit);
  std::optional<Error> error = field.FindIn(project);
  if (!error) return Done();
  error->place = TextOf(address);
  return *std::move(error);
}

// One step from `at` on, which is moved behind it; a message if it cannot be read.
const char* ReadStep(std::string_view text, size_t* at, FieldAddress* address) {
  AddressStep step;
  step.is_item = text[*at] == '[';
  if (step.is_item) {
    const size_t end = text.find(']', *at);
    if (end == text.npos) return "a ] is missing";
    step.name = text.substr(*at + 1, end - *at - 1);
    *at = end + 1;
  } else {
    if (!address->steps.empty()) {
      if (text[*at] != '.') return "behind ] comes a dot or [";
      ++*at;
    }
    const size_t end = std::min(text.find_first_of(".[", *at), text.size());
    step.name = text.substr(*at, end - *at);
    *at = end;
  }
  if (step.name.empty()) return "a name is missing";
  address->steps.push_back(std::move(step));
  return nullptr;
}

}  // namespace

Result<FieldAddress> ParseAddress(std::string_view text) {
  FieldAddress address;
  size_t at = 0;
  while (at < text.size()) {
    if (const char* wrong = ReadStep(text, &at, &address)) {
      return BadAddress(text, std::string("is no address of a field: ") + wrong);
    }
  }
  if (!address.steps.empty() && !address.steps.front().is_item) return address;
  return BadAddress(text,
                    "is no address of a field: it begins with one, such as scene.gravity_m_s2");
}

std::string TextOf(const FieldAddress& address) {
  std::string text;
  for (const AddressStep& step : address.steps) {
    if (step.is_item) {
      text += "[" + step.name + "]";
    } else {
      text += (text.empty() ? "" : ".") + step.name;
    }
  }
  return text;
}

Result<Done> SetField(const FieldAddress& address, std::string_view json, Project* project) {
  FirstError errors;
  const std::optional<Json> value = ParseJson(json, &errors);
  if (!value) {
    Error error = *errors.error();
    error.place = TextOf(address);
    return error;
  }
  return VisitField(address, *project, ValueSetter(&*value));
}

Result<std::string> GetField(const FieldAddress& address, const Project& project) {
  std::string text;
  const Result<Done> found = VisitField(address, project, ValueGetter(&text));
  if (!found.ok()) return found.error();
  return text;
}

}  // namespace hazumi
