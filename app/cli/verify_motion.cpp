#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/verify.h"
#include "engine/base/text.h"
#include "engine/exchange/export_motion.h"
#include "engine/exchange/motion_text.h"
#include "engine/project/json/text_file.h"

namespace hazumi {

namespace {

using Json = nlohmann::ordered_json;

// What differs between two trees of values, the first of it and how much there is.
class Comparison {
 public:
  explicit Comparison(const Json& joints) : joints_(joints) {}

  // `place` is said of the first difference.
  void Compare(const Json& made, const Json& again, const std::string& place) {
    if (made.is_number() && again.is_number()) return CompareNumbers(made, again, place);
    if (made.type() != again.type()) return Differ(place, made.dump(), again.dump());
    if (made.is_object()) return CompareObjects(made, again, place);
    if (made.is_array()) return CompareLists(made, again, place);
    ++values_;
    if (made != again) Differ(place, made.dump(), again.dump());
  }

  long values() const { return values_; }
  long differences() const { return differences_; }
  double largest() const { return largest_; }
  const std::string& first() const { return first_; }

 private:
  void CompareNumbers(const Json& made, const Json& again, const std::string& place) {
    ++values_;
    const double a = made.get<double>(), b = again.get<double>();
    if (a == b) return;
    largest_ = std::max(largest_, std::abs(a - b));
    Differ(place, FormatNumber(a), FormatNumber(b), ", by " + FormatShort(std::abs(a - b)));
  }

  void CompareObjects(const Json& made, const Json& again, const std::string& place) {
    for (const auto& item : made.items()) {
      const std::string inner = place.empty() ? item.key() : place + ", " + item.key();
      if (item.key() == "microseconds" || item.key() == "made_by") continue;
      if (!again.contains(item.key())) {
        Differ(inner, "there", "missing");
      } else {
        Compare(item.value(), again[item.key()], inner);
      }
    }
    for (const auto& item : again.items()) {
      if (made.contains(item.key())) continue;
      // Motions that older builds made lack them.
      if (item.key() != "made_by" && item.key() != "seams") {
        Differ(place + " " + item.key(), "missing", "there");
      }
    }
  }

  void CompareLists(const Json& made, const Json& again, const std::string& place) {
    if (made.size() != again.size()) {
      return Differ(place, std::to_string(made.size()) + " items",
                    std::to_string(again.size()) + " items");
    }
    for (size_t i = 0; i < made.size(); ++i) Compare(made[i], again[i], ItemPlace(place, i, made));
  }

  // Frames by their number, values of a frame by joint, axes by letter.
  std::string ItemPlace(const std::string& place, size_t i, const Json& list) const {
    if (place == "frames" && list[i].is_object() && list[i].contains("frame")) {
      return "frame " + list[i]["frame"].dump();
    }
    if (list.size() == joints_.size() && i < joints_.size() && joints_[i].is_string()) {
      return place + " of " + joints_[i].get<std::string>();
    }
    return place + "[" + std::to_string(i) + "]";
  }

  void Differ(const std::string& place, const std::string& made, const std::string& again,
              const std::string& by = "") {
    ++differences_;
    if (first_.empty()) first_ = place + ": " + made + " as made, " + again + " again" + by;
  }

  const Json& joints_;
  long values_ = 0, differences_ = 0;
  double largest_ = 0.0;
  std::string first_;
};

struct MadeMotion {  // NOLINT(bugprone-exception-escape): of the moves of its parts
  Json json;
  std::string maker;
  std::vector<std::string> options;
};

Result<MadeMotion> ReadMotion(const std::string& file) {
  const Result<std::string> text = ReadTextFile(file);
  if (!text.ok()) return text.error();
  MadeMotion made;
  made.json = Json::parse(text.value(), nullptr, false);
  if (!made.json.is_object() || made.json.value("format", Json()) != "hazumi-motion") {
    return Error{ErrorCode::kSyntax, file, "", "is no motion that --bake wrote as .json"};
  }
  const Json maker = made.json.value("made_by", Json::object());
  if (!maker.is_object()) return made;
  const Json program = maker.value("program", Json()), options = maker.value("options", Json());
  if (program.is_string()) made.maker = program.get<std::string>();
  for (const Json& word : options.is_array() ? options : Json::array()) {
    if (word.is_string()) made.options.push_back(word.get<std::string>());
  }
  return made;
}

}  // namespace

Result<Verdict> VerifyMotion(const std::string& project, const std::string& motion_file) {
  const Result<MadeMotion> made = ReadMotion(motion_file);
  if (!made.ok()) return made.error();
  // --export takes the options of --bake, and --frames.
  const Result<Options> options =
      OptionsToMakeAgain({"--export", "again.json"}, made.value().options, project);
  if (!options.ok()) return options.error();
  Result<BakedProject> baked = LoadAndBake(project, options.value());
  if (!baked.ok()) return baked.error();
  Motion& motion = baked.value().motion;
  const auto& asked = options.value().frames;
  if (asked && !motion.frames.empty()) {
    motion = PartOf(motion, std::max(asked->first, motion.frames.front().frame),
                    std::min(asked->last, motion.frames.back().frame));
  }
  const Json again =
      Json::parse(MotionToJson(baked.value().animation, motion,
                               {false, options.value().torques, {}, options.value().effort}));
  Comparison comparison(again["joints"]);
  comparison.Compare(made.value().json, again, "");
  Verdict verdict;
  RemarkOnMaker(made.value().maker, &verdict);
  verdict.is_same = comparison.differences() == 0;
  verdict.sentence = verdict.is_same
                         ? "the same: " + std::to_string(comparison.values()) + " values of " +
                               std::to_string(again["frames"].size()) + " frames"
                         : "differs: " + comparison.first() + "; " +
                               std::to_string(comparison.differences()) + " of " +
                               std::to_string(comparison.values()) + " values differ, by " +
                               FormatShort(comparison.largest()) + " at most";
  return verdict;
}

}  // namespace hazumi
