#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/assert.h"
#include "engine/exchange/bvh/bvh_file.h"
#include "engine/spatial/euler_angles.h"

namespace hazumi {

namespace {

constexpr EulerAxes kUsualAxes = {2, 0, 1};

// A bone as it is written.
struct Column {
  Column(int of_bone, int at_depth) : bone(of_bone), depth(at_depth) {}

  int bone;   // -1: a root that all roots are put under
  int depth;  // 0: the root
  EulerAxes axes = kUsualAxes;
  bool has_positions = false;
  std::vector<Vec3> angles;  // [rad] a frame; none: no rotation
};

class BvhWriter {
 public:
  BvhWriter(const Character& character, const Clip& clip);
  std::string Write();

 private:
  void AddColumns(const std::vector<int>& roots);
  void SetRotations(Column* column) const;
  std::vector<Vec3> Decomposed(const Bone& bone, const BoneTrack& track,
                               const EulerAxes& axes) const;
  void WriteJoint(const Column& column);
  void WriteEndSite(const Column& column);
  void WriteChannels(const Column& column);
  void WriteRow(size_t frame);
  void WriteOffset(int depth, const Vec3& offset);
  void Indent(int depth) { text_.append(static_cast<size_t>(std::min(depth, 32)), '\t'); }
  void Number(double value);
  void Numbers(const Vec3& values);
  const Bone& bone(int i) const { return character_.bones[static_cast<size_t>(i)]; }
  const BoneTrack& track(int i) const { return clip_.tracks[static_cast<size_t>(i)]; }
  size_t num_frames() const { return static_cast<size_t>(clip_.num_frames); }

  const Character& character_;
  const Clip& clip_;
  std::vector<std::vector<int>> children_;  // by bone
  std::vector<Column> columns_;             // each before its children, which follow one by one
  std::string text_;
};

BvhWriter::BvhWriter(const Character& character, const Clip& clip)
    : character_(character), clip_(clip), children_(character.bones.size()) {
  HAZUMI_DEMAND_EQ(clip.tracks.size(), character.bones.size());
  std::vector<int> roots;
  for (size_t i = 0; i < character.bones.size(); ++i) {
    const int parent = character.bones[i].parent;
    (parent < 0 ? roots : children_[static_cast<size_t>(parent)]).push_back(static_cast<int>(i));
  }
  AddColumns(roots);
  for (Column& column : columns_) SetRotations(&column);
}

void BvhWriter::AddColumns(const std::vector<int>& roots) {
  const bool is_alone = roots.size() == 1;
  if (!is_alone) columns_.emplace_back(-1, 0).has_positions = true;
  std::vector<Column> waiting;
  for (auto i = roots.rbegin(); i != roots.rend(); ++i) waiting.emplace_back(*i, is_alone ? 0 : 1);
  while (!waiting.empty()) {
    Column next = waiting.back();
    waiting.pop_back();
    next.has_positions = next.depth == 0 || !track(next.bone).translations.empty();
    columns_.push_back(next);
    const std::vector<int>& children = children_[static_cast<size_t>(next.bone)];
    for (auto i = children.rbegin(); i != children.rend(); ++i)
      waiting.emplace_back(*i, next.depth + 1);
  }
}

void BvhWriter::SetRotations(Column* column) const {
  if (column->bone < 0) return;
  const Bone& written = bone(column->bone);
  const BoneTrack& moved = track(column->bone);
  const auto axes = EulerAxesOf(written.rotation_order);
  const bool is_known = axes && !written.rotation_order.empty();
  if (is_known) column->axes = *axes;
  if (is_known && moved.angles.size() == num_frames()) {
    column->angles = moved.angles;
  } else if (!moved.rotations.empty() || !written.rest.R.isIdentity(0.0)) {
    column->angles = Decomposed(written, moved, column->axes);
  }
}

std::vector<Vec3> BvhWriter::Decomposed(const Bone& written, const BoneTrack& moved,
                                        const EulerAxes& axes) const {
  std::vector<Vec3> all;
  all.reserve(num_frames());
  Vec3 angles = Vec3::Zero();
  for (size_t frame = 0; frame < num_frames(); ++frame) {
    const Mat3 R =
        moved.rotations.empty() ? written.rest.R : moved.rotations[frame].toRotationMatrix();
    angles = EulerAnglesNear(R, axes, angles);
    all.push_back(angles);
  }
  return all;
}

std::string BvhWriter::Write() {
  text_ = "HIERARCHY\n";
  for (size_t i = 0; i < columns_.size(); ++i) {
    WriteJoint(columns_[i]);
    const int next_depth = i + 1 < columns_.size() ? columns_[i + 1].depth : 0;
    if (next_depth <= columns_[i].depth) WriteEndSite(columns_[i]);
    for (int depth = columns_[i].depth; depth >= next_depth; --depth) {
      Indent(depth);
      text_ += "}\n";
    }
  }
  std::array<char, 400> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                 clip_.seconds_per_frame, std::chars_format::fixed)
                       .ptr;
  text_ += "MOTION\nFrames: " + std::to_string(clip_.num_frames) +
           "\nFrame Time: " + std::string(digits.data(), end) + "\n";
  for (size_t frame = 0; frame < num_frames(); ++frame) WriteRow(frame);
  return std::move(text_);
}

// A name fits on its line, without braces.
std::string WrittenName(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '{' || c == '}') c = '_';
  }
  return name;
}

