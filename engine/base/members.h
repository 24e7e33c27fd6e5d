#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/typed_index.h"

// Values compared bit by bit, NaN and the sign of zero included, so that caches answer
// what was asked and nothing that only looks like it. A struct takes part by a function beside it
// that names all its members by a structured binding,
//
//   inline auto MembersOf(const Point& p) {
//     const auto& [x, y] = p;
//     return std::tie(x, y);
//   }
//
// which does not compile once a member is added, until that is named there too.

namespace hazumi {

template <typename T>
concept HasMembers = std::is_class_v<T> && requires(const T& x) {
  MembersOf(x);
};
template <typename T>
concept IsNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class BitComparison {
 public:
  template <IsNumber T>
  bool operator()(const T& a, const T& b) const {
    return AreSame(&a, &b, 1);
  }
  template <typename Tag>
  bool operator()(TypedIndex<Tag> a, TypedIndex<Tag> b) const {
    return a == b;
  }
  template <typename T, int kRows, int kCols, int kOptions, int kMaxRows, int kMaxCols>
  bool operator()(const Eigen::Matrix<T, kRows, kCols, kOptions, kMaxRows, kMaxCols>& a,
                  const Eigen::Matrix<T, kRows, kCols, kOptions, kMaxRows, kMaxCols>& b) const {
    return a.rows() == b.rows() && a.cols() == b.cols() && AreSame(a.data(), b.data(), a.size());
  }
  template <typename T, size_t kSize>
  bool operator()(const std::array<T, kSize>& a, const std::array<T, kSize>& b) const {
    return AreSame(a.data(), b.data(), kSize);
  }
  template <typename T>
  bool operator()(const std::vector<T>& a, const std::vector<T>& b) const {
    return a.size() == b.size() && AreSame(a.data(), b.data(), a.size());
  }
  template <typename T>
  bool operator()(const std::optional<T>& a, const std::optional<T>& b) const {
    return a.has_value() == b.has_value() && (!a || (*this)(*a, *b));
  }
  template <typename T>
  bool operator()(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) const {
    return a == b || (a && b && (*this)(*a, *b));
  }
  template <typename... T>
  bool operator()(const std::variant<T...>& a, const std::variant<T...>& b) const {
    if (a.index() != b.index()) return false;
    return std::visit(
        [&](const auto& own) {
          return (*this)(own, *std::get_if<std::decay_t<decltype(own)>>(&b));
        },
        a);
  }
  template <HasMembers T>
  bool operator()(const T& a, const T& b) const {
    const auto members = MembersOf(a), others = MembersOf(b);
    return [&]<size_t... I>(std::index_sequence<I...>) {
      return ((*this)(std::get<I>(members), std::get<I>(others)) && ...);
    }
    (std::make_index_sequence<std::tuple_size_v<decltype(members)>>());
  }

 private:
  template <typename T>
  bool AreSame(const T* a, const T* b, size_t count) const {
    if constexpr (IsNumber<T>) {
      return count == 0 || std::memcmp(a, b, count * sizeof(T)) == 0;
    } else {
      for (size_t i = 0; i < count; ++i) {
        if (!(*this)(a[i], b[i])) return false;
      }
      return true;
    }
  }
};

template <typename T>
bool SameBits(const T& a, const T& b) {
  return BitComparison()(a, b);
}

}  // namespace hazumi
