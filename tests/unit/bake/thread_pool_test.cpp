// Threads that do jobs together.

#include "engine/bake/thread_pool.h"

#include <gtest/gtest.h>

#include <new>
#include <set>

#include "engine/bake/bake.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "tests/support/animations.h"

namespace hazumi::test {
namespace {

TEST(ThreadPool, DoesEachJobOnceHoweverManyThereAre) {
  ThreadPool pool(3);
  for (int round = 0; round < 500; ++round) {
    const int count = round % 7;
    std::vector<std::atomic<int>> done(count);
    pool.Do(count, [&](int i) { ++done[i]; });
    for (const std::atomic<int>& times : done) ASSERT_EQ(times, 1) << "round " << round;
  }
}

// Each of two jobs waits for the other to begin: one thread alone would never finish.
TEST(ThreadPool, DoesTwoJobsAtOnce) {
  ThreadPool pool(2);
  std::atomic<int> begun = 0;
  pool.Do(2, [&](int) {
    ++begun;
    while (begun < 2) std::this_thread::yield();
  });
  EXPECT_EQ(begun, 2);
}

TEST(ThreadPool, DoesOneJobInTheCallersThread) {
  ThreadPool pool(2);
  std::thread::id thread;
  pool.Do(1, [&](int) { thread = std::this_thread::get_id(); });
  EXPECT_EQ(thread, std::this_thread::get_id());
}

TEST(ThreadPool, OfOneDoesAllJobsInTheCallersThread) {
  ThreadPool pool(1);
  std::set<std::thread::id> threads;
  pool.Do(20, [&](int) { threads.insert(std::this_thread::get_id()); });
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(ThreadPool, ThrowsWhatAJobThrewAfterAllOthersAreDone) {
  ThreadPool pool(3);
  for (int round = 0; round < 200; ++round) {
    std::atomic<int> done = 0;
    const auto job = [&](int i) {
      if (i == round % 5) throw std::bad_alloc();
      ++done;
    };
    EXPECT_THROW(pool.Do(5, job), std::bad_alloc);
    EXPECT_EQ(done, 4);
    pool.Do(5, [&](int) { ++done; });
    EXPECT_EQ(done, 9);
  }
}

// Both arms and their control solutions are four jobs.
TEST(Bake, GivesTheSameBitsOnAnyNumberOfThreads) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/throw.kfa";
  const Animation animation = CompileAnimation(LoadProject(path).value()).value().animation;
  const auto bake = [&](int threads) {
    BakeOptions options;
    options.threads = threads;
    return Bake(animation, options).value();
  };
  const Motion alone = bake(1);
  for (int round = 0; round < 20; ++round) {
    const Motion together = bake(2 + round % 3);
    ASSERT_EQ(alone.regions[0].error_estimate, together.regions[0].error_estimate);
    ASSERT_EQ(alone.regions[0].evaluations, together.regions[0].evaluations);
    ASSERT_EQ(alone.events.size(), together.events.size());
    for (size_t f = 0; f < alone.frames.size(); ++f) {
      ASSERT_TRUE(IsSame(alone.frames[f], together.frames[f])) << "frame " << f;
    }
  }
}

// With an account of the energy regions are solved step by step instead of all at once.
TEST(Bake, GivesTheSameMotionWithAnAccountOfEnergy) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/throw.kfa";
  const Animation animation = CompileAnimation(LoadProject(path).value()).value().animation;
  BakeOptions options;
  options.energy = true;
  const Motion with = Bake(animation, options).value(), without = Bake(animation).value();
  EXPECT_EQ(with.regions[0].error_estimate, without.regions[0].error_estimate);
  EXPECT_EQ(with.events.size(), without.events.size());
  for (size_t f = 0; f < with.frames.size(); ++f) {
    ASSERT_TRUE(IsSame(with.frames[f], without.frames[f])) << "frame " << f;
  }
}

}  // namespace
}  // namespace hazumi::test
