#include "engine/body/body_part.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <vector>

namespace hazumi {

namespace {

struct PartWords {
  BodyPart part;
  std::vector<const char*> words;
};

// The first row with a word that the name contains counts.
const std::vector<PartWords>& Words() {
  static const std::vector<PartWords> words = {
      {BodyPart::kTrunk, {"spine"}},  // "spine_middle" is no finger
      {BodyPart::kHead, {"eye"}},     // nor "eyeball" a ball of the foot
      {BodyPart::kHand,
       {"hand", "wrist", "palm", "finger", "thumb", "index", "middle", "ring", "pinky", "pinkie",
        "little"}},
      {BodyPart::kFoot, {"foot", "feet", "toe", "ankle", "heel", "ball"}},
      {BodyPart::kHead, {"head", "skull", "jaw", "eye", "face", "nose", "brow", "hair"}},
      {BodyPart::kNeck, {"neck"}},
      {BodyPart::kPelvis, {"hipjoint", "pelvis", "hips", "butt"}},
      {BodyPart::kThigh, {"upleg", "upperleg", "legupper", "thigh", "femur"}},
      {BodyPart::kShank,
       {"lowleg", "lowerleg", "leglower", "foreleg", "shin", "calf", "knee", "tibia", "shank"}},
      {BodyPart::kForearm,
       {"forearm", "lowarm", "lowerarm", "armlower", "elbow", "radius", "ulna"}},
      {BodyPart::kUpperArm, {"uparm", "upperarm", "armupper", "humerus", "shldr"}},
      {BodyPart::kTrunk,
       {"spine", "chest", "thorax", "torso", "abdomen", "back", "waist", "collar", "clavicle",
        "scapula", "breast"}}};
  return words;
}

bool IsAlpha(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool IsCapital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

// "lfemur", "rhand": a side, and at once what it is the side of.
bool IsSided(const std::string& word) {
  if (word.empty() || (word[0] != 'l' && word[0] != 'r')) return false;
  const auto begins = [&](const char* part) {
    return word.compare(1, std::strlen(part), part) == 0;
  };
  return std::any_of(Words().begin(), Words().end(), [&](const PartWords& row) {
    return std::any_of(row.words.begin(), row.words.end(), begins);
  });
}

// Takes the word that names a side away: "left", "l". "LHipJoint" begins with one.
BodySide TakeSide(const std::string& name, std::vector<std::string>* words) {
  for (auto word = words->begin(); word != words->end(); ++word) {
    for (const auto& [text, side] :
         {std::pair{"left", BodySide::kLeft}, {"right", BodySide::kRight}}) {
      if (!word->starts_with(text)) continue;
      word->erase(0, std::string(text).size());
      return side;
    }
    if (*word != "l" && *word != "r") continue;
    const BodySide side = *word == "l" ? BodySide::kLeft : BodySide::kRight;
    words->erase(word);
    return side;
  }
  const bool is_prefixed = name.size() > 2 && (name[0] == 'L' || name[0] == 'R') &&
                           IsCapital(name[1]) && IsAlpha(name[2]) && !IsCapital(name[2]);
  if (words->empty() || !(is_prefixed || IsSided(words->front()))) return BodySide::kMiddle;
  const char side = words->front()[0];
  words->front().erase(0, 1);
  return side == 'l' ? BodySide::kLeft : BodySide::kRight;
}

bool Has(const std::string& text, const char* word) { return text.find(word) != std::string::npos; }

void ReadPart(const std::string& text, ReadName* read) {
  for (const PartWords& row : Words()) {
    for (const char* word : row.words) {
      if (!Has(text, word)) continue;
      read->body.part = row.part;
      return;
    }
  }
  const bool is_middle = read->body.side == BodySide::kMiddle;
  const auto set = [&](BodyPart part, BodyWord word) {
    read->body.part = part;
    read->word = word;
  };
  if (Has(text, "hip")) {
    return is_middle ? set(BodyPart::kPelvis, BodyWord::kClear)
                     : set(BodyPart::kThigh, BodyWord::kHip);
  }
  if (Has(text, "shoulder")) {
    return is_middle ? set(BodyPart::kOther, BodyWord::kClear)
                     : set(BodyPart::kTrunk, BodyWord::kShoulder);
  }
  if (Has(text, "leg")) return set(BodyPart::kShank, BodyWord::kLeg);
  if (Has(text, "arm") && !Has(text, "armature") && !Has(text, "armor")) {
    set(BodyPart::kUpperArm, BodyWord::kArm);
  }
}

bool IsHelperWord(const std::string& word) {
  constexpr const char* kHelpers[] = {"ik",      "pole",     "target", "ctrl",
                                      "control", "effector", "goal",   "footsteps"};
  return std::find(std::begin(kHelpers), std::end(kHelpers), word) != std::end(kHelpers);
}

}  // namespace

std::vector<std::string> WordsOfName(const std::string& name) {
  std::vector<std::string> words(1);
  for (size_t i = 0; i < name.size(); ++i) {
    const bool is_hump =
        IsCapital(name[i]) && i > 0 && IsAlpha(name[i - 1]) && !IsCapital(name[i - 1]);
    const bool is_new = !IsAlpha(name[i]) || is_hump;
    if (is_new && !words.back().empty()) words.emplace_back();
    const auto c = static_cast<unsigned char>(name[i]);
    if (IsAlpha(name[i])) words.back() += static_cast<char>(std::tolower(c));
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

ReadName ReadBoneName(const std::string& bone) {
  const size_t space = bone.rfind(':');  // "mixamorig:Hips"
  const std::string name = space == std::string::npos ? bone : bone.substr(space + 1);
  std::vector<std::string> words = WordsOfName(name);
  ReadName read;
  read.body.side = TakeSide(name, &words);
  std::string text;
  for (const std::string& word : words) text += word;
  read.is_twist = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return Has(word, "twist") || Has(word, "roll");
  });
  read.is_helper = std::any_of(words.begin(), words.end(), IsHelperWord);
  ReadPart(text, &read);
  return read;
}

std::vector<std::string> WithoutPrefix(std::vector<std::string> names) {
  if (names.size() < 2) return names;
  std::string prefix = names[0];
  for (const std::string& name : names) {
    const auto ends = std::mismatch(prefix.begin(), prefix.end(), name.begin(), name.end());
    prefix.erase(ends.first, prefix.end());
  }
  const size_t separator = prefix.find_last_of("_:|. -");
  const size_t length = separator == std::string::npos ? 0 : separator + 1;
  const bool is_all_of_one = std::any_of(
      names.begin(), names.end(), [&](const std::string& name) { return name.size() == length; });
  const bool has_side = ReadBoneName(prefix.substr(0, length)).body.side != BodySide::kMiddle;
  if (is_all_of_one || has_side) return names;
  for (std::string& name : names) name.erase(0, length);
  return names;
}

BodyPart PartOf(BodyRole role) {
  switch (role) {
    case BodyRole::kHips:
      return BodyPart::kPelvis;
    case BodyRole::kSpine:
    case BodyRole::kClavicle:
      return BodyPart::kTrunk;
    case BodyRole::kNeck:
      return BodyPart::kNeck;
    case BodyRole::kHead:
      return BodyPart::kHead;
    case BodyRole::kUpperArm:
      return BodyPart::kUpperArm;
    case BodyRole::kForearm:
      return BodyPart::kForearm;
    case BodyRole::kHand:
    case BodyRole::kFinger:
      return BodyPart::kHand;
    case BodyRole::kThigh:
      return BodyPart::kThigh;
    case BodyRole::kShin:
      return BodyPart::kShank;
    case BodyRole::kFoot:
    case BodyRole::kToe:
      return BodyPart::kFoot;
    default:
      return BodyPart::kOther;
  }
}

double RadiusShareOf(const BodyName& body) {
  constexpr double kShares[kNumBodyParts] = {0.055, 0.06,  0.03,  0.055, 0.027, 0.022,
                                             0.012, 0.042, 0.029, 0.014, 0.012};
  constexpr double kGirdle = 0.035;  // collars and hip joints
  const bool is_girdle = (body.part == BodyPart::kPelvis || body.part == BodyPart::kTrunk) &&
                         body.side != BodySide::kMiddle;
  return is_girdle ? kGirdle : kShares[static_cast<int>(body.part)];
}

}  // namespace hazumi
