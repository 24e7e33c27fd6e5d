#pragma once

// Sweep files for tests.

#include <gtest/gtest.h>

#include <string>

#include "engine/sweep/sweep_plan.h"

namespace hazumi::test {

// A sweep file of a project "throw.kfa", with these fields besides.
inline std::string SweepText(const std::string& fields) {
  return R"({"format": "hazumi-sweep", "version": 1, "project": "throw.kfa", )" + fields + "}";
}

inline SweepPlan GoodSweep(const std::string& fields) {
  Result<SweepPlan> plan = ParseSweep(SweepText(fields), "s.json");
  EXPECT_TRUE(plan.ok()) << (plan.ok() ? "" : plan.error().ToString());
  return plan.ok() ? std::move(plan).value() : SweepPlan();
}

}  // namespace hazumi::test
