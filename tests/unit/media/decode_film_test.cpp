#include "engine/media/decode_film.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace hazumi {
namespace {

namespace fs = std::filesystem;

class DecodeFilmTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "ffmpeg is not installed";
    }
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path Make(const std::string& name, const std::string& source) const {
    const fs::path path = folder_ / name;
    const std::string command =
        "ffmpeg -loglevel error -y -f lavfi -i \"" + source + "\" \"" + path.string() + "\"";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return path;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("hazumi_film_" + std::to_string(getpid()));
};

int GreyInTheMiddle(const Image& image) {
  const int at = 4 * (image.width * (image.height / 2) + image.width / 2);
  return image.rgba[at + 1];
}

// Each picture is brighter than the one before it by 8 of 255.
TEST_F(DecodeFilmTest, HasThePictureOfEachFrameAtAnyRate) {
  const fs::path video =
      Make("ramp.mp4", "color=black:s=64x48:r=25:d=0.8,geq=lum='30+8*N':cb=128:cr=128");
  for (const int fps : {25, 50}) {
    const auto film = DecodeFilm(video, fps, 1, {});
    ASSERT_TRUE(film.ok()) << film.error().ToString();
    ASSERT_EQ(film.value().count(), 20 * fps / 25);
    const auto first = film.value().PictureAt(0);
    ASSERT_TRUE(first.ok()) << first.error().ToString();
    EXPECT_EQ(first.value().width, 64);
    EXPECT_EQ(first.value().height, 48);
    for (int i = 0; i < film.value().count(); ++i) {
      const auto picture = film.value().PictureAt(i);
      ASSERT_TRUE(picture.ok());
      const double wanted = (30.0 + 8.0 * (i * 25 / fps) - 16.0) * 255.0 / 219.0;
      EXPECT_NEAR(GreyInTheMiddle(picture.value()), wanted, 5.0) << fps << " " << i;
    }
  }
}

TEST_F(DecodeFilmTest, APictureFileHasOneAndAWideOneIsMadeSmaller) {
  const auto film = DecodeFilm(Make("wide.png", "color=red:s=1920x1080:d=0.04"), 30, 1, {});
  ASSERT_TRUE(film.ok()) << film.error().ToString();
  ASSERT_EQ(film.value().count(), 1);
  const auto picture = film.value().PictureAt(0);
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture.value().width, kFilmWidth);
  EXPECT_EQ(picture.value().height, 540);
}

TEST_F(DecodeFilmTest, WhatIsNoPictureIsSaid) {
  std::ofstream(folder_ / "text.mp4") << "text";
  const auto complaint = [](const fs::path& path) {
    const auto film = DecodeFilm(path, 30, 1, {});
    return film.ok() ? "none" : film.error().ToString();
  };
  EXPECT_NE(complaint(folder_ / "text.mp4").find("ffmpeg finds no picture in it"),
            std::string::npos);
  EXPECT_NE(complaint(folder_ / "none.mp4").find("cannot be read: No such file"),
            std::string::npos);
  EXPECT_NE(complaint(folder_).find("is a folder"), std::string::npos);
  EXPECT_NE(complaint(Make("tone.wav", "sine=duration=0.1")).find("no picture in it"),
            std::string::npos);
}

}  // namespace
}  // namespace hazumi
