#pragma once

#include <AL/al.h>
#include <AL/alc.h>

namespace hazumi::ui {

// The functions of OpenAL that are used.
#define HAZUMI_OPENAL(X)   \
  X(alcOpenDevice)         \
  X(alcCloseDevice)        \
  X(alcCreateContext)      \
  X(alcDestroyContext)     \
  X(alcMakeContextCurrent) \
  X(alGenSources)          \
  X(alDeleteSources)       \
  X(alGenBuffers)          \
  X(alDeleteBuffers)       \
  X(alBufferData)          \
  X(alSourcei)             \
  X(alSourcef)             \
  X(alSourcePlay)          \
  X(alSourceStop)          \
  X(alGetSourcei)          \
  X(alGetSourcef)          \
  X(alIsExtensionPresent)

// They are loaded when a sound is first heard: who draws pictures alone waits for no library, and
// needs none.
struct OpenAl {
#define HAZUMI_OPENAL_MEMBER(name) decltype(&::name) name = nullptr;
  HAZUMI_OPENAL(HAZUMI_OPENAL_MEMBER)
#undef HAZUMI_OPENAL_MEMBER
};

// Null where OpenAL is not installed.
const OpenAl* LoadOpenAl();

}  // namespace hazumi::ui
