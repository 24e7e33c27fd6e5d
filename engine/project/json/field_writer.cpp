#include "engine/project/json/field_writer.h"

namespace hazumi {

Json ToJson(double value) { return value; }
Json ToJson(int value) { return value; }
Json ToJson(bool value) { return value; }
Json ToJson(const std::string& value) { return value; }
Json ToJson(const char* value) { return value; }
Json ToJson(const Vec3& value) { return Json::array({value.x(), value.y(), value.z()}); }

Json ToJson(const JointRef& value) {
  if (!value.beyond) return value.name;
  return ObjectToJson(
      value, [](FieldWriter& out, const JointRef& ref) { out.Required({"beyond"}, ref.name); });
}

Json ToJson(const std::vector<Named<double>>& values) {
  Json object = Json::object();
  for (const Named<double>& item : values) object[item.name] = item.value;
  return object;
}

Json FromText(const std::string& json_text) {
  FirstError ignored;
  // Text that came from a file is good; other text is kept as a string rather than lost.
  return ParseJson(json_text, &ignored).value_or(Json(json_text));
}

}  // namespace hazumi
