#include "engine/exchange/import/clip_names.h"

#include <algorithm>

#include "engine/base/utf8.h"

namespace hazumi {

namespace {

constexpr size_t kMostBytes = 100;  // of a name
constexpr size_t kMostNames = 100;

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

}  // namespace hazumi
