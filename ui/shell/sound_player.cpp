#include "ui/shell/sound_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/shell/openal.h"

namespace hazumi::ui {

namespace {

constexpr double kOff = 0.06;            // from where it should be, at most [s]
constexpr double kShortestHeard = 0.06;  // of what is heard of a frame [s]
constexpr float kLoudest = 16.0f;        // as much as a project's gain can be, 24 dB

ALenum FormatOf(const SoundFormat& format) {
  return format.channels == 1 ? AL_FORMAT_MONO16 : AL_FORMAT_STEREO16;
}

double Seconds(const Sound& sound) {
  return static_cast<double>(sound.samples.size()) / sound.format.channels / sound.format.rate;
}

}  // namespace

// One source, and two buffers: all of the sound, and a moment of it.
class SoundPlayer::Device {
 public:
  // Null if there is none.
  static std::unique_ptr<Device> Open() {
    const OpenAl* al = LoadOpenAl();
    ALCdevice* device = al ? al->alcOpenDevice(nullptr) : nullptr;
    if (device == nullptr) return nullptr;
    ALCcontext* context = al->alcCreateContext(device, nullptr);
    if (context == nullptr || al->alcMakeContextCurrent(context) == ALC_FALSE) {
      if (context != nullptr) al->alcDestroyContext(context);
      al->alcCloseDevice(device);
      return nullptr;
    }
    return std::unique_ptr<Device>(new Device(*al, device, context));
  }

  ~Device() {
    al_.alDeleteSources(1, &source_);
    al_.alDeleteBuffers(2, buffers_);
    al_.alcMakeContextCurrent(nullptr);
    al_.alcDestroyContext(context_);
    al_.alcCloseDevice(device_);
  }

  void Take(const Sound& sound) {
    Stop();
    Fill(kAll, sound, 0, sound.samples.size());
  }

  void Play(double at) {
    Stop();
    al_.alSourcei(source_, AL_BUFFER, static_cast<ALint>(buffers_[kAll]));
    al_.alSourcef(source_, AL_SEC_OFFSET, static_cast<float>(at));
    al_.alSourcePlay(source_);
    is_playing_ = true;
  }

  // From one instant to another [s].
  void PlayMoment(const Sound& sound, double from, double to) {
    Stop();
    const auto place = [&](double seconds) {
      const double sample = std::clamp(seconds, 0.0, Seconds(sound)) * sound.format.rate;
      return static_cast<size_t>(sample) * sound.format.channels;
    };
    if (place(to) <= place(from)) return;
    Fill(kMoment, sound, place(from), place(to));
    al_.alSourcei(source_, AL_BUFFER, static_cast<ALint>(buffers_[kMoment]));
    al_.alSourcePlay(source_);
  }

  void Stop() {
    al_.alSourceStop(source_);
    al_.alSourcei(source_, AL_BUFFER, 0);
    is_playing_ = false;
  }

  void SetGain(double gain) { al_.alSourcef(source_, AL_GAIN, static_cast<float>(gain)); }
  // All of it, not a moment.
  bool is_playing() const { return is_playing_ && is_heard(); }
  bool is_heard() const {
    ALint state = AL_STOPPED;
    al_.alGetSourcei(source_, AL_SOURCE_STATE, &state);
    return state == AL_PLAYING;
  }
  double position() const {
    ALfloat seconds = 0.0f;
    al_.alGetSourcef(source_, AL_SEC_OFFSET, &seconds);
    return seconds;
  }

 private:
  enum { kAll, kMoment };

  Device(const OpenAl& al, ALCdevice* device, ALCcontext* context)
      : al_(al), device_(device), context_(context) {
    al_.alGenSources(1, &source_);
    al_.alGenBuffers(2, buffers_);
    if (al_.alIsExtensionPresent("AL_SOFT_gain_clamp_ex") == AL_TRUE) {
      al_.alSourcef(source_, AL_MAX_GAIN, kLoudest);
    }
  }

  void Fill(int buffer, const Sound& sound, size_t from, size_t to) {
    const auto bytes = static_cast<ALsizei>((to - from) * sizeof(sound.samples[0]));
    al_.alBufferData(buffers_[buffer], FormatOf(sound.format), sound.samples.data() + from, bytes,
                     sound.format.rate);
  }

  const OpenAl& al_;
  ALCdevice* device_;
  ALCcontext* context_;
  ALuint source_ = 0;
  ALuint buffers_[2] = {0, 0};
  bool is_playing_ = false;
};

SoundPlayer::SoundPlayer() = default;
SoundPlayer::~SoundPlayer() = default;

std::optional<double> SoundPlayer::position() const {
  if (!device_ || !device_->is_heard()) return std::nullopt;
  return device_->position();
}

// Whether there is something to hear and to hear it by.
bool SoundPlayer::IsReady(Editor* editor) {
  const std::optional<ProjectAudio>& audio = editor->session().project().audio;
  const Sound* sound = editor->sound.sound();
  if (!audio || audio->mute || sound == nullptr || has_failed_) {
    if (device_) device_->Stop();
    return false;
  }
  if (!device_) device_ = Device::Open();
  if (!device_) {
    has_failed_ = true;
    editor->Say(Tr("There is no sound device: playback is silent."), true);
    return false;
  }
  if (sound != sound_) device_->Take(*sound);
  sound_ = sound;
  device_->SetGain(std::pow(10.0, audio->gain_db / 20.0));
  return true;
}

void SoundPlayer::Follow(Editor* editor) {
  const double last_frame = std::exchange(frame_, editor->session().frame());
  if (!IsReady(editor)) return;
  const Playback& playback = editor->playback;
  if (playback.is_on()) return Play(editor, playback.FrameAt(editor->now()));
  if (device_->is_playing()) device_->Stop();
  if (last_frame != frame_) Scrub(editor);
}

void SoundPlayer::Play(Editor* editor, double frame) {
  const Project& project = editor->session().project();
  const FrameRate rate{project.fps.num, project.fps.den};
  const double at = rate.SecondsAt(frame - project.audio->start_frame);
  if (at < 0.0 || at >= Seconds(*sound_)) return device_->Stop();
  if (!device_->is_playing() || std::abs(device_->position() - at) > kOff) device_->Play(at);
}

void SoundPlayer::Scrub(Editor* editor) {
  const Project& project = editor->session().project();
  const FrameRate rate{project.fps.num, project.fps.den};
  const double at = rate.SecondsAt(frame_ - project.audio->start_frame);
  device_->PlayMoment(*sound_, at, at + std::max(kShortestHeard, rate.SecondsAt(1.0)));
}

}  // namespace hazumi::ui
