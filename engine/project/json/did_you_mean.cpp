#include "engine/project/json/did_you_mean.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>

#include "engine/project/checks/checks.h"

namespace hazumi {

namespace {

constexpr size_t kLongestName = 64;  // longer ones are not worth comparing
constexpr size_t kMostListed = 12;

int FarthestSlip(std::string_view name) {
  if (name.size() < 2) return 0;
  return std::clamp(static_cast<int>(name.size()) / 3, 1, 3);
}

}  // namespace

int EditDistance(std::string_view a, std::string_view b) {
  // Rows of the table for the last two characters of a and for this one.
  std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const int replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replace, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::optional<std::string> Nearest(std::string_view name,
                                   const std::vector<std::string>& candidates) {
  if (name.size() > kLongestName) return std::nullopt;
  std::optional<std::string> nearest;
  int least = FarthestSlip(name) + 1;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > kLongestName) continue;
    // No distance is less than the difference in length.
    if (std::abs(std::ssize(candidate) - std::ssize(name)) >= least) continue;
    const int distance = EditDistance(name, candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

std::optional<std::string> NearestField(std::string_view name,
                                        const std::vector<std::string>& candidates) {
  if (auto nearest = Nearest(name, candidates)) return nearest;
  if (name.empty()) return std::nullopt;
  for (const std::string& candidate : candidates) {
    if (candidate.starts_with(name) && candidate[name.size()] == '_') return candidate;
  }
  return std::nullopt;
}

std::string NearestOf(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string_view compared = name.substr(0, kLongestName);
  std::string nearest;
  int least = std::numeric_limits<int>::max();
  for (const std::string& candidate : candidates) {
    const int distance = EditDistance(compared, candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string Suggestion(std::string_view name, const std::vector<std::string>& candidates) {
  if (const auto nearest = Nearest(name, candidates)) {
    return "did you mean " + Quoted(*nearest) + "?";
  }
  std::string text = "use one of ";
  const size_t listed = std::min(candidates.size(), kMostListed);
  for (size_t i = 0; i < listed; ++i) text += (i == 0 ? "" : ", ") + Quoted(candidates[i]);
  if (listed == candidates.size()) return text;
  return text + " (and " + std::to_string(candidates.size() - listed) + " more)";
}

}  // namespace hazumi
