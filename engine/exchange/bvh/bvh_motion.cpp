#include "engine/exchange/bvh/bvh_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/base/text.h"
#include "engine/exchange/character/character_check.h"

namespace hazumi {

namespace {

// Tolerance of the number of values that is estimated from the first row: rows differ in length.
constexpr double kMaxBvhTake = 1.2;
// Rows by which the number of keys is estimated.
constexpr size_t kRowsForKeys = 100;

// Values on one line of the file.
struct Row {
  int line = 0;
  size_t count = 0;
};

// What follows a heading such as "Frame Time:" on a line, in any case and with any blanks; nothing
// if the line has another heading.
std::optional<std::string_view> After(std::string_view line, std::string_view heading) {
  size_t at = 0;
  for (const char c : heading) {
    while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) ++at;
    if (at >= line.size() || !IsKeyword(line.substr(at, 1), std::string_view(&c, 1)))
      return std::nullopt;
    ++at;
  }
  line = Trimmed(line.substr(at));
  if (!line.empty() && line[0] == ':') line = Trimmed(line.substr(1));
  return line;
}

class MotionReader {
 public:
  MotionReader(const BvhSkeleton& skeleton, const ReadChoice& choice, BvhScanner* scanner,
               std::vector<Warning>* warnings)
      : skeleton_(skeleton), choice_(choice), scanner_(*scanner), warnings_(*warnings) {}

  Result<BvhMotion> Read();

 private:
  Result<Done> ReadHead();
  Result<Done> SetFrameTime(std::string_view written);
  Result<Done> ReadRows();
  std::optional<Error> WhyTooLong(double rows) const;
  std::optional<Error> WhyTooManyKeysIn(double rows) const;
  Result<Done> ReadRow(std::string_view line);
  bool IsCutNumber(std::string_view word) const;
  Result<Done> FitRows();
  bool AreWhole() const;
  bool AreWrapped() const;
  Result<Done> Repair();
  void CheckFrameCount();
  double Limit(size_t column) const;
  std::string Column(size_t column) const;
  size_t width() const { return skeleton_.channels.size(); }
  size_t NumFrames() const { return motion_.values.size() / width(); }
  void Warn(int line, std::string message) {
    warnings_.push_back({LinePlace(line), std::move(message)});
  }
  Error Fault(std::string message) const { return BvhError(scanner_.line(), std::move(message)); }

