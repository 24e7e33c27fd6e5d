#include "engine/bake/sensitivity/island_history.h"

#include <algorithm>
#include <utility>

#include "engine/bake/baker.h"

namespace hazumi {

namespace {

// The logs of all stretches, without control solutions, which share the task of the log before.
Result<IslandLogs> BakeLogs(const Animation& animation, int threads) {
  BakeOptions options;
  options.keep_frames = false;
  options.refine = false;
  options.threads = threads;
  Motion motion;
  ThreadPool pool(options.threads);
  Baker baker(animation, options, &motion, &pool);
  Result<Checkpoint> first = baker.Begin();
  if (!first.ok()) return first.error();
  const KnownLogs none;
  IslandLogs logs;
  Stretch stretch;
  stretch.start = std::move(first.value());
  for (;;) {
    Result<std::optional<Checkpoint>> next = baker.BakeStretch(&none, &stretch);
    if (!next.ok()) return next.error();
    std::shared_ptr<const IslandTask> task_before;
    for (const std::shared_ptr<const IslandLog>& log : stretch.logs) {
      if (!log || log->empty()) continue;
      const auto task = std::get<BeginIsland>(log->front().request).task;
      if (task != task_before) logs.push_back(log);
      task_before = task;
    }
    if (!next.value()) return logs;
    stretch = Stretch();
    stretch.start = std::move(*next.value());
  }
}

IslandHistory HistoryOf(const IslandLog& log) {
  IslandHistory history;
  for (const IslandCall& call : log) {
    if (const auto* begin = std::get_if<BeginIsland>(&call.request)) {
      history.task = begin->task;
      history.start = begin->state;
      history.pieces.push_back({begin->t, begin->end, begin->curves});
    } else if (const auto* drive = std::get_if<DriveIsland>(&call.request)) {
      history.pieces.back().end = std::min(history.pieces.back().end, drive->t);
      history.pieces.push_back({drive->t, drive->end, drive->curves});
    }
  }
  for (const ModelNode& node : history.task->model.nodes) {
    if (node.role != Role::kFree) continue;
    for (int h = 0; h < node.num_hinges; ++h) {
      history.hinges.push_back(node.hinges[static_cast<size_t>(h)].coordinate);
    }
  }
  return history;
}

bool Shares(const std::vector<Coordinate>& a, const std::vector<Coordinate>& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](Coordinate c) { return std::find(b.begin(), b.end(), c) != b.end(); });
}

}  // namespace

Result<std::vector<IslandHistory>> BakeHistories(const Animation& animation, int index,
                                                 int last_frame, int threads) {
  const DynamicsRegion& region = animation.regions[static_cast<size_t>(index)];
  Animation until = animation;
  until.last_frame = last_frame;
  Result<IslandLogs> logs = BakeLogs(until, threads);
  if (!logs.ok()) return logs.error();
  const double start = animation.rate.SecondsAt(region.first_frame);
  const double end = animation.rate.SecondsAt(until.last_frame);
  std::vector<Coordinate> of_region;
  for (const JointIndex j : region.joints) of_region.push_back(j.value());
  for (int i = 0; region.root && i < kRootAngles; ++i) {
    of_region.push_back(animation.figure->num_joints() + i);
  }
  std::vector<IslandHistory> histories;
  for (const std::shared_ptr<const IslandLog>& log : logs.value()) {
    const double t = std::get<BeginIsland>(log->front().request).t;
    if (t < start - kSameTime || t > end - kSameTime) continue;
    IslandHistory history = HistoryOf(*log);
    if (!Shares(history.hinges, of_region)) continue;
    for (const Coordinate c : history.hinges) {
      if (std::find(of_region.begin(), of_region.end(), c) != of_region.end()) continue;
      return Error{ErrorCode::kSemantics, "", "regions[" + std::to_string(index) + "]",
                   "its joints feel joints of another region; its motion can be derived only by "
                   "itself"};
    }
    for (IslandHistory& before : histories) {
      if (!Shares(before.hinges, history.hinges)) continue;
      while (before.pieces.size() > 1 && before.pieces.back().start >= t) before.pieces.pop_back();
      before.pieces.back().end = std::min(before.pieces.back().end, t);
    }
    histories.push_back(std::move(history));
  }
  for (IslandHistory& history : histories) {
    history.pieces.back().end = std::min(history.pieces.back().end, end);
  }
  std::stable_sort(histories.begin(), histories.end(),
                   [](const IslandHistory& a, const IslandHistory& b) {
                     return a.pieces.front().start < b.pieces.front().start;
                   });
  return histories;
}

}  // namespace hazumi
