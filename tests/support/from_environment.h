#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace hazumi::test {

// Number from the environment, or `otherwise`.
inline int FromEnvironment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

// Seeds of a random test: `for (const int seed : RandomCases(1, 10))`. Prints the seeds.
// HAZUMI_FIRST_CASE and HAZUMI_CASES replace the first seed and the count. A plain ctest uses the
// same seeds in every run; .ci/run and scripts/soak use new ones.
class RandomCases {
 public:
  RandomCases(int first, int count)
      : first_(FromEnvironment("HAZUMI_FIRST_CASE", first)),
        count_(std::max(0, FromEnvironment("HAZUMI_CASES", count))) {
    std::printf("seeds %d to %d: HAZUMI_FIRST_CASE=%d HAZUMI_CASES=%d tries them again\n", first_,
                first_ + count_ - 1, first_, count_);
    std::fflush(stdout);
  }

  class Iterator {
   public:
    explicit Iterator(int seed) : seed_(seed) {}
    int operator*() const { return seed_; }
    Iterator& operator++() {
      ++seed_;
      return *this;
    }
    bool operator==(const Iterator& other) const = default;

   private:
    int seed_;
  };

  Iterator begin() const { return Iterator(first_); }
  Iterator end() const { return Iterator(first_ + count_); }
  int first() const { return first_; }
  int count() const { return count_; }

 private:
  int first_, count_;
};

// Largest number of `count` cases that may fail where a share of all cases fails. For the seeds of
// a plain ctest, that share. For new seeds, the number that a Poisson distribution with that mean
// exceeds once in a hundred thousand runs.
inline int MostOf(int count, double share) {
  const double mean = count * share;
  if (std::getenv("HAZUMI_FIRST_CASE") == nullptr) return static_cast<int>(mean + 1e-9);
  int most = 0;
  double term = std::exp(-mean), below = term;
  while (below < 1.0 - 1e-5) {
    term *= mean / ++most;
    below += term;
  }
  return most;
}

}  // namespace hazumi::test
