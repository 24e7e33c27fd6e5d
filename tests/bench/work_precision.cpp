#include <cstdio>

#include "tests/bench/questions.h"
#include "tests/bench/swing_cases.h"
#include "tests/bench/swing_method.h"
#include "tests/bench/swing_table.h"
#include "tests/bench/tables.h"
#include "tests/support/figures.h"

namespace hazumi::bench {

namespace {

std::vector<SwingMethod> AllMethods(const Figure& arm) {
  std::vector<SwingMethod> all;
  for (const auto& methods : {HazumiMethods(arm), MujocoMethods(arm), SimbodyMethods(arm),
                              BulletMethods(arm), DartMethods(arm)}) {
    all.insert(all.end(), methods.begin(), methods.end());
  }
  return all;
}

void DemandThatPeersAgree(const Figure& arm) {
  DemandAgreement({"mujoco", MakeMujoco}, arm);
  DemandAgreement({"simbody", MakeSimbody}, arm);
  DemandAgreement({"bullet", MakeBullet}, arm);
  DemandAgreement({"dart", MakeDart}, arm);
  DemandForwardAgreement({"mujoco_ball", MakeMujocoWithBalls}, arm);
  DemandForwardAgreement({"simbody_ball", MakeSimbodyWithBalls}, arm);
  DemandForwardAgreement({"bullet_ball", MakeBulletWithBalls}, arm);
  DemandForwardAgreement({"dart_ball", MakeDartWithBalls}, arm);
}

}  // namespace

void PrintWorkPrecision(int rounds) {
  const Figure arm = test::Arm7();
  DemandThatPeersAgree(arm);
  const std::vector<SwingMethod> methods = AllMethods(arm);
  std::puts(kSwingColumns);
  for (const SwingCase& c : SwingCases()) PrintSwings(c, methods, rounds);
}

}  // namespace hazumi::bench
