// What the axes, units and pivots of FBX and Collada become.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "engine/spatial/degrees.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi {
namespace {

Mat3 About(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix();
}

TEST(Fbx, SaysUpAxisAndUnitOfTheFile) {
  const Character c = test::ReadSmall("a.fbx", test::SmallFbx());
  EXPECT_EQ(c.up, UpAxis::kZ);
  ASSERT_TRUE(c.metres_per_unit.has_value());
  EXPECT_NEAR(*c.metres_per_unit, 1.0, 1e-6);
  EXPECT_EQ(c.name, "a");
}

TEST(Fbx, PreRotationIsAPartOfTheBone) {
  const Character c = test::ReadSmall("a.fbx", test::SmallFbx());
  ASSERT_EQ(c.bones.size(), 1u);
  EXPECT_EQ(c.bones[0].name, "Hips");
  EXPECT_TRUE(c.bones[0].rest.p.isApprox(Vec3(0, 0, 1), 1e-6));
  const Mat3 rest = About(Vec3::UnitZ(), 90) * About(Vec3::UnitX(), 10);
  EXPECT_TRUE(c.bones[0].rest.R.isApprox(rest, 1e-6)) << c.bones[0].rest.R;
  // A child that nothing moves says where the bone ends.
  ASSERT_TRUE(c.bones[0].end_site.has_value());
  EXPECT_TRUE(c.bones[0].end_site->isApprox(Vec3(0.5, 0, 0), 1e-6));
}

TEST(Fbx, FramesAreThoseOfTheCurve) {
  const Character c = test::ReadSmall("a.fbx", test::SmallFbx());
  ASSERT_EQ(c.clips.size(), 1u);
  EXPECT_NEAR(c.clips[0].seconds_per_frame, 1.0 / 30.0, 1e-9);
  ASSERT_EQ(c.clips[0].num_frames, 31);
  const BoneTrack& track = c.clips[0].tracks[0];
  EXPECT_TRUE(track.translations.empty());
  ASSERT_EQ(track.rotations.size(), 31u);
  for (const int frame : {0, 15, 30}) {
    const Mat3 R = About(Vec3::UnitZ(), 90) * About(Vec3::UnitX(), 10 + 2.0 * frame);
    EXPECT_TRUE(track.rotations[static_cast<size_t>(frame)].toRotationMatrix().isApprox(R, 1e-5))
        << frame;
  }
}

// A pivot makes assimp split the node, in rest and animation: T Rp Rpre R Rp^-1.
TEST(Fbx, PivotsAreMultipliedOut) {
  const Character c = test::ReadSmall(
      "a.fbx",
      test::SmallFbx("\t\t\tP: \"RotationPivot\", \"Vector3D\", \"Vector\", \"\",0,0.2,0\n"));
  ASSERT_EQ(c.bones.size(), 1u);
  ASSERT_EQ(c.clips.size(), 1u);
  const Vec3 pivot(0, 0.2, 0);
  const BoneTrack& track = c.clips[0].tracks[0];
  ASSERT_EQ(track.rotations.size(), 31u);
  ASSERT_EQ(track.translations.size(), 31u);
  for (const int frame : {0, 30}) {
    const Mat3 R = About(Vec3::UnitZ(), 90) * About(Vec3::UnitX(), 10 + 2.0 * frame);
    const Vec3 p = Vec3(0, 0, 1) + pivot - R * pivot;
    const auto f = static_cast<size_t>(frame);
    EXPECT_TRUE(track.rotations[f].toRotationMatrix().isApprox(R, 1e-5)) << frame;
    EXPECT_TRUE(track.translations[f].isApprox(p, 1e-5)) << track.translations[f].transpose();
  }
}

std::string With(const std::string& old, const std::string& by, std::string text) {
  const size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

// The angle from 10 to 70 degrees in a second, its key with these flags and slopes [deg/s].
std::string SmallFbxWithKey(int flags, const std::string& data) {
  return With("a: 0,0,0,0", "a: " + data,
              With("a: 24836", "a: " + std::to_string(flags), test::SmallFbx()));
}

double AngleAt(const Character& c, size_t frame) {
  const Mat3 R = c.clips.at(0).tracks.at(0).rotations.at(frame).toRotationMatrix();
  const Mat3 turned = About(Vec3::UnitZ(), 90).transpose() * R;
  return std::atan2(turned(2, 1), turned(1, 1)) * 180.0 / std::numbers::pi;
}

TEST(Fbx, CubicKeysFollowTheirSlopes) {
  const Character c = test::ReadSmall("a.fbx", SmallFbxWithKey(8, "60,-30,0,0"));
  EXPECT_TRUE(c.warnings.empty());
  for (size_t frame = 0; frame <= 30; ++frame) {
    const double s = static_cast<double>(frame) / 30.0, s2 = s * s, s3 = s2 * s;
    const double hermite = (2 * s3 - 3 * s2 + 1) * 10 + (s3 - 2 * s2 + s) * 60 +
                           (3 * s2 - 2 * s3) * 70 + (s3 - s2) * -30;
    EXPECT_NEAR(AngleAt(c, frame), hermite, 1e-6) << frame;
  }
}

// Handles of a half and a fifth of the segment; the curve's points by their parameter.
TEST(Fbx, WeightedKeysAreBezierCurvesOfTimeAndValue) {
  const uint32_t weights = 5000u | 2000u << 16;
  float packed = 0.0f;
  std::memcpy(&packed, &weights, sizeof packed);
  char data[64];
  std::snprintf(data, sizeof data, "60,-30,%.9g,0", static_cast<double>(packed));
  const Character c = test::ReadSmall("a.fbx", SmallFbxWithKey(8 | 0x3000000, data));
  const double right = 5000 / 9999.0, left = 2000 / 9999.0;
  const auto bezier = [](double a, double b, double d, double e, double s) {
    const double r = 1 - s;
    return r * r * r * a + 3 * r * r * s * b + 3 * r * s * s * d + s * s * s * e;
  };
  const auto time = [&](double s) { return bezier(0, right, 1 - left, 1, s); };
  for (size_t frame = 0; frame <= 30; ++frame) {
    double s = 0.5;  // by secants, which time's steady growth allows
    for (int i = 0; i < 200; ++i) s += 0.3 * (static_cast<double>(frame) / 30.0 - time(s));
    EXPECT_NEAR(AngleAt(c, frame), bezier(10, 10 + 60 * right, 70 + 30 * left, 70, s), 1e-5);
  }
}

TEST(Fbx, StepsStayUntilTheNextKeyOrNot) {
  const Character stays = test::ReadSmall("a.fbx", SmallFbxWithKey(2, "0,0,0,0"));
  const Character goes = test::ReadSmall("a.fbx", SmallFbxWithKey(2 | 0x100, "0,0,0,0"));
  for (size_t frame = 0; frame <= 30; ++frame) {
    EXPECT_NEAR(AngleAt(stays, frame), frame < 30 ? 10 : 70, 1e-6) << frame;
    EXPECT_NEAR(AngleAt(goes, frame), frame == 0 ? 10 : 70, 1e-6) << frame;
  }
}

// A take's span does not cut its keys off.
TEST(Fbx, KeysOutsideOfTheTakesSpanAreRead) {
  const Character c = test::ReadSmall(
      "a.fbx", With("\"LocalStart\", \"KTime\", \"Time\", \"\",0",
                    "\"LocalStart\", \"KTime\", \"Time\", \"\",23093079000", test::SmallFbx()));
  ASSERT_EQ(c.clips.at(0).num_frames, 31);
  EXPECT_NEAR(AngleAt(c, 0), 10, 1e-6);
  EXPECT_NEAR(AngleAt(c, 30), 70, 1e-6);
}

TEST(Fbx, OldVersionsAreNamedWithWhatToDo) {
  const Error error =
      test::ErrorOfSmall("a.fbx", With("FBXVersion: 7300", "FBXVersion: 6100", test::SmallFbx()));
  EXPECT_NE(error.message.find("version 6.1 of FBX"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("save it as FBX 2011 or later"), std::string::npos);
}

TEST(Collada, KeepsItsOwnAxesAndUnit) {
  const Character c = test::ReadSmall("a.dae", test::SmallCollada());
  EXPECT_EQ(c.up, UpAxis::kZ);
  ASSERT_TRUE(c.metres_per_unit.has_value());
  EXPECT_NEAR(*c.metres_per_unit, 0.01, 1e-8);
  ASSERT_EQ(c.bones.size(), 1u);
  EXPECT_TRUE(c.bones[0].rest.p.isApprox(Vec3(0, 0, 100), 1e-5));
  EXPECT_TRUE(c.bones[0].rest.R.isIdentity(1e-6));
  EXPECT_EQ(c.bones[0].rest_scale, Vec3::Ones());
  ASSERT_TRUE(c.bones[0].end_site.has_value());
  EXPECT_TRUE(c.bones[0].end_site->isApprox(Vec3(0, 0, 50), 1e-5));
}

// Hips turn about z by one number: 0, 60 and 30 degrees at 0, 0.5 and 1 s.
std::string TurningCollada(const std::string& interpolations, const std::string& in_tangents,
                           const std::string& out_tangents) {
  std::string text = test::SmallCollada();
  const size_t from = text.find("<library_animations>"), to = text.find("<scene>");
  const auto source = [](const std::string& id, const std::string& list, size_t stride) {
    return "<source id=\"" + id + "\">" + list + "<technique_common><accessor source=\"#" + id +
           "a\" count=\"3\" stride=\"" + std::to_string(stride) +
           "\"><param type=\"float\"/></accessor></technique_common></source>";
  };
  const auto floats = [&](const std::string& id, const std::string& numbers, size_t stride) {
    return source(id,
                  "<float_array id=\"" + id + "a\" count=\"" + std::to_string(3 * stride) + "\">" +
                      numbers + "</float_array>",
                  stride);
  };
  text.replace(
      from, to - from,
      "<library_animations><animation id=\"a\">" + floats("i", "0 0.5 1", 1) +
          floats("o", "0 60 30", 1) +
          source("p", "<Name_array id=\"pa\" count=\"3\">" + interpolations + "</Name_array>", 1) +
          floats("in", in_tangents, 2) + floats("out", out_tangents, 2) +
          "<sampler id=\"s\"><input semantic=\"INPUT\" source=\"#i\"/>"
          "<input semantic=\"OUTPUT\" source=\"#o\"/>"
          "<input semantic=\"INTERPOLATION\" source=\"#p\"/>"
          "<input semantic=\"IN_TANGENT\" source=\"#in\"/>"
          "<input semantic=\"OUT_TANGENT\" source=\"#out\"/></sampler>"
          "<channel source=\"#s\" target=\"Hips_id/turn.ANGLE\"/></animation>"
          "</library_animations>");
  text = With("<node id=\"Hips\" name=\"Hips\"", "<node id=\"Hips_id\" name=\"Hips\"", text);
  return With("0 0 0 1</matrix>", "0 0 0 1</matrix><rotate sid=\"turn\">0 0 1 0</rotate>", text);
}

double TurnAt(const Character& c, size_t frame) {
  const Mat3 R = c.clips.at(0).tracks.at(0).rotations.at(frame).toRotationMatrix();
  return std::atan2(R(1, 0), R(0, 0)) * 180.0 / std::numbers::pi;
}

// In the first half second with handles of 0.1 and 0.3 s, flat at both keys; in the second one with
// handles of a third, so that the value is a cubic of time.
TEST(Collada, BezierKeysAreCurvesOfTimeAndValue) {
  const Character c = test::ReadSmall(
      "a.dae", TurningCollada("BEZIER BEZIER BEZIER", "-0.1 0 0.2 60 0.8333333333333334 40",
                              "0.1 0 0.6666666666666666 60 1.1 30"));
  EXPECT_TRUE(c.warnings.empty());
  EXPECT_EQ(c.bones.at(0).name, "Hips") << "not the id";
  for (size_t frame = 0; frame <= 15; ++frame) {
    const double t = static_cast<double>(frame) / 30.0;
    double s = t / 0.5;
    for (int i = 0; i < 400; ++i) {
      const double r = 1 - s;
      s += 0.3 * (t - (3 * r * r * s * 0.1 + 3 * r * s * s * 0.2 + s * s * s * 0.5));
    }
    EXPECT_NEAR(TurnAt(c, frame), 60 * (3 * s * s - 2 * s * s * s), 1e-6) << frame;
  }
  for (size_t frame = 15; frame <= 30; ++frame) {
    const double s = (static_cast<double>(frame) / 30.0 - 0.5) / 0.5, r = 1 - s;
    const double value = r * r * r * 60 + 3 * r * r * s * 60 + 3 * r * s * s * 40 + s * s * s * 30;
    EXPECT_NEAR(TurnAt(c, frame), value, 1e-6) << frame;
  }
}

TEST(Collada, EachKeyHasItsOwnInterpolation) {
  const Character c =
      test::ReadSmall("a.dae", TurningCollada("STEP LINEAR LINEAR", "0 0 0 0 0 0", "0 0 0 0 0 0"));
  for (size_t frame = 0; frame <= 30; ++frame) {
    const double expected = frame < 15 ? 0.0 : 60.0 - 2.0 * static_cast<double>(frame - 15);
    EXPECT_NEAR(TurnAt(c, frame), expected, 1e-6) << frame;
  }
}

TEST(Collada, MatricesStep) {
  const std::string text = test::SmallCollada();
  const Character c = test::ReadSmall(
      "a.dae", With("<sampler id=\"s\">",
                    "<source id=\"p\"><Name_array id=\"pa\" count=\"2\">STEP STEP</Name_array>"
                    "<technique_common><accessor source=\"#pa\" count=\"2\" stride=\"1\"><param "
                    "type=\"name\"/></accessor></technique_common></source><sampler id=\"s\">"
                    "<input semantic=\"INTERPOLATION\" source=\"#p\"/>",
                    text));
  for (size_t frame = 0; frame <= 30; ++frame)
    EXPECT_NEAR(TurnAt(c, frame), frame < 30 ? 0 : 90, 1e-5) << frame;
}

TEST(Collada, RotatesAlongTheSphereBetweenKeys) {
  const Character c = test::ReadSmall("a.dae", test::SmallCollada());
  ASSERT_EQ(c.clips.size(), 1u);
  ASSERT_EQ(c.clips[0].num_frames, 31);
  const BoneTrack& track = c.clips[0].tracks[0];
  ASSERT_EQ(track.rotations.size(), 31u);
  EXPECT_TRUE(track.rotations[10].toRotationMatrix().isApprox(About(Vec3::UnitZ(), 30), 1e-5));
}

}  // namespace
}  // namespace hazumi