// Up to what is inside: its "}" is still to come.
void BvhWriter::WriteJoint(const Column& column) {
  Indent(column.depth);
  text_ += column.depth == 0 ? "ROOT " : "JOINT ";
  text_ += column.bone < 0 ? "all_roots" : WrittenName(bone(column.bone).name);
  text_ += "\n";
  Indent(column.depth);
  text_ += "{\n";
  WriteOffset(column.depth + 1, column.bone < 0 ? Vec3::Zero() : bone(column.bone).rest.p);
  WriteChannels(column);
  if (column.bone >= 0 && bone(column.bone).end_site &&
      !children_[static_cast<size_t>(column.bone)].empty()) {
    WriteEndSite(column);
  }
}

void BvhWriter::WriteEndSite(const Column& column) {
  const Vec3 end =
      column.bone < 0 ? Vec3::Zero() : bone(column.bone).end_site.value_or(Vec3::Zero());
  Indent(column.depth + 1);
  text_ += "End Site\n";
  Indent(column.depth + 1);
  text_ += "{\n";
  WriteOffset(column.depth + 2, end);
  Indent(column.depth + 1);
  text_ += "}\n";
}

void BvhWriter::WriteChannels(const Column& column) {
  Indent(column.depth + 1);
  text_ += column.has_positions ? "CHANNELS 6 Xposition Yposition Zposition" : "CHANNELS 3";
  for (const int axis : column.axes) {
    text_ += ' ';
    text_ += "XYZ"[axis];
    text_ += "rotation";
  }
  text_ += "\n";
}

void BvhWriter::WriteOffset(int depth, const Vec3& offset) {
  Indent(depth);
  text_ += "OFFSET ";
  Numbers(offset);
  text_.back() = '\n';
}

void BvhWriter::WriteRow(size_t frame) {
  for (const Column& column : columns_) {
    if (column.has_positions) {
      const std::vector<Vec3>* moved = column.bone < 0 ? nullptr : &track(column.bone).translations;
      Numbers(!moved ? Vec3::Zero() : moved->empty() ? bone(column.bone).rest.p : (*moved)[frame]);
    }
    Numbers(column.angles.empty() ? Vec3::Zero()
                                  : Vec3(column.angles[frame] * (180.0 / std::numbers::pi)));
  }
  text_.back() = '\n';
}

void BvhWriter::Numbers(const Vec3& values) {
  for (const double value : values) Number(value);
}

// With a blank behind it.
void BvhWriter::Number(double value) {
  std::array<char, 400> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::fixed, 6)
                       .ptr;
  std::string_view number(digits.data(), static_cast<size_t>(end - digits.data()));
  if (number == "-0.000000") number.remove_prefix(1);
  text_ += number;
  text_ += ' ';
}

}  // namespace

std::string BvhText(const Character& character, const Clip& clip) {
  return BvhWriter(character, clip).Write();
}

}  // namespace hazumi
