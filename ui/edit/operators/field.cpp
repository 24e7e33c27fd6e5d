// Any fields of the document, by their addresses.

#include "engine/project/address/field_address.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

// All in one step: fields that go together may contradict each other in between.
Result<Done> SetFieldsByAddress(Session* session, const Parameters& p) {
  const std::vector<std::string> fields = p.names("fields"), values = p.names("values");
  if (fields.size() != values.size()) {
    return Refusal("values", "give as many values as fields");
  }
  return session->Edit(
      "Set fields",
      [&](Project* project) -> Result<Done> {
        for (size_t i = 0; i < fields.size(); ++i) {
          const Result<FieldAddress> address = ParseAddress(fields[i]);
          if (!address.ok()) return address.error();
          Result<Done> set = SetField(address.value(), values[i], project);
          if (!set.ok()) return set;
        }
        return Done();
      },
      p.text("drag"));
}

}  // namespace

std::vector<Operator> FieldOperators() {
  return {{"field.set",
           "Set fields",
           "Sets fields of the project by their addresses, such as regions[arms].friction.default.",
           {{"fields", kNames, true, "addresses"},
            {"values", kNames, true, "their values as in a file: 0.8, \"exact\", [1, 0, 0]"},
            kDrag},
           SetFieldsByAddress}};
}

}  // namespace hazumi::edit
