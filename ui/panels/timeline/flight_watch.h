#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "engine/analysis/flights.h"
#include "ui/edit/session/session.h"

namespace hazumi::ui {

// Finds flights in what keys and pins make of the figure [engine/analysis], beside the interface,
// whenever the motion has come to rest after an edit. What gravity places flies by itself and is
// left out.
class FlightWatch {
 public:
  ~FlightWatch();

  // Looks at the motion if it is another one than before and nothing is being dragged. Waits for
  // what it finds if the session has patience without end.
  void Look(edit::Session* session);
  // It is at work.
  bool is_busy() const { return job_ != nullptr; }

  // Of the motion that was looked at last. Frames as the project numbers them.
  const FlightAnalysis& analysis() const { return analysis_; }
  // True once for each document in which gravity says that the frame rate or lengths are wrong.
  bool TakeAlarm() { return std::exchange(has_alarm_, false); }

 private:
  struct Version {
    long document = -1, revision = -1;
    bool operator==(const Version&) const = default;
  };
  struct Job {
    long document = -1;
    std::shared_ptr<const Figure> figure;
    Motion motion;
    bool size_is_guessed = false;
    double gravity = 9.81;
    std::vector<PlacementSpan> placements;
    FlightAnalysis analysis;
    std::atomic<bool> has_ended = false;  // the analysis is there
    std::thread thread;
  };
  void Begin(edit::Session* session, const Motion& motion);
  void End(long document);

  Version seen_;
  long shown_ = -1;    // document that the analysis is about
  long alarmed_ = -1;  // document
  bool has_alarm_ = false;
  FlightAnalysis analysis_;
  std::unique_ptr<Job> job_;
};

// The first and the last frame in the air.
int FirstFrameOf(const Flight& flight);
int LastFrameOf(const Flight& flight);

}  // namespace hazumi::ui
