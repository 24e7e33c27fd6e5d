#include "ui/edit/fields/item_fields.h"

#include <algorithm>
#include <mutex>
#include <set>

namespace hazumi::edit {

namespace {

bool Has(const ParameterInfos& infos, const std::string& name) {
  return std::any_of(infos.begin(), infos.end(),
                     [&](const ParameterInfo& info) { return name == info.name; });
}

bool IsAnyOf(const std::string& name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* other) { return name == other; });
}

}  // namespace

ParameterInfos Joined(std::initializer_list<ParameterInfos> lists) {
  ParameterInfos all;
  for (const ParameterInfos& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

ParameterInfos Requiring(std::initializer_list<const char*> names, ParameterInfos infos) {
  for (const char* name : names) HAZUMI_DEMAND(Has(infos, name));
  for (ParameterInfo& info : infos) info.is_required |= IsAnyOf(info.name, names);
  return infos;
}

ParameterInfos Only(std::initializer_list<const char*> names, ParameterInfos infos) {
  for (const char* name : names) HAZUMI_DEMAND(Has(infos, name));
  std::erase_if(infos, [&](const ParameterInfo& info) { return !IsAnyOf(info.name, names); });
  return infos;
}

Result<Done> ExpectOwn(const ParameterInfos& own, const ParameterInfos& all,
                       const Parameters& given, const char* message) {
  for (const ParameterInfo& info : all) {
    if (!given.has(info.name) || Has(own, info.name)) continue;
    return Error{ErrorCode::kSchema, "", info.name, message};
  }
  return Done();
}

const char* NameOfAxis(const char* parameter, char axis) {
  static std::mutex mutex;
  static std::set<std::string> names;
  std::string name = parameter;
  std::replace(name.begin(), name.end(), '?', axis);
  const std::lock_guard lock(mutex);
  return names.insert(std::move(name)).first->c_str();
}

std::string NameOf(const JointRef& ref) { return ref.name + (ref.beyond ? "+" : ""); }

void ParameterList::operator()(const Field& field, const Vec3&) {
  for (const char axis : {'x', 'y', 'z'}) {
    Put({NameOfAxis(ParameterOf(field), axis),
         ParameterKind::kNumber,
         false,
         field.help,
         {},
         field.label,
         field.unit,
         field.range});
  }
}

void ParameterList::Add(const Field& field, ParameterKind kind, const char* words) {
  Offer offer(words);
  offer.thing = field.thing;
  Put({ParameterOf(field), kind, false, field.help, offer, field.label, field.unit, field.range});
}

void ParameterList::Put(ParameterInfo info) {
  if (!Has(infos, info.name)) infos.push_back(info);
}

void FieldSetter::operator()(const Field& field, Vec3& value) {
  for (int i = 0; i < 3; ++i) {
    value[i] = p_.number(NameOfAxis(ParameterOf(field), field.axes[i]), value[i]);
  }
}

void FieldSetter::operator()(const Field& field, std::vector<JointRef>& value) {
  if (!p_.has(Name(field))) return;
  value.clear();
  for (std::string& name : p_.names(Name(field))) value.push_back({std::move(name), false, {}});
}

void FieldSetter::Refuse(const Field& field, const std::string& word, const char* words) {
  if (error_) return;
  std::string list;
  for (const std::string& other : hazumi::edit::WordsOf(Offer(words))) {
    list += (list.empty() ? "" : ", ") + other;
  }
  error_ = Error{ErrorCode::kSchema, "", Name(field), "\"" + word + "\" is none of " + list};
}

Json JsonOf(double value) { return value; }
Json JsonOf(int value) { return value; }
Json JsonOf(bool value) { return value; }
Json JsonOf(const std::string& value) { return value; }
Json JsonOf(const std::vector<JointRef>& value) {
  Json names = Json::array();
  for (const JointRef& ref : value) names.push_back(NameOf(ref));
  return names;
}

}  // namespace hazumi::edit
