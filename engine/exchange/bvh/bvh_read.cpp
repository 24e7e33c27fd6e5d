#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/exchange/bvh/bvh_file.h"
#include "engine/exchange/bvh/bvh_motion.h"
#include "engine/exchange/bvh/bvh_scanner.h"
#include "engine/exchange/bvh/bvh_skeleton.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// What a text of another kind is, with what to do.
std::optional<Error> WhyNoText(std::string_view text) {
  const std::string_view start = text.substr(0, 2);
  if (start == "\xff\xfe" || start == "\xfe\xff")
    return BvhError(1, "the file is UTF-16 text; save it as UTF-8");
  int line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    const bool is_space = (c >= '\t' && c <= '\r') || c == '\x1a';
    if ((static_cast<unsigned char>(c) < 0x20 && !is_space) || c == '\x7f')
      return BvhError(line, "the file is binary, a BVH file is text; export it again as BVH");
  }
  return std::nullopt;
}

// The columns of one bone; -1: none.
struct BoneColumns {
  std::array<int, 3> positions = {-1, -1, -1};  // x y z
  std::array<int, 3> rotations = {-1, -1, -1};  // as written
  std::array<int, 3> axes = {-1, -1, -1};       // of the rotations
  int num_rotations = 0;
  bool has_position = false;
};

std::vector<BoneColumns> ColumnsOfBones(const BvhSkeleton& skeleton) {
  std::vector<BoneColumns> all(skeleton.bones.size());
  for (size_t i = 0; i < skeleton.channels.size(); ++i) {
    const BvhChannel& channel = skeleton.channels[i];
    BoneColumns& columns = all[static_cast<size_t>(channel.bone)];
    if (channel.is_rotation) {
      const auto k = static_cast<size_t>(columns.num_rotations++);
      columns.rotations[k] = static_cast<int>(i);
      columns.axes[k] = channel.axis;
    } else {
      columns.positions[static_cast<size_t>(channel.axis)] = static_cast<int>(i);
      columns.has_position = true;
    }
  }
  return all;
}

// Channels turn one after the other about the axes that the ones before have turned.
void AddRotation(const double* row, const BoneColumns& columns, BoneTrack* track) {
  Vec3 angles = Vec3::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (int k = 0; k < columns.num_rotations; ++k) {
    const auto i = static_cast<size_t>(k);
    angles[k] = row[columns.rotations[i]] * kDegree;
    turn = turn * Eigen::AngleAxisd(angles[k], Vec3::Unit(columns.axes[i]));
  }
  track->angles.push_back(angles);
  track->rotations.push_back(turn.normalized());
}

// Positions stand for the OFFSET, of any bone, and are not added to it.
void AddTranslation(const double* row, const BoneColumns& columns, BoneTrack* track) {
  Vec3 p = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const int column = columns.positions[static_cast<size_t>(axis)];
    if (column >= 0) p[axis] = row[column];
  }
  track->translations.push_back(p);
}

BoneTrack TrackOf(const BvhMotion& motion, size_t width, const BoneColumns& columns) {
  BoneTrack track;
  const auto num_frames = static_cast<size_t>(motion.num_frames);
  if (columns.num_rotations > 0) {
    track.rotations.reserve(num_frames);
    track.angles.reserve(num_frames);
  }
  if (columns.has_position) track.translations.reserve(num_frames);
  for (size_t frame = 0; frame < num_frames; ++frame) {
    const double* row = motion.values.data() + frame * width;
    if (columns.num_rotations > 0) AddRotation(row, columns, &track);
    if (columns.has_position) AddTranslation(row, columns, &track);
  }
  return track;
}

// With, say, a Yposition only, x and z are 0 and not those of the OFFSET.
void WarnOfPartPositions(const BvhSkeleton& skeleton, const std::vector<BoneColumns>& columns,
                         std::vector<Warning>* warnings) {
  for (size_t i = 0; i < columns.size(); ++i) {
    const Bone& bone = skeleton.bones[i];
    for (int axis = 0; axis < 3 && columns[i].has_position; ++axis) {
      if (columns[i].positions[static_cast<size_t>(axis)] >= 0 || bone.rest.p[axis] == 0.0)
        continue;
      warnings->push_back({LinePlace(skeleton.lines[i]),
                           QuotedWord(bone.name) + " has no " + ChannelName({0, axis, false}) +
                               " beside its other positions: it was taken as 0, not as in OFFSET"});
    }
  }
}

Result<Character> Read(std::string_view text, const std::string& name, const ReadChoice& choice) {
  if (std::optional<Error> error = WhyNoText(text)) return *error;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  while (text.ends_with('\x1a')) text.remove_suffix(1);  // the end of a text, once
  BvhScanner scanner(text);
  Character character;
  Result<BvhSkeleton> skeleton = ReadBvhSkeleton(&scanner, &character.warnings);
  if (!skeleton.ok()) return skeleton.error();
  Result<BvhMotion> motion = ReadBvhMotion(skeleton.value(), choice, &scanner, &character.warnings);
  if (!motion.ok()) return motion.error();

  const std::vector<BoneColumns> columns = ColumnsOfBones(skeleton.value());
  WarnOfPartPositions(skeleton.value(), columns, &character.warnings);
  Clip clip{name, motion.value().seconds_per_frame, motion.value().num_frames, {}};
  for (const BoneColumns& of_bone : columns)
    clip.tracks.push_back(TrackOf(motion.value(), skeleton.value().channels.size(), of_bone));
  character.name = name;
  character.bones = std::move(skeleton.value().bones);
  for (size_t b = 0; b < character.bones.size(); ++b)
    character.bones[b].source.node = static_cast<int>(b);
  character.clips.push_back(std::move(clip));
  return character;
}

}  // namespace

Result<Character> ReadBvh(std::string_view text, const std::string& file,
                          const ReadChoice& choice) {
  Result<Character> read = Read(text, std::filesystem::path(file).stem().string(), choice);
  if (read.ok()) return read;
  Error error = read.error();
  error.file = file;
  return error;
}

}  // namespace hazumi
