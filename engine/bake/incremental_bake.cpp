#include "engine/bake/incremental_bake.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <new>
#include <tuple>
#include <utility>

#include "engine/bake/bake_size.h"
#include "engine/bake/baker.h"
#include "engine/bake/edit_reach.h"
#include "engine/bake/flight_events.h"
#include "engine/base/assert.h"
#include "engine/base/memory.h"

namespace hazumi {

namespace {

// All but keys and the settings of regions, which an edit may change without a new start. Every
// member is named, so that one that is added is not forgotten here.
auto FixedPartsOf(const Animation& animation) {
  const auto& [figure, rate, first_frame, last_frame, solver, gravity, root_keys, joint_keys,
               regions, placements, holds, held_objects, scene, forces, constraints] = animation;
  return std::tuple_cat(std::tie(figure, rate, first_frame, last_frame, solver, gravity, placements,
                                 holds, held_objects, scene, forces, constraints),
                        std::make_tuple(regions.size()));
}

std::optional<Error> CheckSize(const Animation& animation) {
  const double bytes = MotionBytes(animation, animation.rate) + LogBytes(animation);
  return CheckBytes(bytes, animation, animation.rate);
}

}  // namespace

// The stretches baked so far, and which of them an edit has made stale.
class IncrementalBake::State {
 public:
  State(Animation animation, const BakeOptions& options);

  void Update(const Animation& animation);
  std::optional<Error> BakeTo(int frame);
  bool is_fresh(int frame) const { return frame < fresh_until_; }
  int last_frame() const { return animation_.last_frame; }
  int fresh_until() const { return fresh_until_; }
  const Motion& motion() const { return motion_; }
  int stretches_baked() const { return stretches_baked_; }
  double work() const { return work_of_bakers_before_ + (baker_ ? baker_->work() : 0.0); }

 private:
  // A stretch, and whether it has to be baked again from its start.
  struct Part {
    Stretch stretch;
    bool is_stale = true;
  };
  using Parts = std::map<int, Part>;  // by first frame

  void StartAnew(const Animation& animation);
  void DropBaker();
  void Forget(const Error& error);
  std::optional<Error> BakeFurther(int frame);
  void ChangeKeys(const Keys& next, Keys* keys, EditReach* reach);
  void ChangeRegions(const Animation& next, EditReach* reach);
  void MakeStale(const EditReach& reach);
  void KeepLogs(const Stretch& stretch);
  std::optional<Error> Begin();
  std::optional<Error> BakeStaleStretch();
  void Join(std::optional<Checkpoint> next);
  void CollectEvents();

