#include "engine/project/address/all_addresses.h"

#include "engine/project/address/addressed_field.h"
#include "engine/project/items.h"
#include "engine/project/json/field_writer.h"

namespace hazumi {

namespace {

// An archive that writes down every field that an address can end in.
class FieldLister {
 public:
  template <typename T>
  using RefTo = const T&;

  FieldLister(std::string place, std::vector<ListedField>* fields)
      : place_(std::move(place)), fields_(fields) {}

  template <typename T>
  void Required(const Field& field, const T& value) {
    Add(At(field.name), value);
  }
  template <typename T>
  void Stated(const Field& field, const T& value) {
    Required(field, value);
  }
  template <typename T>
  void Optional(const Field& field, const T& value, const T& = T()) {
    Required(field, value);
  }
  template <typename T>
  void Literal(const char*, const T&) {}
  void Version(int) {}
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>& names, const std::variant<T...>& value) {
    std::visit([&](const auto& item) { Required({names[value.index()]}, item); }, value);
  }
  template <typename T, typename Fields>
  void Nested(const Field& field, const T& value, Fields fields) {
    AddBy(At(field.name), value, fields);
  }
  template <typename T, typename Fields>
  void List(const Field& field, const std::vector<T>& values, Fields fields) {
    AddItems(At(field.name), values, fields);
  }
  template <typename T, typename Fields>
  void OptionalList(const Field& field, const std::vector<T>& values, Fields fields) {
    List(field, values, fields);
  }
  template <typename T, typename Fields>
  void Map(const Field& field, const std::vector<Named<T>>& values, Fields fields) {
    AddItems(At(field.name), values,
             [&](auto& inner, const Named<T>& item) { fields(inner, item.value); });
  }

 private:
  std::string At(const char* name) const { return place_.empty() ? name : place_ + "." + name; }

  template <typename T, typename Fields>
  void AddBy(const std::string& place, const T& value, Fields fields) {
    FieldLister inner(place, fields_);
    fields(inner, value);
  }
  template <typename T, typename Fields>
  void AddItems(const std::string& place, const std::vector<T>& values, Fields fields) {
    const std::vector<std::string> names = ItemNames(values);
    for (size_t i = 0; i < values.size(); ++i) {
      AddBy(place + "[" + names[i] + "]", values[i], fields);
    }
  }

  template <typename T>
  void Add(const std::string& place, const T& value) {
    if constexpr (kIsOneValue<T>) {
      fields_->push_back({place, JsonOf(value)});
    } else if constexpr (std::is_same_v<T, std::vector<Named<double>>>) {
      for (const Named<double>& item : value) {
        fields_->push_back({place + "[" + item.name + "]", FormatNumber(item.value)});
      }
    } else if constexpr (requires { value.has_value(); }) {
      if (value) Add(place, *value);
    } else if constexpr (requires { value.begin(); }) {
      AddItems(place, value, [](auto& inner, const auto& item) { Describe(inner, item); });
    } else if constexpr (requires(FieldLister inner) { Describe(inner, value); }) {
      AddBy(place, value, [](auto& inner, const auto& item) { Describe(inner, item); });
    }
  }

  template <typename T>
  static std::string JsonOf(const T& value) {
    if constexpr (requires { value.has_value(); }) {
      return value ? JsonOf(*value) : "null";
    } else {
      return CompactJson(ToJson(value));
    }
  }

  std::string place_;
  std::vector<ListedField>* fields_;
};

}  // namespace

std::vector<ListedField> ListFields(const Project& project) {
  std::vector<ListedField> fields;
  FieldLister lister("", &fields);
  Describe(lister, project);
  return fields;
}

std::vector<ItemAddress> ItemAddresses(const Project& project) {
  std::vector<ItemAddress> addresses;
  ForEachItemList(
      [&](auto kind, const auto& items) {
        const std::vector<std::string> names = ItemNames(items);
        for (size_t i = 0; i < items.size(); ++i) {
          if (!items[i].identity.id.is_valid()) continue;
          addresses.push_back(
              {items[i].identity.id, std::string(kind.kList) + "[" + names[i] + "]"});
        }
      },
      project);
  return addresses;
}

}  // namespace hazumi
