#include "engine/exchange/onto/bvh_onto.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/base/text.h"
#include "engine/exchange/bvh/bvh_scanner.h"
#include "engine/exchange/bvh/bvh_skeleton.h"
#include "engine/exchange/units.h"
#include "engine/spatial/degrees.h"
#include "engine/spatial/euler_angles.h"

namespace hazumi {

namespace {

constexpr double kRepresented = 1e-4;  // by fewer than three angles [rad]

// A word of the motion, where it lies in the text.
struct Word {
  size_t at = 0, size = 0;
};

std::string Number(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

bool IsBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r') || c == '\x1a'; }

class OntoBvh {
 public:
  OntoBvh(std::string_view text, const Character& source, const EditedClip& clip)
      : text_(text), source_(source), clip_(clip) {}

  Result<std::string> Write() {
    if (clip_.bones.empty()) return std::string(text_);
    if (auto error = FindRows()) return *error;
    changed_.assign(words_.size(), "");
    const int last = clip_.first + clip_.num_frames - 1;
    for (int frame = num_rows(); frame <= last; ++frame) AddRow();
    for (const EditedBone& bone : clip_.bones) {
      if (auto error = Put(bone)) return *error;
    }
    return Assembled();
  }

 private:
  size_t width() const { return skeleton_.channels.size(); }
  int num_rows() const { return clip_.num_source_frames; }
  static Error Wrong(const std::string& place, const std::string& message) {
    return {ErrorCode::kSemantics, "", place, message};
  }

  // Where the numbers of the motion lie: behind the lines of MOTION that end in no number alone.
  std::optional<Error> FindRows() {
    if (clip_.first < 0)
      return Wrong("frame " + std::to_string(clip_.first), "lies before the file's first row");
    BvhScanner scanner(text_);
    std::vector<Warning> ignored;
    Result<BvhSkeleton> skeleton = ReadBvhSkeleton(&scanner, &ignored);
    if (!skeleton.ok()) return skeleton.error();
    skeleton_ = std::move(skeleton).value();
    for (BvhScanner ahead = scanner;; scanner = ahead) {
      std::string_view line = ahead.Line();
      double number = 0.0;
      if (line.empty() || ParseBvhNumber(TakeWord(&line), &number)) break;
      FindCount(ahead, scanner);
    }
    for (size_t at = text_.size() - scanner.bytes_left(); at < text_.size();) {
      while (at < text_.size() && IsBlank(text_[at])) ++at;
      const size_t begin = at;
      while (at < text_.size() && !IsBlank(text_[at])) ++at;
      if (at > begin) words_.push_back({begin, at - begin});
    }
    if (words_.size() == width() * static_cast<size_t>(num_rows())) return std::nullopt;
    return Wrong("MOTION", "has " + std::to_string(words_.size()) + " numbers, not the " +
                               std::to_string(width()) + " of each of the clip's " +
                               std::to_string(num_rows()) +
                               " frames, at the rate of the project; give the project the rate of "
                               "the file, or export it by itself");
  }

  // The number of a line such as "Frames: 30".
  void FindCount(const BvhScanner& after, const BvhScanner& before) {
    const size_t begin = text_.size() - before.bytes_left(),
                 end = text_.size() - after.bytes_left();
    const std::string_view line = text_.substr(begin, end - begin);
    if (LowerCase(std::string(line)).find("frames") == line.npos) return;
    const size_t digit = line.find_first_of("0123456789");
    if (digit == line.npos) return;
    size_t behind = digit;
    while (behind < line.size() && !IsBlank(line[behind])) ++behind;
    count_ = {begin + digit, behind - digit};
  }

  // One more row, equal to the file's last.
  void AddRow() {
    for (size_t c = 0; c < width(); ++c) {
      const Word& word = words_[width() * static_cast<size_t>(num_rows() - 1) + c];
      changed_.emplace_back(text_.substr(word.at, word.size));
    }
  }

  std::string* Cell(int frame, size_t column) {
    return &changed_[width() * static_cast<size_t>(frame) + column];
  }

  double ValueAt(int frame, size_t column) {
    const std::string& other = *Cell(frame, column);
    double value = 0.0;
    const size_t cell = width() * static_cast<size_t>(frame) + column;
    ParseBvhNumber(
        other.empty() ? text_.substr(words_[cell].at, words_[cell].size) : std::string_view(other),
        &value);
    return value;
  }

  std::optional<Error> Put(const EditedBone& bone) {
    std::vector<size_t> turns, moves;
    for (size_t c = 0; c < width(); ++c) {
      if (skeleton_.channels[c].bone != bone.node) continue;
      (skeleton_.channels[c].is_rotation ? turns : moves).push_back(c);
    }
    for (int i = 0; i < clip_.num_frames; ++i) {
      if (!bone.is_changed[static_cast<size_t>(i)]) continue;
      const int frame = clip_.first + i;
      if (auto error = PutTurn(bone, static_cast<size_t>(i), frame, turns)) return error;
      if (auto error = PutPlace(bone, static_cast<size_t>(i), frame, moves)) return error;
    }
    return std::nullopt;
  }

  std::optional<Error> PutTurn(const EditedBone& bone, size_t i, int frame,
                               const std::vector<size_t>& columns) {
    if (bone.rotations.empty()) return std::nullopt;
    const std::string& order = source_.bones[static_cast<size_t>(bone.node)].rotation_order;
    const auto axes = EulerAxesOf(order);
    if (columns.empty() || !axes) return Wrong(bone.name, "turns, but has no channels for it");
    Vec3 previous = Vec3::Zero();
    for (size_t c = 0; c < columns.size(); ++c) {
      const double before = ValueAt(std::max(frame - 1, 0), columns[c]);
      previous[static_cast<Eigen::Index>(c)] = before * kDegree;
    }
    const Mat3 R = bone.rotations[i].toRotationMatrix();
    const Vec3 angles = EulerAnglesNear(R, *axes, previous);
    for (size_t c = columns.size(); c < 3; ++c) {
      if (std::abs(angles[static_cast<Eigen::Index>(c)]) <= kRepresented) continue;
      return Wrong(bone.name, "turns otherwise than its channels, " + order +
                                  ", can say; keep its other angles, or export it by itself");
    }
    for (size_t c = 0; c < columns.size(); ++c)
      *Cell(frame, columns[c]) = Number(Degrees(angles[static_cast<Eigen::Index>(c)]));
    return std::nullopt;
  }

  std::optional<Error> PutPlace(const EditedBone& bone, size_t i, int frame,
                                const std::vector<size_t>& columns) {
    if (bone.translations.empty()) return std::nullopt;
    if (columns.size() < 3) return Wrong(bone.name, "moves, but has no channels for it");
    for (const size_t c : columns)
      *Cell(frame, c) = Number(bone.translations[i][skeleton_.channels[c].axis]);
    return std::nullopt;
  }

  std::string Assembled() const {
    std::string written;
    size_t done = 0;
    const auto replace = [&](const Word& word, const std::string& text) {
      written += text_.substr(done, word.at - done);
      written += text;
      done = word.at + word.size;
    };
    const size_t rows = changed_.size() / width();
    if (rows > static_cast<size_t>(num_rows()) && count_.size > 0)
      replace(count_, std::to_string(rows));
    for (size_t w = 0; w < words_.size(); ++w) {
      if (!changed_[w].empty()) replace(words_[w], changed_[w]);
    }
    if (rows == static_cast<size_t>(num_rows())) return written + std::string(text_.substr(done));
    const size_t end = words_.back().at + words_.back().size;
    written += text_.substr(done, end - done);
    const std::string line_end = text_.find("\r\n") == text_.npos ? "\n" : "\r\n";
    for (size_t w = words_.size(); w < changed_.size(); ++w)
      written += (w % width() == 0 ? line_end : " ") + changed_[w];
    return written + std::string(text_.substr(end));
  }

  const std::string_view text_;
  const Character& source_;
  const EditedClip& clip_;
  BvhSkeleton skeleton_;
  std::vector<Word> words_;           // of the rows
  std::vector<std::string> changed_;  // by word, then by those of more rows; empty: as it is
  Word count_;                        // of the frames
};

}  // namespace

Result<std::string> BvhOnto(std::string_view text, const Character& source,
                            const EditedClip& clip) {
  std::string_view body = text;
  std::string mark;
  if (body.starts_with("\xef\xbb\xbf")) {
    mark = body.substr(0, 3);
    body.remove_prefix(3);
  }
  Result<std::string> written = OntoBvh(body, source, clip).Write();
  if (!written.ok()) return written.error();
  return mark + written.value();
}

}  // namespace hazumi
