// Logs of earlier bakes, and fits of carriers, by what they were asked, bit by bit.

#include "engine/bake/known_logs.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/bake/attachment_cache.h"

namespace hazumi {
namespace {

std::shared_ptr<const GroupLog> LogOf(Numbers question, Numbers answer = {}) {
  GroupLog log(1);
  log[0].question = std::move(question);
  log[0].answer = std::move(answer);
  return std::make_shared<const GroupLog>(std::move(log));
}

TEST(KnownLogs, FindTheLogThatBeginsWithAQuestion) {
  const auto one = LogOf({1.0, 2.0}), two = LogOf({1.0, 2.0, 3.0}), three = LogOf({2.0, 1.0});
  KnownLogs known;
  known.Add(GroupLogs{one, two});
  known.Add(GroupLogs{three});
  EXPECT_EQ(known.Find({1.0, 2.0}), one);
  EXPECT_EQ(known.Find({1.0, 2.0, 3.0}), two);
  EXPECT_EQ(known.Find({2.0, 1.0}), three);
  for (const Numbers& other : std::vector<Numbers>{{}, {1.0}, {1.0, 2.5}, {3.0, 2.0, 1.0}}) {
    EXPECT_EQ(known.Find(other), nullptr);
  }
}

TEST(KnownLogs, TellNumbersApartByTheirBits) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto zero = LogOf({0.0}), minus_zero = LogOf({-0.0}), no_number = LogOf({nan});
  KnownLogs known;
  known.Add(GroupLogs{zero, minus_zero, no_number});
  EXPECT_EQ(known.Find({0.0}), zero);
  EXPECT_EQ(known.Find({-0.0}), minus_zero);
  EXPECT_EQ(known.Find({nan}), no_number);
  EXPECT_EQ(known.Find({std::nextafter(0.0, 1.0)}), nullptr);
}

TEST(KnownLogs, GiveTheLatestOfLogsThatBeginAlike) {
  const auto early = LogOf({7.0}, {1.0}), late = LogOf({7.0}, {2.0});
  KnownLogs known;
  known.Add(GroupLogs{early, LogOf({8.0})});
  known.Add(GroupLogs{late});
  EXPECT_EQ(known.Find({7.0}), late);
  EXPECT_NE(known.Find({8.0}), nullptr);
}

TEST(KnownLogs, ForgetAll) {
  KnownLogs known;
  known.Add(GroupLogs{LogOf({1.0})});
  known.clear();
  EXPECT_EQ(known.Find({1.0}), nullptr);
}

// Fits a carrier at rest; counts how often.
struct Fitter {
  int fits = 0;
  std::shared_ptr<const Attachment> operator()() {
    ++fits;
    Attachment::Frame still;
    still.R = small::ToSmall(Mat3::Identity());
    return std::make_shared<const Attachment>(0.0, 0.1, [&](double) { return still; });
  }
};

TEST(AttachmentCache, FitsOnceForTheSameKeyAndSharesIt) {
  AttachmentCache cache;
  Fitter fit;
  const auto get = [&](std::vector<double> key) {
    return cache.Get(std::move(key), [&] { return fit(); });
  };
  const auto first = get({1.0, 2.0});
  EXPECT_EQ(get({1.0, 2.0}), first);
  EXPECT_EQ(fit.fits, 1);
  EXPECT_NE(get({1.0, std::nextafter(2.0, 3.0)}), first);
  EXPECT_NE(get({1.0}), first);
  EXPECT_EQ(fit.fits, 3);
}

TEST(AttachmentCache, KeepsTheEightLatestFits) {
  AttachmentCache cache;
  Fitter fit;
  const auto get = [&](double key) { return cache.Get({key}, [&] { return fit(); }); };
  const auto oldest = get(0.0);
  for (int key = 1; key <= 7; ++key) get(key);
  EXPECT_EQ(get(0.0), oldest);
  EXPECT_EQ(fit.fits, 8);
  get(8.0);
  get(1.0);
  EXPECT_EQ(fit.fits, 9);
  EXPECT_NE(get(0.0), oldest);  // which whoever holds it keeps
  EXPECT_EQ(fit.fits, 10);
  EXPECT_EQ(oldest->At(0.05).w.x, 0.0);
}

}  // namespace
}  // namespace hazumi
