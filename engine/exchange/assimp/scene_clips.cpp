#include "engine/exchange/assimp/scene_clips.h"

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/base/utf8.h"
#include "engine/exchange/assimp/clip_sampler.h"

namespace hazumi {
namespace {

constexpr double kMostSamples = 40e6;

double TicksPerSecond(const aiAnimation& animation) {
  const double rate = animation.mTicksPerSecond;
  return rate > 0.0 && rate < 1e9 ? rate : 25.0;  // assimp's word for "unknown"
}

// A single key says nothing of time: assimp puts one at 0 where a channel has none of a kind.
template <typename Key>
void AddTimes(const Key* keys, unsigned count, std::vector<double>* ticks) {
  if (count < 2) return;
  for (unsigned i = 0; i < count; ++i) ticks->push_back(keys[i].mTime);
}

// The times of all keys, sorted, once each.
std::vector<double> KeyTicks(const std::vector<const aiNodeAnim*>& channels) {
  std::vector<double> ticks;
  for (const aiNodeAnim* channel : channels) {
    AddTimes(channel->mPositionKeys, channel->mNumPositionKeys, &ticks);
    AddTimes(channel->mRotationKeys, channel->mNumRotationKeys, &ticks);
    AddTimes(channel->mScalingKeys, channel->mNumScalingKeys, &ticks);
  }
  std::sort(ticks.begin(), ticks.end());
  ticks.erase(std::unique(ticks.begin(), ticks.end()), ticks.end());
  return ticks;
}

// A clip's name: as written, or by number, and by number where another has it.
std::string ClipName(const aiAnimation& animation, size_t index, const std::vector<Clip>& before) {
  std::string name = ValidUtf8(animation.mName.C_Str());
  if (name.empty()) name = "clip " + std::to_string(index + 1);
  for (const Clip& clip : before)
    if (clip.name == name) return name + " (" + std::to_string(index + 1) + ")";
  return name;
}

class ClipReader {
 public:
  ClipReader(const SceneTree& tree, const SceneSkeleton& skeleton, bool ticks_are_frames,
             const SteppedChannels& stepped, const std::string& file,
             std::vector<Warning>* warnings)
      : tree_(tree),
        skeleton_(skeleton),
        ticks_are_frames_(ticks_are_frames),
        stepped_(stepped),
        file_(file),
        warnings_(warnings) {}

  Result<Done> Add(const aiAnimation& animation, size_t index, std::vector<Clip>* clips) {
    Clip clip;
    clip.name = ClipName(animation, index, *clips);
    ClipSampler sampler(tree_, skeleton_);
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
      const aiNodeAnim& channel = *animation.mChannels[c];
      if (!IsSoundChannel(channel)) {
        return Wrong(clip.name + ": " + ValidUtf8(channel.mNodeName.C_Str()),
                     "has key times that do not increase, or values that are not numbers");
      }
      sampler.AddChannel(channel, StepsOf(channel, index));
    }
    if (sampler.channels().empty()) return Done{};  // it moves something else
    std::vector<double> ticks = KeyTicks(sampler.channels());
    if (ticks.empty()) ticks = {0.0};  // a pose
    if (Result<Done> timed = Time(animation, ticks, &clip); !timed.ok()) return timed;
    const double ticks_per_frame = clip.seconds_per_frame * TicksPerSecond(animation);
    clip.tracks = sampler.Sample(ticks.front(), ticks_per_frame, clip.num_frames);
    clips->push_back(std::move(clip));
    return Done{};
  }

 private:
  Error Wrong(const std::string& clip, const std::string& message) const {
    return {ErrorCode::kSemantics, file_, "clip " + clip, message + "; export the animation again"};
  }

  ChannelSteps StepsOf(const aiNodeAnim& channel, size_t index) const {
    const std::string stem = std::to_string(index) + "/" + channel.mNodeName.C_Str() + "/";
    ChannelSteps steps;
    steps.translation = stepped_.contains(stem + "translation");
    steps.rotation = stepped_.contains(stem + "rotation");
    steps.scale = stepped_.contains(stem + "scale");
    return steps;
  }

  // Frame rate and number of frames.
  Result<Done> Time(const aiAnimation& animation, const std::vector<double>& ticks, Clip* clip) {
    const double per_second = TicksPerSecond(animation);
    std::vector<double> seconds;
    seconds.reserve(ticks.size());
    for (const double tick : ticks) seconds.push_back((tick - ticks.front()) / per_second);
    double rate = FrameRateOf(seconds, ticks_are_frames_ ? per_second : 0.0);
    if (rate == 0.0) {
      rate = 30.0;
      warnings_->push_back({"clip " + clip->name,
                            "its keys lie on the frames of no usual rate; sampled 30 times a "
                            "second, so that what happens between is lost"});
    }
    const double frames = std::ceil(seconds.back() * rate - 0.02) + 1.0;
    samples_ += frames * 3.0 * static_cast<double>(skeleton_.bones.size());
    if (!(samples_ <= kMostSamples)) {
      return Wrong(clip->name, "lasts " + FormatShort(seconds.back()) +
                                   " s, which with the clips before is more than is read");
    }
    clip->seconds_per_frame = 1.0 / rate;
    clip->num_frames = static_cast<int>(frames);
    return Done{};
  }

  const SceneTree& tree_;
  const SceneSkeleton& skeleton_;
  bool ticks_are_frames_;
  const SteppedChannels& stepped_;
  const std::string& file_;
  std::vector<Warning>* warnings_;
  double samples_ = 0.0;
};

}  // namespace

double FrameRateOf(const std::vector<double>& times, double likely) {
  // Times in single precision are off by less than this part of a frame.
  constexpr double kTolerance = 0.02;
  const auto fits = [&](double rate) {
    return rate > 0.0 && std::all_of(times.begin(), times.end(), [&](double time) {
             return std::abs(time * rate - std::round(time * rate)) < kTolerance;
           });
  };
  for (const double rate :
       {likely, 30.0, 24.0, 25.0, 60.0, 50.0, 48.0, 120.0, 100.0, 240.0, 30000.0 / 1001.0,
        24000.0 / 1001.0, 60000.0 / 1001.0, 120000.0 / 1001.0})
    if (fits(rate)) return rate;
  return 0.0;
}

Result<std::vector<Clip>> ReadClips(const aiScene& scene, const SceneTree& tree,
                                    const SceneSkeleton& skeleton, bool ticks_are_frames,
                                    const SteppedChannels& stepped, const std::string& file,
                                    std::vector<Warning>* warnings) {
  ClipReader reader(tree, skeleton, ticks_are_frames, stepped, file, warnings);
  std::vector<Clip> clips;
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    if (Result<Done> added = reader.Add(*scene.mAnimations[i], i, &clips); !added.ok())
      return added.error();
  }
  return clips;
}

}  // namespace hazumi
