#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace hazumi {

constexpr int kMaxLanes = 4;

// Numbers that vector instructions read and write, aligned for them.
class LaneArray {
 public:
  LaneArray() = default;
  // Zeros.
  explicit LaneArray(size_t size)
      : chunks_((size + kMaxLanes - 1) / kMaxLanes, Chunk{}), size_(size) {}
  // Anything, until it is written: for what is large.
  static LaneArray Unset(size_t size) {
    LaneArray unset;
    unset.chunks_.resize((size + kMaxLanes - 1) / kMaxLanes);
    unset.size_ = size;
    return unset;
  }
  size_t size() const { return size_; }
  // Null if it is empty.
  double* data() { return reinterpret_cast<double*>(chunks_.data()); }
  const double* data() const { return reinterpret_cast<const double*>(chunks_.data()); }

 private:
  struct alignas(32) Chunk {
    double values[kMaxLanes];
  };
  // Leaves as it is what is made without a value.
  struct Allocator : std::allocator<Chunk> {
    template <typename Made>
    void construct(Made* at) {
      ::new (static_cast<void*>(at)) Made;
    }
    template <typename Made, typename... Values>
    void construct(Made* at, Values&&... values) {
      ::new (static_cast<void*>(at)) Made(std::forward<Values>(values)...);
    }
    template <typename Other>
    struct rebind {
      using other = Allocator;
    };
  };
  std::vector<Chunk, Allocator> chunks_;
  size_t size_ = 0;
};

}  // namespace hazumi
