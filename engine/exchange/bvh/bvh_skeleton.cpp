#include "engine/exchange/bvh/bvh_skeleton.h"

#include <cmath>
#include <optional>
#include <utility>

#include "engine/base/utf8.h"
#include "engine/exchange/bvh/bvh_names.h"

namespace hazumi {

namespace {

// A "{" that waits for its "}".
struct Open {
  int bone = 0;  // the joint, or the joint whose end site it is
  int line = 0;
  bool is_end_site = false;
  bool has_offset = false, has_channels = false;
  bool has_child = false;  // or an end site
};

bool IsStructure(std::string_view word) {
  for (const char* keyword : {"", "{", "}", "root", "joint", "end", "offset", "channels", "motion"})
    if (IsKeyword(word, keyword)) return true;
  return false;
}

class SkeletonReader {
 public:
  SkeletonReader(BvhScanner* scanner, std::vector<Warning>* warnings)
      : scanner_(*scanner), warnings_(*warnings) {}

  Result<BvhSkeleton> Read();

 private:
  Result<Done> Take(std::string_view word);
  Result<Done> OpenJoint(bool is_root);
  Result<Done> CheckRoom() const;
  void AddBone(std::string_view name);
  Result<Done> OpenEndSite();
  Result<Done> ExpectBrace(const std::string& what);
  Result<Done> Close();
  Result<Done> ReadOffset();
  Result<Done> ReadChannels();
  Result<Done> AddChannel(std::string_view word);
  bool IsLastWord() const;
  Error CutShort() const;
  Error Unclosed() const;
  void WarnOfOpenEnds();
  void Warn(int line, std::string message) {
    warnings_.push_back({LinePlace(line), std::move(message)});
  }
  Error Fault(std::string message) const { return BvhError(scanner_.line(), std::move(message)); }
  std::string NameOf(const Open& open) const {
    const std::string name = QuotedWord(bones()[static_cast<size_t>(open.bone)].name);
    return open.is_end_site ? "the End Site of " + name : name;
  }
  const std::vector<Bone>& bones() const { return skeleton_.bones; }

