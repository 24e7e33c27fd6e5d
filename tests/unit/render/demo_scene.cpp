#include "demo_scene.h"

#include <cmath>
#include <numbers>
#include <string>

namespace hazumi::render {
namespace {

constexpr SrgbColor kSkin = FromHex(0xd9c2ae);
constexpr SrgbColor kShirt = FromHex(0x5d8fb5);
constexpr SrgbColor kTrousers = FromHex(0x4a5563);
constexpr SrgbColor kJoint = FromHex(0xd98a3d);

// Draws one person into a scene; alpha < 1 makes a ghost.
class Person {
 public:
  Person(Scene& scene, double phase, double shift_y, float alpha)
      : scene_(scene), phase_(phase), origin_(0.0, shift_y, 0.0), alpha_(alpha) {}

  void Draw() {
    Trunk();
    for (const double side : {-1.0, 1.0}) {
      Leg(side);
      Arm(side);
    }
  }

 private:
  void Part(const Vec3& a, const Vec3& b, double ra, double rb, SrgbColor color) {
    color.a = alpha_;
    scene_.capsules.push_back({origin_ + a, origin_ + b, ra, rb, color});
  }

  void Trunk() {
    Part({-0.08, 0, 0.93}, {0.08, 0, 0.93}, 0.105, 0.105, kTrousers);
    Part({0, 0, 0.98}, {0, 0.01, 1.12}, 0.115, 0.112, kShirt);
    Part({0, 0.01, 1.12}, {0, 0, 1.27}, 0.112, 0.13, kShirt);
    Part({-0.10, 0, 1.33}, {0.10, 0, 1.33}, 0.085, 0.085, kShirt);
    Part({0, 0, 1.36}, {0, -0.01, 1.50}, 0.055, 0.05, kSkin);
    Ellipsoid head{
        {Mat3::Identity(), origin_ + Vec3(0, -0.02, 1.59)}, {0.076, 0.095, 0.112}, kSkin};
    head.color.a = alpha_;
    scene_.ellipsoids.push_back(head);
    Part({0, -0.11, 1.575}, {0, -0.115, 1.565}, 0.016, 0.018, kSkin);
  }

  void Leg(double side) {
    const double swing = 0.42 * std::sin(phase_) * side;
    const double bend = 0.12 + 0.45 * std::max(0.0, std::cos(phase_) * side);
    const Vec3 hip(0.095 * side, 0, 0.90);
    const Vec3 knee = hip + 0.42 * Vec3(0, -std::sin(swing), -std::cos(swing));
    const double shin = swing - bend;
    const Vec3 ankle = knee + 0.40 * Vec3(0, -std::sin(shin), -std::cos(shin));
    const Vec3 toe = ankle + Vec3(0, -0.15, -0.045);
    Part(hip, knee, 0.085, 0.056, kTrousers);
    Part(knee, ankle + Vec3(0, 0, 0.02), 0.054, 0.038, kTrousers);
    Part(knee, knee + Vec3(0, 0.001, 0), 0.058, 0.058, kJoint);
    Part(ankle + Vec3(0, 0.03, -0.03), toe, 0.042, 0.03, kSkin);
    Part(toe, toe + Vec3(0.02 * side, -0.06, 0), 0.032, 0.022, kSkin);
  }

  void Arm(double side) {
    const double swing = -0.5 * std::sin(phase_) * side;
    const Vec3 shoulder(0.185 * side, 0, 1.36);
    const Vec3 elbow = shoulder + 0.27 * Vec3(0.14 * side, -std::sin(swing), -std::cos(swing));
    const double fore = swing + 0.45;
    const Vec3 wrist = elbow + 0.24 * Vec3(0.05 * side, -std::sin(fore), -std::cos(fore));
    const Vec3 hand = wrist + 0.10 * Vec3(-0.05 * side, -std::sin(fore), -std::cos(fore));
    Part(shoulder, elbow, 0.055, 0.042, kShirt);
    Part(elbow, elbow + Vec3(0, 0.001, 0), 0.044, 0.044, kJoint);
    Part(elbow, wrist, 0.040, 0.030, kSkin);
    Part(wrist, hand, 0.034, 0.028, kSkin);
    for (int finger = 0; finger < 4; ++finger) {
      const Vec3 base = hand + Vec3(0, 0.018 * (finger - 1.5), 0);
      Part(base, base + 0.06 * Vec3(0, -std::sin(fore), -std::cos(fore)), 0.010, 0.008, kSkin);
    }
  }

  Scene& scene_;
  double phase_;
  Vec3 origin_;
  float alpha_;
};

std::vector<Vec3> Ballistic(double x) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.0;
    points.push_back({x, 1.0 - 2.2 * t, 0.95 + 1.3 * t - 1.6 * t * t});
  }
  return points;
}

void AddMarks(Scene& scene) {
  scene.polylines.push_back({Ballistic(0.0), 3.0, FromHex(0xffbe33), 0.0, false});
  scene.polylines.push_back({Ballistic(0.55), 2.5, FromHex(0x53992e), 0.05, false});
  scene.polylines.push_back({{{0, 0, 0.98}, {0, 0, 0.004}}, 1.5, FromHex(0x2890ff), 0.03, true});
  scene.markers.push_back({MarkerShape::kCenterOfMass, {0, 0, 0.98}, 0.035, FromHex(0xffffff)});
  scene.markers.push_back({MarkerShape::kRing, {0, 0, 0.004}, 0.09, FromHex(0x2890ff), 2.5});
  scene.markers.push_back({MarkerShape::kCross, {0, 0, 0.004}, 0.05, FromHex(0x2890ff), 2.0});
  scene.markers.push_back({MarkerShape::kDisc, {-0.6, -0.7, 0.004}, 0.07, FromHex(0xcc7529)});
}

double PhaseOf(int frame) { return 0.9 + 2.0 * std::numbers::pi * frame / 31.0; }

}  // namespace

Scene MakeDemoScene(int frame) {
  Scene scene;
  scene.camera = {.eye = {2.6, -3.7, 1.45}, .target = {0.15, 0, 0.82}, .vertical_fov_deg = 32.0};
  Person(scene, PhaseOf(frame), 0.0, 1.0f).Draw();
  scene.boxes.push_back(
      {{Mat3::Identity(), {0.85, 0.35, 0.2}}, {0.25, 0.3, 0.2}, 0.015, FromHex(0xb9a58a)});
  AddMarks(scene);
  scene.captions.push_back({"frame " + std::to_string(frame), Corner::kBottomRight});
  scene.captions.push_back({"Hazumi", Corner::kTopLeft, 16.0});
  scene.captions.push_back(
      {"passive: r_arm, l_arm  (12–24)", Corner::kTopLeft, 12.0, FromHex(0xffbe33)});
  return scene;
}

Scene MakeGhostScene(int frame) {
  Scene scene = MakeDemoScene(frame);
  Person(scene, PhaseOf(frame) - 0.9, 0.65, 0.35f).Draw();
  Person(scene, PhaseOf(frame) + 0.9, -0.65, 0.35f).Draw();
  return scene;
}

}  // namespace hazumi::render
