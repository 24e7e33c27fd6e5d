#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/same_bits.h"

namespace hazumi {

// What holds asked for and what they got, by hold, frame and side: after an edit most of them ask
// for the same again. An answer depends on nothing but the question, as numbers.
class KnownHolds {
 public:
  using Numbers = std::vector<double>;
  using Place = std::tuple<size_t, double, bool>;  // index of the hold, frame, whether before it

  // Null if something else was asked there, or nothing.
  const Numbers* Find(const Place& place, const Numbers& question) const {
    const auto known = calls_.find(place);
    const bool is_same = known != calls_.end() && SameBits(known->second.question, question);
    return is_same ? &known->second.answer : nullptr;
  }

  // Returns the answer.
  const Numbers* Keep(const Place& place, Numbers question, Numbers answer) {
    if (calls_.size() >= kMost) calls_.clear();
    Call& call = calls_[place];
    call = {std::move(question), std::move(answer)};
    return &call.answer;
  }

 private:
  static constexpr size_t kMost = 10000;  // about 10 MB
  struct Call {
    Numbers question, answer;
  };
  std::map<Place, Call> calls_;
};

}  // namespace hazumi
