// Logs of earlier bakes, and fits of carriers, by what they were asked, bit by bit.

#include "engine/bake/known_logs.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "engine/bake/moving_base_cache.h"

namespace hazumi {
namespace {

BeginIsland RequestAt(double t) {
  BeginIsland request;
  request.t = t;
  return request;
}

std::shared_ptr<const IslandLog> LogOf(const BeginIsland& request, double time = 0.0) {
  IslandLog log(1);
  log[0].request = request;
  IslandProgress progress;
  progress.time = time;
  log[0].result = std::move(progress);
  return std::make_shared<const IslandLog>(std::move(log));
}

TEST(KnownLogs, FindTheLogThatBeginsWithARequest) {
  BeginIsland with_angle = RequestAt(1.0), with_another = RequestAt(1.0);
  with_angle.state.q = VecX::Constant(1, 2.0);
  with_another.state.q = VecX::Constant(1, 3.0);
  const auto one = LogOf(RequestAt(1.0)), two = LogOf(with_angle), three = LogOf(RequestAt(2.0));
  KnownLogs known;
  known.Add(IslandLogs{one, two});
  known.Add(IslandLogs{three});
  EXPECT_EQ(known.Find(RequestAt(1.0)), one);
  EXPECT_EQ(known.Find(with_angle), two);
  EXPECT_EQ(known.Find(RequestAt(2.0)), three);
  EXPECT_EQ(known.Find(with_another), nullptr);
  EXPECT_EQ(known.Find(RequestAt(1.5)), nullptr);
}

TEST(KnownLogs, TellNumbersApartByTheirBits) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto zero = LogOf(RequestAt(0.0)), minus_zero = LogOf(RequestAt(-0.0)),
             no_number = LogOf(RequestAt(nan));
  KnownLogs known;
  known.Add(IslandLogs{zero, minus_zero, no_number});
  EXPECT_EQ(known.Find(RequestAt(0.0)), zero);
  EXPECT_EQ(known.Find(RequestAt(-0.0)), minus_zero);
  EXPECT_EQ(known.Find(RequestAt(nan)), no_number);
  EXPECT_EQ(known.Find(RequestAt(std::nextafter(0.0, 1.0))), nullptr);
}

TEST(KnownLogs, GiveTheLatestOfLogsThatBeginAlike) {
  const auto early = LogOf(RequestAt(7.0), 1.0), late = LogOf(RequestAt(7.0), 2.0);
  KnownLogs known;
  known.Add(IslandLogs{early, LogOf(RequestAt(8.0))});
  known.Add(IslandLogs{late});
  EXPECT_EQ(known.Find(RequestAt(7.0)), late);
  EXPECT_NE(known.Find(RequestAt(8.0)), nullptr);
}

TEST(KnownLogs, ForgetAll) {
  KnownLogs known;
  known.Add(IslandLogs{LogOf(RequestAt(1.0))});
  known.clear();
  EXPECT_EQ(known.Find(RequestAt(1.0)), nullptr);
}

// Fits a carrier at rest; counts how often.
struct Fitter {
  int fits = 0;
  std::shared_ptr<const MovingBase> operator()() {
    ++fits;
    MovingBase::Frame still;
    still.R = small::ToSmall(Mat3::Identity());
    return std::make_shared<const MovingBase>(0.0, 0.1, 0.1, [&](double) { return still; });
  }
};

TEST(MovingBaseCache, FitsOnceForTheSameCarrierAndSharesIt) {
  MovingBaseCache cache;
  Fitter fit;
  Carrier carrier;
  carrier.chain.resize(2);
  const auto get = [&] { return cache.Get(carrier, [&] { return fit(); }); };
  const auto first = get();
  EXPECT_EQ(get(), first);
  EXPECT_EQ(fit.fits, 1);
  carrier.end = std::nextafter(carrier.end, 1.0);
  EXPECT_NE(get(), first);
  carrier.end = 0.0;
  carrier.chain[1].body.mass = 1.0;
  EXPECT_NE(get(), first);
  EXPECT_EQ(fit.fits, 3);
}

TEST(MovingBaseCache, KeepsTheEightLatestFits) {
  MovingBaseCache cache;
  Fitter fit;
  const auto get = [&](double t) {
    Carrier carrier;
    carrier.t = t;
    return cache.Get(carrier, [&] { return fit(); });
  };
  const auto oldest = get(0.0);
  for (int t = 1; t <= 7; ++t) get(t);
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