  Animation animation_;
  BakeOptions options_;
  ThreadPool pool_;
  Motion motion_;
  std::unique_ptr<Baker> baker_;
  Parts parts_;
  bool has_begun_ = false;  // the first part's start is right
  // Where the first stale part begins, whose start is right; those of later ones may not be.
  std::atomic<int> fresh_until_ = 0;
  KnownLogs known_;  // of stretches that are no more
  std::optional<Error> error_;
  int stretches_baked_ = 0;
  double work_of_bakers_before_ = 0.0;
};

IncrementalBake::State::State(Animation animation, const BakeOptions& options)
    : options_(options), pool_(options.threads) {
  HAZUMI_ASSERT(std::isinf(options.most_work));  // stretches depend on nothing but their start
  Update(animation);
}

void IncrementalBake::State::StartAnew(const Animation& animation) {
  animation_ = animation;
  for (const auto& [frame, part] : parts_) KeepLogs(part.stretch);
  parts_.clear();
  MakeStale(EditReach::Everything());
  DropBaker();
  try {
    baker_ = std::make_unique<Baker>(animation_, options_, &motion_, &pool_);
  } catch (const std::bad_alloc&) {
    Forget(OutOfMemory());
  }
}

void IncrementalBake::State::DropBaker() {
  work_of_bakers_before_ = work();
  baker_.reset();
}

// There is no motion, and what there was of it takes no memory any more.
void IncrementalBake::State::Forget(const Error& error) {
  DropBaker();
  parts_.clear();
  known_.clear();
  motion_ = Motion();
  MakeStale(EditReach::Everything());
  error_ = error;
}

void IncrementalBake::State::KeepLogs(const Stretch& stretch) { known_.Add(stretch.logs); }

void IncrementalBake::State::Update(const Animation& animation) {
  if (const auto error = CheckSize(animation)) {
    animation_ = animation;
    return Forget(*error);
  }
  if (!baker_ || FixedPartsOf(animation_) != FixedPartsOf(animation)) return StartAnew(animation);
  EditReach reach;
  for (size_t j = 0; j < animation.joint_keys.size(); ++j) {
    ChangeKeys(animation.joint_keys[j], &animation_.joint_keys[j], &reach);
  }
  for (size_t i = 0; i < animation.root_keys.size(); ++i) {
    ChangeKeys(animation.root_keys[i], &animation_.root_keys[i], &reach);
  }
  if (animation_.regions != animation.regions) ChangeRegions(animation, &reach);
  reach.IncludeBlends(animation_);
  if (!reach.is_empty()) MakeStale(reach);
}

void IncrementalBake::State::ChangeKeys(const Keys& next, Keys* keys, EditReach* reach) {
  if (!reach->IncludeKeys(*keys, next)) return;
  baker_->RemoveKeys(*keys);
  *keys = next;
  baker_->AddKeys(*keys);
}

void IncrementalBake::State::ChangeRegions(const Animation& next, EditReach* reach) {
  for (size_t r = 0; r < next.regions.size(); ++r) {
    if (animation_.regions[r] == next.regions[r]) continue;
    reach->IncludeRegion(animation_.regions[r], animation_);
    reach->IncludeRegion(next.regions[r], animation_);
  }
  animation_.regions = next.regions;
  baker_->RegionsChanged();
}

void IncrementalBake::State::MakeStale(const EditReach& reach) {
  error_.reset();
  auto part = parts_.begin();
  if (reach.first() < animation_.first_frame) {
    has_begun_ = false;
    fresh_until_ = animation_.first_frame;
  } else if (!parts_.empty()) {
    part = std::prev(parts_.upper_bound(static_cast<int>(std::floor(reach.first()))));
    fresh_until_ = std::min(fresh_until_.load(), part->first);
  }
  for (; part != parts_.end() && part->first <= reach.last(); ++part) part->second.is_stale = true;
}

std::optional<Error> IncrementalBake::State::BakeTo(int frame) {
  try {
    return BakeFurther(frame);
  } catch (const std::bad_alloc&) {
    Forget(OutOfMemory());
    return error_;
  }
}

std::optional<Error> IncrementalBake::State::BakeFurther(int frame) {
  frame = std::min(frame, animation_.last_frame);
  if (is_fresh(frame)) return std::nullopt;
  while (!error_ && !is_fresh(frame)) {
    std::optional<Error> error = has_begun_ ? BakeStaleStretch() : Begin();
    if (!error) continue;
    if (error->code == ErrorCode::kInterrupted) return error;
    error_ = std::move(error);
  }
  known_.clear();
  CollectEvents();
  return error_;
}

std::optional<Error> IncrementalBake::State::Begin() {
  Result<Checkpoint> start = baker_->Begin();
  if (!start.ok()) return start.error();
  parts_[animation_.first_frame].stretch.start = std::move(start.value());
  has_begun_ = true;
  return std::nullopt;
}

std::optional<Error> IncrementalBake::State::BakeStaleStretch() {
  if (!animation_.regions.empty()) pool_.Expect();
  const auto part = parts_.find(fresh_until_);
  KeepLogs(part->second.stretch);
  if (const auto next = std::next(part); next != parts_.end()) KeepLogs(next->second.stretch);
  Result<std::optional<Checkpoint>> end = baker_->BakeStretch(&known_, &part->second.stretch);
  if (!end.ok()) return end.error();
  ++stretches_baked_;
  part->second.is_stale = false;
  Join(std::move(end.value()));
  return std::nullopt;
}

// What comes next is stale unless it begins in the same way as before.
void IncrementalBake::State::Join(std::optional<Checkpoint> next) {
  auto after = parts_.upper_bound(fresh_until_);
  while (after != parts_.end() && !(next && after->first >= next->frame)) {
    KeepLogs(after->second.stretch);
    after = parts_.erase(after);
  }
  if (next) {
    const bool is_new = after == parts_.end() || after->first != next->frame;
    if (is_new) after = parts_.emplace_hint(after, next->frame, Part());
    if (is_new || after->second.stretch.start != *next) {
      after->second.stretch.start = std::move(*next);
      after->second.is_stale = true;
    }
  }
  const auto stale =
      std::find_if(after, parts_.end(), [](const auto& p) { return p.second.is_stale; });
  fresh_until_ = stale == parts_.end() ? animation_.last_frame + 1 : stale->first;
}

void IncrementalBake::State::CollectEvents() {
  motion_.events.clear();
  motion_.warnings.clear();
  motion_.placement_jumps.clear();
  motion_.seams.clear();
  for (const auto& [frame, part] : parts_) part.stretch.AppendTo(&motion_);
  TellFlights(animation_, &motion_);
  DropRepeated(&motion_.warnings);
}

IncrementalBake::IncrementalBake(Animation animation, const BakeOptions& options)
    : state_(std::make_unique<State>(std::move(animation), options)) {}
IncrementalBake::~IncrementalBake() = default;

void IncrementalBake::Update(const Animation& animation) { state_->Update(animation); }
std::optional<Error> IncrementalBake::BakeTo(int frame) { return state_->BakeTo(frame); }
std::optional<Error> IncrementalBake::Finish() { return state_->BakeTo(state_->last_frame()); }
int IncrementalBake::fresh_until() const { return state_->fresh_until(); }
const Motion& IncrementalBake::motion() const { return state_->motion(); }
int IncrementalBake::stretches_baked() const { return state_->stretches_baked(); }
double IncrementalBake::work() const { return state_->work(); }

}  // namespace hazumi
