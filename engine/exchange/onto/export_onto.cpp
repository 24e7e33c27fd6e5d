#include "engine/exchange/onto/export_onto.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/base/input_files.h"
#include "engine/base/text.h"
#include "engine/exchange/onto/bvh_onto.h"
#include "engine/exchange/onto/edited_bones.h"
#include "engine/exchange/onto/gltf_onto.h"
#include "engine/exchange/read_character.h"
#include "engine/exchange/reader/whole_file.h"

namespace hazumi {

namespace {

namespace fs = std::filesystem;

constexpr double kSameRate = 1e-6;  // relative

std::string SuffixOf(const std::string& path) {
  return LowerCase(fs::path(path).extension().string());
}

Error InFile(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

// At the rate of the motion: its frames are the clip's then.
Result<Character> ReadAt(const FrameRate& rate, const OntoOptions& options) {
  const ImportOptions& how = options.how;
  ReadOptions reading = ReadOptionsFor(how);
  reading.is_cancelled = options.is_cancelled;
  Result<Character> source = ReadCharacter(options.source, reading);
  if (!source.ok()) return source;
  const double seconds = rate.seconds_per_frame();
  const auto& clips = source.value().clips;
  const auto named = std::find_if(clips.begin(), clips.end(), [&](const Clip& clip) {
    return how.clip.empty() || clip.name == how.clip;
  });
  if (named == clips.end() || std::abs(named->seconds_per_frame - seconds) <= kSameRate * seconds)
    return source;
  reading.rate = rate.frames_per_second();
  return ReadCharacter(options.source, reading);
}

std::optional<Error> WhyNotThere(const OntoOptions& options, const std::string& bytes,
                                 CharacterFormat format) {
  const auto wrong = [&](const std::string& message) {
    return Error{ErrorCode::kCannotWrite, options.output, "", message};
  };
  if (FollowLinks(options.output) == FollowLinks(options.source))
    return wrong("is the file that the motion is put into; name another, it is kept");
  const std::string wanted = SuffixOf(options.source);
  if (SuffixOf(options.output) != wanted)
    return wrong("a file that is put into " + options.source + " has to end in " + wanted);
  if (format != CharacterFormat::kGltf && format != CharacterFormat::kGlb) return std::nullopt;
  const Result<bool> beside = HasFilesBeside(bytes);
  if (!beside.ok()) return InFile(beside.error(), options.source);
  const fs::path from = fs::path(FollowLinks(options.source)).parent_path();
  const fs::path to = fs::path(FollowLinks(options.output)).parent_path();
  if (!beside.value() || from == to) return std::nullopt;
  return wrong("would miss the pictures or buffers that lie beside " + options.source +
               "; name a file in the same folder");
}

}  // namespace

bool CanBeOnto(const std::string& path) {
  const std::string suffix = SuffixOf(path);
  return suffix == ".glb" || suffix == ".gltf" || suffix == ".vrm" || suffix == ".bvh";
}

Result<OntoFile> ExportOnto(const Animation& animation, const Motion& motion,
                            const OntoOptions& options) {
  const Result<Character> source = ReadAt(motion.rate, options);
  if (!source.ok()) return source.error();
  const Result<std::string> bytes = WholeFile(options.source, kLongestFile);
  if (!bytes.ok()) return bytes.error();
  const Result<CharacterFormat> format =
      FormatOf(ReadUse::kCharacter, bytes.value(), options.source);
  if (!format.ok()) return format.error();
  if (auto error = WhyNotThere(options, bytes.value(), format.value())) return *error;
  const Result<EditedClip> edited =
      EditedBonesOf(source.value(), options.how, *animation.figure, motion);
  if (!edited.ok()) return InFile(edited.error(), options.source);
  Result<std::string> written = Error{ErrorCode::kSemantics, options.source, "",
                                      std::string(FormatName(format.value())) +
                                          " is not written; motion can be put into glTF, GLB, VRM "
                                          "and BVH, or be exported by itself"};
  if (format.value() == CharacterFormat::kBvh)
    written = BvhOnto(bytes.value(), source.value(), edited.value());
  if (format.value() == CharacterFormat::kGltf || format.value() == CharacterFormat::kGlb)
    written = GltfOnto(bytes.value(), edited.value());
  if (!written.ok()) return InFile(written.error(), options.source);
  OntoFile file = {std::move(written).value(), {}};
  for (const EditedBone& bone : edited.value().bones) file.bones.push_back(bone.name);
  return file;
}

}  // namespace hazumi
