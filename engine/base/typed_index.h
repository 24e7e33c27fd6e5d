#pragma once

#include <compare>
#include <ostream>

namespace hazumi {

// An array index that cannot be mistaken for another kind of index. Default: none (-1).
template <typename Tag>
class TypedIndex {
 public:
  constexpr TypedIndex() = default;
  constexpr explicit TypedIndex(int value) : value_(value) {}

  constexpr int value() const { return value_; }
  constexpr bool is_valid() const { return value_ >= 0; }
  constexpr auto operator<=>(const TypedIndex&) const = default;  // NOLINT(modernize-use-nullptr)

 private:
  int value_ = -1;
};

template <typename Tag>
std::ostream& operator<<(std::ostream& out, TypedIndex<Tag> index) {
  return out << index.value();
}

}  // namespace hazumi