  const BvhSkeleton& skeleton_;
  const ReadChoice& choice_;
  BvhScanner& scanner_;
  std::vector<Warning>& warnings_;
  BvhMotion motion_;
  std::string frames_;   // as the file says; empty: not at all
  int frames_line_ = 0;  // or that of MOTION
  std::vector<Row> rows_;
};

Result<BvhMotion> MotionReader::Read() {
  frames_line_ = scanner_.line();
  if (width() == 0)
    return Fault("no joint has channels, so nothing moves; export the file with its animation");
  for (const auto step :
       {&MotionReader::ReadHead, &MotionReader::ReadRows, &MotionReader::FitRows}) {
    Result<Done> done = (this->*step)();
    if (!done.ok()) return done.error();
  }
  if (NumFrames() == 0) return Fault("MOTION has no frame; export the file with its animation");
  if (NumFrames() > kMaxBvhFrames) {
    return Fault("more than " + std::to_string(kMaxBvhFrames) +
                 " frames; export a shorter stretch or at a lower rate");
  }
  CheckFrameCount();
  motion_.num_frames = static_cast<int>(NumFrames());
  return std::move(motion_);
}

// The lines "Frames: N" and "Frame Time: t", in either order.
Result<Done> MotionReader::ReadHead() {
  for (BvhScanner ahead = scanner_;; scanner_ = ahead) {
    const std::string_view line = ahead.Line();
    if (const auto frames = After(line, "frames")) {
      frames_ = std::string(*frames);
      frames_line_ = ahead.line();
    } else if (const auto time = After(line, "frametime")) {
      scanner_ = ahead;
      Result<Done> set = SetFrameTime(*time);
      if (!set.ok()) return set;
    } else {
      break;
    }
  }
  if (motion_.seconds_per_frame > 0.0) return Done{};
  return Fault("MOTION has no Frame Time; add a line such as \"Frame Time: 0.0333333\" for 30 fps");
}

Result<Done> MotionReader::SetFrameTime(std::string_view written) {
  constexpr double kShortest = 1e-5, kLongest = 60.0;
  double seconds = 0.0;
  if (!ParseBvhNumber(written, &seconds)) {
    return Fault("Frame Time: " + WhyNoBvhNumber(written, kLongest));
  }
  if (!(seconds >= kShortest && seconds <= kLongest)) {
    return Fault("Frame Time " + QuotedWord(written) +
                 " is no time between frames; write seconds, such as 0.0333333 for 30 fps");
  }
  const SnappedFrameTime snapped = SnapFrameTime(seconds, written);
  motion_.seconds_per_frame = snapped.seconds;
  if (snapped.was_coarse) {
    Warn(scanner_.line(), "Frame Time " + std::string(written) + " was taken as 1/" +
                              FormatNumber(std::round(1.0 / snapped.seconds)) + " s");
  }
  return Done{};
}

Result<Done> MotionReader::ReadRows() {
  const size_t bytes = scanner_.bytes_left();
  for (std::string_view line = scanner_.Line(); !line.empty(); line = scanner_.Line()) {
    Result<Done> read = ReadRow(line);
    if (!read.ok()) return read;
    if (rows_.size() != 1 && rows_.size() != kRowsForKeys) continue;
    const auto left = static_cast<double>(scanner_.bytes_left());
    const double part = 1.0 - left / static_cast<double>(bytes);
    const double rows = static_cast<double>(rows_.size()) / part;  // estimate
    if (auto error = rows_.size() == 1 ? WhyTooLong(rows) : WhyTooManyKeysIn(rows)) return *error;
  }
  return Done{};
}

// Refuses a take that is too long, estimated from its first row: reading it would take minutes.
std::optional<Error> MotionReader::WhyTooLong(double rows) const {
  const double values = rows * static_cast<double>(rows_[0].count);
  if (values <= kMaxBvhTake * static_cast<double>(kMaxBvhValues)) return std::nullopt;
  return Fault("the take has about " + FormatShort(rows) + " frames (" +
               FormatShort(rows * motion_.seconds_per_frame / 60.0) + " minutes) of " +
               std::to_string(rows_[0].count) + " channels, " + FormatShort(1e-6 * values) +
               " million values; " + FormatShort(1e-6 * static_cast<double>(kMaxBvhValues)) +
               " million are read: export a stretch of it, or at a lower rate");
}

// Counts the curves of the rotations that move in the first rows, and those of the root's place.
std::optional<Error> MotionReader::WhyTooManyKeysIn(double rows) const {
  if (!choice_.keys_all_frames || motion_.values.size() != width() * rows_.size()) {
    return std::nullopt;
  }
  int curves = 3;
  for (size_t column = 0; column < width(); ++column) {
    if (!skeleton_.channels[column].is_rotation) continue;
    bool moves = false;
    for (size_t at = column; at < motion_.values.size(); at += width()) {
      moves |= motion_.values[at] != motion_.values[column];
    }
    curves += moves;
  }
  const double seconds = rows * motion_.seconds_per_frame;
  return WhyTooManyKeys(curves, choice_.rate > 0.0 ? choice_.rate * seconds : rows, seconds);
}

Result<Done> MotionReader::ReadRow(std::string_view line) {
  Row row{scanner_.line(), 0};
  for (std::string_view word = TakeWord(&line); !word.empty(); word = TakeWord(&line)) {
    double value = 0.0;
    if (!ParseBvhNumber(word, &value) || !(std::abs(value) <= Limit(row.count))) {
      if (IsCutNumber(word)) break;
      return Fault("value " + std::to_string(row.count + 1) + " (" + Column(row.count) +
                   "): " + WhyNoBvhNumber(word, Limit(row.count)));
    }
    motion_.values.push_back(value);
    ++row.count;
  }
  rows_.push_back(row);
  if (motion_.values.size() <= kMaxBvhValues) return Done{};
  return Fault("more than " + std::to_string(kMaxBvhValues) +
               " values; export a shorter stretch or at a lower rate");
}

// Such as "-" or "1e" where the file ends: the row is too short then, and says so.
bool MotionReader::IsCutNumber(std::string_view word) const {
  return word.data() + word.size() == scanner_.text().data() + scanner_.text().size() &&
         word.find_first_not_of("0123456789+-.eE") == word.npos &&
         (word.back() < '0' || word.back() > '9');
}

// Makes every frame as wide as there are channels.
Result<Done> MotionReader::FitRows() {
  if (AreWhole()) return Done{};
  if (!AreWrapped()) return Repair();
  Warn(rows_[0].line, "frames are broken over several lines and were joined");
  return Done{};
}

bool MotionReader::AreWhole() const {
  return std::all_of(rows_.begin(), rows_.end(), [&](const Row& r) { return r.count == width(); });
}

// Whether lines add up to whole frames, as many as the file says.
bool MotionReader::AreWrapped() const {
  double frames = 0.0;
  if (!ParseBvhNumber(frames_, &frames) ||
      frames * static_cast<double>(width()) != static_cast<double>(motion_.values.size())) {
    return false;
  }
  size_t filled = 0;
  for (const Row& row : rows_) {
    filled += row.count;
    if (filled > width()) return false;
    if (filled == width()) filled = 0;
  }
  return filled == 0;
}

// Cuts what is too long; a last row that is too short was cut off and is left out.
Result<Done> MotionReader::Repair() {
  std::vector<double> whole;
  const Row* first_long = nullptr;
  int num_long = 0;
  size_t from = 0;
  for (const Row& row : rows_) {
    const auto begin = motion_.values.begin() + static_cast<std::ptrdiff_t>(from);
    from += row.count;
    if (row.count >= width()) whole.insert(whole.end(), begin, begin + static_cast<long>(width()));
    if (row.count > width() && num_long++ == 0) first_long = &row;
    if (row.count >= width()) continue;
    const std::string counts = "has " + std::to_string(row.count) +
                               " values where the channels need " + std::to_string(width());
    if (&row != &rows_.back()) {
      return BvhError(
          row.line,
          "the row " + counts + "; restore the missing values, delete the row, or export again");
    }
    Warn(row.line, "the last row " + counts + ": the file was cut here, the row was left out");
  }
  if (first_long) {
    Warn(first_long->line,
         std::to_string(num_long) + (num_long == 1 ? " row has " : " rows have ") +
             "more values than the " + std::to_string(width()) + " channels (here " +
             std::to_string(first_long->count) + "): what is too much was left out");
  }
  motion_.values = std::move(whole);
  return Done{};
}

void MotionReader::CheckFrameCount() {
  double said = 0.0;
  const auto frames = static_cast<double>(NumFrames());
  if (ParseBvhNumber(frames_, &said) && said == frames) return;
  Warn(frames_line_,
       (frames_.empty() ? "no number of Frames is given" : "Frames says " + QuotedWord(frames_)) +
           ", the file has " + FormatNumber(frames) + ": " + FormatNumber(frames) + " were read");
}

double MotionReader::Limit(size_t column) const {
  if (column >= width()) return std::numeric_limits<double>::max();  // is left out
  return skeleton_.channels[column].is_rotation ? kMaxBvhAngle : kMaxBvhLength;
}

std::string MotionReader::Column(size_t column) const {
  if (column >= width()) return "one more than there are channels";
  const BvhChannel& channel = skeleton_.channels[column];
  return QuotedWord(skeleton_.bones[static_cast<size_t>(channel.bone)].name) + " " +
         ChannelName(channel);
}

}  // namespace

Result<BvhMotion> ReadBvhMotion(const BvhSkeleton& skeleton, const ReadChoice& choice,
                                BvhScanner* scanner, std::vector<Warning>* warnings) {
  return MotionReader(skeleton, choice, scanner, warnings).Read();
}

}  // namespace hazumi
