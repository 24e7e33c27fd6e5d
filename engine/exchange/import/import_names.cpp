#include "engine/exchange/import/import_names.h"

#include <algorithm>
#include <unordered_set>

#include "engine/base/utf8.h"

namespace hazumi {

namespace {

constexpr size_t kMostBytes = 100;  // of a name
constexpr size_t kMostNames = 100;

constexpr size_t kLongest = 200;  // bytes
// All that a joint's hinges may be called.
constexpr const char* kHinges[] = {
    "x",         "y",         "z",         "flexion",   "bend",        "rotation", "abduction",
    "pronation", "deviation", "inversion", "elevation", "protraction", "spread"};

std::string Cleaned(const std::string& bone) {
  std::string name = bone.substr(0, kLongest);
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '_';
  }
  while (name.ends_with('+')) name.pop_back();
  return name.empty() ? "bone" : ValidUtf8(name);
}

class TakenNames {
 public:
  std::string Claim(const std::string& name, bool has_hinges) {
    std::string own = name;
    for (int i = 2; !IsFree(own, has_hinges); ++i) own = name + "_" + std::to_string(i);
    Take(own, has_hinges);
    return own;
  }

 private:
  bool IsFree(const std::string& name, bool has_hinges) const {
    if (taken_.contains(name)) return false;
    return !has_hinges ||
           std::none_of(std::begin(kHinges), std::end(kHinges), [&](const std::string& hinge) {
             return taken_.contains(name + "_" + hinge);
           });
  }

  void Take(const std::string& name, bool has_hinges) {
    taken_.insert(name);
    if (!has_hinges) return;
    for (const char* hinge : kHinges) taken_.insert(name + "_" + hinge);
  }

  std::unordered_set<std::string> taken_;
};

}  // namespace

std::string Quoted(const std::string& name) {
  if (name.size() <= kMostBytes) return "\"" + name + "\"";
  size_t end = kMostBytes;
  while (end > 0 && (name[end] & 0xC0) == 0x80) --end;  // not within a letter
  return "\"" + ValidUtf8(name.substr(0, end)) + "...\"";
}

std::string NamesOf(const std::vector<Clip>& clips) {
  std::string names;
  for (size_t i = 0; i < std::min(clips.size(), kMostNames); ++i)
    names += (i > 0 ? ", " : "") + Quoted(clips[i].name);
  if (clips.size() > kMostNames)
    names += " and " + std::to_string(clips.size() - kMostNames) + " more";
  return names;
}

std::string HingeName(int axis) { return std::string(1, "xyz"[axis]); }

std::vector<std::string> FigureNames(const std::vector<std::string>& bones, ImportReport* report) {
  TakenNames taken;
  std::vector<std::string> names;
  for (const std::string& bone : bones) {
    const bool has_hinges = !names.empty();
    names.push_back(taken.Claim(Cleaned(bone), has_hinges));
    if (names.back() == bone) continue;
    report->warnings.push_back({ValidUtf8(bone), "is called \"" + names.back() +
                                                     "\" here: a name must be one that nothing "
                                                     "else has, not empty, and must not end in +"});
  }
  return names;
}

}  // namespace hazumi
