#include "engine/region/exact/event_trail.h"

#include <gtest/gtest.h>

namespace hazumi {
namespace {

constexpr uint64_t kElbow = 1, kKnee = 2;

EventMark Hit(double time, uint64_t what, uint64_t state = 0) { return {time, time, what, state}; }

EventTrail Trail(std::initializer_list<EventMark> marks) {
  EventTrail trail;
  for (const EventMark& mark : marks) trail.Add(mark);
  return trail;
}

TEST(EventTrail, SameEventsAtSlightlyOtherTimes_DoNotPart) {
  const EventTrail a = Trail({Hit(0.1, kElbow), Hit(0.2, kKnee)}),
                   b = Trail({Hit(0.1001, kElbow), Hit(0.1999, kKnee)});
  EXPECT_FALSE(EventTrail::Part(a, b, 1.0));
}

TEST(EventTrail, EventsInAnotherOrder_PartAtTheFirst) {
  const EventTrail a = Trail({Hit(0.1, kElbow), Hit(0.2, kKnee)}),
                   b = Trail({Hit(0.12, kKnee), Hit(0.2, kElbow)});
  EXPECT_EQ(EventTrail::Part(a, b, 1.0), 0.1);
}

TEST(EventTrail, EventsTooNearForAnOrder_AreOne) {
  const EventTrail a = Trail({Hit(0.1, kElbow), Hit(0.101, kKnee)}),
                   b = Trail({Hit(0.1, kKnee), Hit(0.1005, kElbow)});
  EXPECT_FALSE(EventTrail::Part(a, b, 1.0));
}

TEST(EventTrail, AnEventThatOneHasAlone_PartsOnceItIsCertain) {
  const EventTrail a = Trail({Hit(0.1, kElbow)}), b = Trail({});
  EXPECT_FALSE(EventTrail::Part(a, b, 0.101));
  EXPECT_EQ(EventTrail::Part(a, b, 0.2), 0.1);
}

TEST(EventTrail, StateAfterAnEvent_Counts) {
  const EventTrail a = Trail({Hit(0.1, kElbow, 7)}), b = Trail({Hit(0.1, kElbow, 8)});
  EXPECT_EQ(EventTrail::Part(a, b, 1.0), 0.1);
}

TEST(EventTrail, MarkWithoutAChange_IsNoEvent) {
  const EventTrail a = Trail({Hit(0.1, kElbow, 7), Hit(0.2, 0, 7)}),
                   b = Trail({Hit(0.1, kElbow, 7)});
  EXPECT_FALSE(EventTrail::Part(a, b, 1.0));
}

// Equal trails may be wrong alike.
TEST(EventTrail, AnEventThatCouldBeAnother_Parts) {
  const EventMark sure = Hit(0.1, kElbow), unsure = {0.2, 0.2, 0, 0, /*is_unsure=*/true};
  const EventTrail trail = Trail({sure, unsure});
  EXPECT_EQ(EventTrail::Part(trail, EventTrail(trail), 1.0), 0.2);
  EXPECT_EQ(EventTrail::Part(trail, Trail({sure}), 1.0), 0.2);
}

// Merged events keep the mark.
TEST(EventTrail, AnEventThatCouldBeAnother_PartsBesideOthers) {
  const EventMark sure = Hit(0.1, kElbow), unsure = {0.1005, 0.1005, 0, 0, /*is_unsure=*/true};
  const EventTrail trail = Trail({sure, unsure});
  EXPECT_EQ(EventTrail::Part(trail, EventTrail(trail), 1.0), 0.1);
}

}  // namespace
}  // namespace hazumi
