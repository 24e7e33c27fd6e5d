#include "engine/media/decode_sound.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "engine/media/sound_part.h"

namespace hazumi {
namespace {

namespace fs = std::filesystem;

bool HasFfmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }

class DecodeSoundTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Half a second of silence, then half a second of a tone.
  fs::path Tone(const std::string& name) const {
    const fs::path path = folder_ / name;
    const std::string command =
        "ffmpeg -loglevel error -y -f lavfi -i 'sine=frequency=1000:sample_rate=48000:duration=0.5,"
        "adelay=24000S' \"" +
        path.string() + "\"";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return path;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("hazumi_sound_" + std::to_string(getpid()));
};

TEST_F(DecodeSoundTest, HasEverySampleInItsPlace) {
  const auto sound = DecodeSound(Tone("it's a tone.wav"), {48000, 1}, {});
  ASSERT_TRUE(sound.ok()) << sound.error().ToString();
  const std::vector<std::int16_t>& samples = sound.value().samples;
  ASSERT_EQ(samples.size(), 48000u);
  size_t first = 0;
  while (first < samples.size() && samples[first] == 0) ++first;
  EXPECT_NEAR(static_cast<double>(first), 24000.0, 2.0);
}

TEST_F(DecodeSoundTest, HasTheRateAndTheChannelsThatAreAskedFor) {
  const auto sound = DecodeSound(Tone("tone.wav"), {8000, 2}, {});
  ASSERT_TRUE(sound.ok()) << sound.error().ToString();
  EXPECT_EQ(sound.value().samples.size(), 16000u);
}

TEST_F(DecodeSoundTest, WhatIsNoSoundIsSaid) {
  const auto complaint = [](const fs::path& path) {
    const auto sound = DecodeSound(path, {8000, 1}, {});
    return sound.ok() ? "none" : sound.error().ToString();
  };
  const fs::path missing = folder_ / "missing.wav", broken = folder_ / "broken.wav";
  EXPECT_EQ(complaint(missing), missing.string() +
                                    ": cannot be read: No such file or directory; choose the "
                                    "project's sound again");
  std::ofstream(broken) << "no sound at all";
  EXPECT_EQ(complaint(broken), broken.string() +
                                   ": ffmpeg finds no sound in it, or it is damaged; choose "
                                   "another file, or convert it to WAV");
  EXPECT_NE(complaint(folder_).find("is a folder"), std::string::npos);
}

// Server that waits for connections on a port of this machine.
class Listener {
 public:
  Listener() {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(::bind(socket_, any, size), 0);
    EXPECT_EQ(::listen(socket_, 8), 0);
    EXPECT_EQ(::getsockname(socket_, any, &size), 0);
    port_ = ::ntohs(address.sin_port);
  }
  ~Listener() { ::close(socket_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  int port() const { return port_; }
  // Returns whether a client has connected since the last call.
  bool WasAsked() const {
    const int connection = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection >= 0) ::close(connection);
    return connection >= 0;
  }

 private:
  int socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  int port_ = 0;
};

// Playlist with a remote sound, which ffmpeg opens by default. A file must not open connections to
// other machines.
TEST_F(DecodeSoundTest, RemotePlaylist_OpensNoConnection) {
  const Listener listener;
  const fs::path list = folder_ / "list.m3u8";
  std::ofstream(list) << "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\nhttp://127.0.0.1:"
                      << listener.port() << "/tone.ts\n#EXT-X-ENDLIST\n";
  const std::string follows =
      "ffmpeg -loglevel quiet -nostdin -rw_timeout 100000 -protocol_whitelist file,http,tcp -i '" +
      list.string() + "' -f null -";
  EXPECT_NE(std::system(follows.c_str()), 0);
  ASSERT_TRUE(listener.WasAsked()) << "else the next lines prove nothing";
  while (listener.WasAsked()) {
  }
  EXPECT_FALSE(DecodeSound(list, {8000, 1}, {}).ok());
  EXPECT_FALSE(listener.WasAsked());
}

TEST_F(DecodeSoundTest, IsCancelled) {
  const auto sound = DecodeSound(Tone("tone.wav"), {8000, 1}, [] { return true; });
  ASSERT_FALSE(sound.ok());
  EXPECT_EQ(sound.error().code, ErrorCode::kInterrupted);
}

TEST(SoundPart, IsCutToTheSample) {
  EXPECT_EQ(FilterOf({"a.wav", 0.5, 2.0, 0.0}),
            "aresample=48000,asetpts=N/SR/TB,atrim=start_sample=24000,asetpts=PTS-STARTPTS,"
            "apad=whole_len=96000,atrim=end_sample=96000");
  EXPECT_EQ(FilterOf({"a.wav", -0.25, 1.0, -6.5}),
            "aresample=48000,asetpts=N/SR/TB,adelay=delays=12000S:all=1,volume=-6.5dB,"
            "apad=whole_len=48000,atrim=end_sample=48000");
}

}  // namespace
}  // namespace hazumi
