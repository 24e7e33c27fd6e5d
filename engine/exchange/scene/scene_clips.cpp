#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/base/utf8.h"
#include "engine/exchange/scene/character_parts.h"
#include "engine/exchange/scene/clip_sampler.h"

namespace hazumi {
namespace {

constexpr double kMostSamples = 20e6;  // of all clips, three for each bone and frame
constexpr double kStray = 10.0;        // ratio to the time of all other keys, and seconds
constexpr double kLate = 0.1;  // first key, of which it is said [s]: programs begin at frame 0 or 1

// The times of all keys [s], sorted, once each.
std::vector<double> KeyTimes(const std::vector<const NodeMotion*>& motions) {
  std::vector<double> times;
  for (const NodeMotion* motion : motions) motion->AddTimes(&times);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// A clip's name: as written, or by number, and by number where another has it.
std::string ClipName(const SceneClip& clip, size_t index, const std::vector<Clip>& before) {
  std::string name = ValidUtf8(clip.name);
  if (name.empty()) name = "clip " + std::to_string(index + 1);
  for (const Clip& other : before)
    if (other.name == name) return name + " (" + std::to_string(index + 1) + ")";
  return name;
}

class ClipReader {
 public:
  ClipReader(const SceneTree& tree, const SceneSkeleton& skeleton, double rate,
             const std::string& file, std::vector<Warning>* warnings)
      : tree_(tree), skeleton_(skeleton), rate_(rate), file_(file), warnings_(warnings) {}

  Result<Done> Add(const SceneClip& from, size_t index, std::vector<Clip>* clips) {
    Clip clip;
    clip.name = ClipName(from, index, *clips);
    ClipSampler sampler(tree_, skeleton_);
    for (const auto& [node, motion] : from.motions) {
      if (!motion->IsSound()) {
        return Wrong(clip.name + ": " + ValidUtf8(tree_.node(node).name),
                     "has key times that do not increase, or values that are not numbers");
      }
      sampler.Add(node, *motion);
    }
    if (sampler.motions().empty()) return Done{};  // it moves something else
    std::vector<double> times = KeyTimes(sampler.motions());
    if (times.empty()) times = {0.0};  // a pose
    if (Result<Done> timed = Time(from.likely_rate, times, &clip); !timed.ok()) return timed;
    clip.index = static_cast<int>(index);
    clip.start_s = times.front();
    clip.tracks = sampler.Sample(times.front(), clip.seconds_per_frame, clip.num_frames);
    clips->push_back(std::move(clip));
    return Done{};
  }

 private:
  Error Wrong(const std::string& clip, const std::string& message) const {
    return {ErrorCode::kSemantics, file_, "clip " + clip, message + "; export the animation again"};
  }

  // Frame rate and number of frames.
  Result<Done> Time(double likely_rate, const std::vector<double>& times, Clip* clip) {
    std::vector<double> seconds;
    seconds.reserve(times.size());
    for (const double time : times) seconds.push_back(time - times.front());
    double rate = rate_ > 0.0 ? rate_ : FrameRateOf(seconds, likely_rate);
    if (rate == 0.0) {
      rate = 30.0;
      warnings_->push_back({"clip " + clip->name,
                            "its keys lie on the frames of no usual rate; sampled 30 times a "
                            "second, so that what happens between is lost; to sample it otherwise, "
                            "give a rate (--fps)"});
    }
    const double frames = std::ceil(seconds.back() * rate - 0.02) + 1.0;
    samples_ += frames * 3.0 * static_cast<double>(skeleton_.bones.size());
    if (!(samples_ <= kMostSamples)) {
      return Error{ErrorCode::kSemantics, file_, "clip " + clip->name,
                   "lasts " + FormatShort(seconds.back()) + " s: " + FormatShort(frames) +
                       " frames of " + std::to_string(skeleton_.bones.size()) +
                       " bones, which with the clips before is more than is read; export a stretch "
                       "of it, or take fewer frames a second (--fps)"};
    }
    SayStrayKey(seconds, clip->name);
    if (times.front() >= kLate) {
      warnings_->push_back({"clip " + clip->name, "its first key is at " +
                                                      FormatShort(times.front()) +
                                                      " s; the time before is left out"});
    }
    clip->seconds_per_frame = 1.0 / rate;
    clip->num_frames = static_cast<int>(frames);
    return Done{};
  }

  // Reports a last key that comes so long after all others that it is probably a mistake.
  void SayStrayKey(const std::vector<double>& seconds, const std::string& clip) {
    if (seconds.size() < 3) return;
    const double before = seconds[seconds.size() - 2], after = seconds.back() - before;
    if (after < kStray * before || after < kStray) return;
    warnings_->push_back({"clip " + clip, "its last key comes " + FormatShort(after) +
                                              " s after all others; if it is there by mistake, "
                                              "delete it and export again"});
  }

  const SceneTree& tree_;
  const SceneSkeleton& skeleton_;
  const double rate_;  // [1/s]; 0: that of the keys
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
       {likely, 30.0, 24.0, 25.0, 60.0, 50.0, 48.0, 120.0, 100.0, 240.0, 90.0, 72.0, 75.0, 144.0,
        30000.0 / 1001.0, 24000.0 / 1001.0, 60000.0 / 1001.0, 120000.0 / 1001.0})
    if (fits(rate)) return rate;
  return 0.0;
}

Result<std::vector<Clip>> ReadClips(const SceneTree& tree, const SceneSkeleton& skeleton,
                                    double rate, const std::string& file,
                                    std::vector<Warning>* warnings) {
  ClipReader reader(tree, skeleton, rate, file, warnings);
  std::vector<Clip> clips;
  for (size_t i = 0; i < tree.scene.clips.size(); ++i) {
    if (Result<Done> added = reader.Add(tree.scene.clips[i], i, &clips); !added.ok())
      return added.error();
  }
  return clips;
}

}  // namespace hazumi
