#pragma once

#include <AL/al.h>
#include <AL/alc.h>

namespace hazumi::ui {

// The functions of OpenAL that are used.
#define HAZUMI_OPENAL(X)                            \
  X(LPALCOPENDEVICE, alcOpenDevice)                 \
  X(LPALCCLOSEDEVICE, alcCloseDevice)               \
  X(LPALCCREATECONTEXT, alcCreateContext)           \
  X(LPALCDESTROYCONTEXT, alcDestroyContext)         \
  X(LPALCMAKECONTEXTCURRENT, alcMakeContextCurrent) \
  X(LPALGENSOURCES, alGenSources)                   \
  X(LPALDELETESOURCES, alDeleteSources)             \
  X(LPALGENBUFFERS, alGenBuffers)                   \
  X(LPALDELETEBUFFERS, alDeleteBuffers)             \
  X(LPALBUFFERDATA, alBufferData)                   \
  X(LPALSOURCEI, alSourcei)                         \
  X(LPALSOURCEF, alSourcef)                         \
  X(LPALSOURCEPLAY, alSourcePlay)                   \
  X(LPALSOURCESTOP, alSourceStop)                   \
  X(LPALGETSOURCEI, alGetSourcei)                   \
  X(LPALGETSOURCEF, alGetSourcef)                   \
  X(LPALISEXTENSIONPRESENT, alIsExtensionPresent)
// They are loaded when a sound is first heard: who draws pictures alone waits for no library, and
// needs none.
struct OpenAl {
#define HAZUMI_OPENAL_MEMBER(type, name) type name = nullptr;
  HAZUMI_OPENAL(HAZUMI_OPENAL_MEMBER)
#undef HAZUMI_OPENAL_MEMBER
};

// Null where OpenAL is not installed.
const OpenAl* LoadOpenAl();

}  // namespace hazumi::ui