  BvhScanner& scanner_;
  std::vector<Warning>& warnings_;
  BvhSkeleton skeleton_;
  std::vector<Open> open_;
  std::vector<int> open_ends_;  // bones without child or end site
};

Result<BvhSkeleton> SkeletonReader::Read() {
  const std::string_view first = scanner_.Word();
  if (!IsKeyword(first, "hierarchy")) {
    return Fault((first.empty() ? "the file is empty" : "it begins with " + QuotedWord(first)) +
                 ", a BVH file begins with HIERARCHY; export it again as BVH");
  }
  while (true) {
    const std::string_view word = scanner_.Word();
    if (word.empty()) return CutShort();
    if (IsKeyword(word, "motion") && open_.empty() && !bones().empty()) break;
    Result<Done> taken = Take(word);
    if (!taken.ok()) return IsLastWord() ? CutShort() : taken.error();
  }
  WarnOfOpenEnds();
  for (const RenamedBone& renamed : MakeNamesUnique(&skeleton_.bones)) {
    Warn(skeleton_.lines[renamed.bone], "a second joint " + QuotedWord(renamed.old_name) +
                                            " was renamed " +
                                            QuotedWord(bones()[renamed.bone].name));
  }
  return std::move(skeleton_);
}

Result<Done> SkeletonReader::Take(std::string_view word) {
  if (IsKeyword(word, "root")) return OpenJoint(true);
  if (IsKeyword(word, "motion")) {
    return open_.empty() ? Fault("MOTION comes before any ROOT; export the file again")
                         : Unclosed();
  }
  if (word == "}") return Close();
  if (open_.empty()) {
    return Fault(
        QuotedWord(word) +
        (bones().empty() ? " stands where ROOT should be" : " stands where MOTION should be") +
        "; correct the hierarchy or export the file again");
  }
  if (IsKeyword(word, "joint")) return OpenJoint(false);
  if (IsKeyword(word, "end")) return OpenEndSite();
  if (IsKeyword(word, "offset")) return ReadOffset();
  if (IsKeyword(word, "channels")) return ReadChannels();
  return Fault(QuotedWord(word) + " in " + NameOf(open_.back()) +
               " is none of OFFSET, CHANNELS, JOINT, End Site and \"}\"; correct it");
}

Result<Done> SkeletonReader::OpenJoint(bool is_root) {
  const int line = scanner_.line();
  const std::string_view name = scanner_.RestOfLine();
  if (name.empty()) return Fault("a joint has no name; write one after ROOT or JOINT");
  if (is_root && !bones().empty()) {
    return BvhError(line,
                    "a second root " + QuotedWord(name) + " after " + QuotedWord(bones()[0].name) +
                        "; one file holds one character, so parent both to one root or export "
                        "them one by one",
                    ErrorCode::kSemantics);
  }
  if (!is_root && open_.back().is_end_site)
    return Fault("joint " + QuotedWord(name) + " is inside an End Site; move it out");
  Result<Done> room = CheckRoom();
  if (!room.ok()) return room;
  AddBone(name);
  return ExpectBrace("joint " + QuotedWord(name));
}

// For one joint more.
Result<Done> SkeletonReader::CheckRoom() const {
  if (static_cast<int>(bones().size()) >= kMaxBvhJoints) {
    return Fault("more than " + std::to_string(kMaxBvhJoints) +
                 " joints; export only the bones of the skeleton");
  }
  if (static_cast<int>(open_.size()) >= kMaxBvhDepth) {
    return Fault("more than " + std::to_string(kMaxBvhDepth) +
                 " joints inside one another; export only the bones of the skeleton");
  }
  return Done{};
}

void SkeletonReader::AddBone(std::string_view name) {
  Bone bone;
  bone.name = ValidUtf8(name);
  const int line = scanner_.line();
  if (bone.name != name) Warn(line, "a name is not UTF-8 and was read as " + QuotedWord(bone.name));
  if (!open_.empty()) {
    bone.parent = open_.back().bone;
    open_.back().has_child = true;
  }
  skeleton_.bones.push_back(std::move(bone));
  skeleton_.lines.push_back(line);
  open_.push_back({static_cast<int>(bones().size()) - 1, line});
}

// "End Site", and by some programs "End Site NAME" or "End NAME": the name says nothing.
Result<Done> SkeletonReader::OpenEndSite() {
  const int line = scanner_.line();
  scanner_.RestOfLine();
  Open& joint = open_.back();
  if (joint.is_end_site) return Fault("an End Site is inside an End Site; move it out");
  joint.has_child = true;
  const int bone = joint.bone;
  open_.push_back({bone, line, true});
  return ExpectBrace(NameOf(open_.back()));
}

Result<Done> SkeletonReader::ExpectBrace(const std::string& what) {
  const std::string_view word = scanner_.Word();
  if (word == "{") return Done{};
  if (word.empty()) return CutShort();
  return Fault("a \"{\" is missing after " + what + "; add it");
}

Result<Done> SkeletonReader::Close() {
  if (open_.empty()) {
    return Fault("a \"}\" more than there are \"{\"; remove it or export the file again");
  }
  const Open closed = open_.back();
  open_.pop_back();
  if (!closed.has_offset)
    Warn(closed.line, NameOf(closed) + " has no OFFSET and is put on its parent");
  if (!closed.is_end_site && !closed.has_child) open_ends_.push_back(closed.bone);
  return Done{};
}

Result<Done> SkeletonReader::ReadOffset() {
  Open& open = open_.back();
  if (open.has_offset) return Fault(NameOf(open) + " has two OFFSETs; remove one");
  open.has_offset = true;
  Vec3 offset = Vec3::Zero();
  for (double& x : offset) {
    const std::string_view word = scanner_.Word();
    if (word.empty()) return CutShort();
    if (!ParseBvhNumber(word, &x) || !(std::abs(x) <= kMaxBvhLength))
      return Fault("OFFSET of " + NameOf(open) + ": " + WhyNoBvhNumber(word, kMaxBvhLength));
  }
  Bone& bone = skeleton_.bones[static_cast<size_t>(open.bone)];
  if (!open.is_end_site) {
    bone.rest.p = offset;
  } else if (!bone.end_site) {
    bone.end_site = offset;
  } else {
    Warn(open.line, "a further End Site of " + QuotedWord(bone.name) + " was left out");
  }
  return Done{};
}

Result<Done> SkeletonReader::ReadChannels() {
  Open& open = open_.back();
  const int line = scanner_.line();
  if (open.has_channels) return Fault(NameOf(open) + " has two lines of CHANNELS; remove one");
  open.has_channels = true;
  const std::string_view count = scanner_.Word();
  double said = 0.0;
  if (!ParseBvhNumber(count, &said)) {
    return Fault("CHANNELS of " + NameOf(open) + " begins with " + QuotedWord(count) +
                 ", not with their number; add it");
  }
  const size_t before = skeleton_.channels.size();
  while (true) {
    BvhScanner ahead = scanner_;
    const std::string_view word = ahead.Word();
    if (IsStructure(word)) break;
    scanner_ = ahead;
    Result<Done> added = AddChannel(word);
    if (!added.ok()) return added;
  }
  const size_t named = skeleton_.channels.size() - before;
  if (said != static_cast<double>(named)) {
    Warn(line, "CHANNELS of " + NameOf(open) + " says " + std::string(count) + " and names " +
                   std::to_string(named) + ": the names were taken");
  }
  return Done{};
}

Result<Done> SkeletonReader::AddChannel(std::string_view word) {
  const Open& open = open_.back();
  std::optional<BvhChannel> channel = ChannelNamed(word);
  if (!channel) {
    return Fault("unknown channel " + QuotedWord(word) + " of " + NameOf(open) +
                 "; there are Xposition to Zposition and Xrotation to Zrotation");
  }
  channel->bone = open.bone;
  if (open.is_end_site) return Fault("an End Site has channels; make it a JOINT");
  const std::vector<BvhChannel>& all = skeleton_.channels;
  for (auto other = all.rbegin(); other != all.rend() && other->bone == channel->bone; ++other) {
    if (other->axis == channel->axis && other->is_rotation == channel->is_rotation)
      return Fault(NameOf(open) + " has " + ChannelName(*channel) + " twice; remove one");
  }
  Bone& bone = skeleton_.bones[static_cast<size_t>(channel->bone)];
  if (channel->is_rotation) bone.rotation_order += "XYZ"[channel->axis];
  skeleton_.channels.push_back(*channel);
  return Done{};
}

// What is wrong with the last word of all is that it was cut.
bool SkeletonReader::IsLastWord() const {
  BvhScanner ahead = scanner_;
  return !open_.empty() && !bones().empty() && ahead.Word().empty();
}

Error SkeletonReader::CutShort() const {
  if (open_.empty()) {
    return Fault(bones().empty() ? "the file has no ROOT; export it again"
                                 : "the file has no MOTION; export it with its animation");
  }
  return Fault("the file ends inside " + NameOf(open_.back()) + " of line " +
               std::to_string(open_.back().line) +
               ": it was cut or a \"}\" is missing; export it again");
}

Error SkeletonReader::Unclosed() const {
  return Fault("MOTION begins, but " + std::to_string(open_.size()) +
               " \"{\" are not closed, the last that of " + NameOf(open_.back()) + " in line " +
               std::to_string(open_.back().line) + "; add the missing \"}\"");
}

void SkeletonReader::WarnOfOpenEnds() {
  if (open_ends_.empty()) return;
  std::string names;
  for (size_t i = 0; i < open_ends_.size() && i < 8; ++i)
    names += (i ? ", " : "") + QuotedWord(bones()[static_cast<size_t>(open_ends_[i])].name);
  if (open_ends_.size() > 8) names += " and others";
  Warn(skeleton_.lines[static_cast<size_t>(open_ends_[0])],
       "no End Site says how long these bones are: " + names);
}

}  // namespace

Result<BvhSkeleton> ReadBvhSkeleton(BvhScanner* scanner, std::vector<Warning>* warnings) {
  return SkeletonReader(scanner, warnings).Read();
}

}  // namespace hazumi
