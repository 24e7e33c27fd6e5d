#include "engine/figure/side_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace hazumi {

namespace {

// Part of a name.
struct Word {
  size_t begin = 0, size = 0;
};

bool IsLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool IsUpper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool IsLower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }

// "lThigh" is l, Thigh; "LHipJoint" is L, Hip, Joint; "IKArmL" is IK, Arm, L.
bool BeginsWord(const std::string& name, size_t i) {
  if (i == 0 || !IsLetter(name[i - 1])) return true;
  if (!IsUpper(name[i])) return false;
  return !IsUpper(name[i - 1]) || (i + 1 < name.size() && IsLower(name[i + 1]));
}

std::vector<Word> WordsOf(const std::string& name) {
  std::vector<Word> words;
  for (size_t i = 0; i < name.size(); ++i) {
    if (!IsLetter(name[i])) continue;
    if (BeginsWord(name, i)) words.push_back({i, 0});
    ++words.back().size;
  }
  return words;
}

constexpr std::array<std::pair<const char*, const char*>, 5> kSides = {
    {{"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}, {"l", "r"}, {"L", "R"}}};

BodySide SideOfWord(const std::string& word) {
  for (const auto& [left, right] : kSides) {
    if (word == left) return BodySide::kLeft;
    if (word == right) return BodySide::kRight;
  }
  return BodySide::kMiddle;
}

std::string OtherWord(const std::string& word) {
  for (const auto& [left, right] : kSides) {
    if (word == left) return right;
    if (word == right) return left;
  }
  return word;
}

// The words that are a side, from the last one on, so that those before stay where they are when
// one is replaced.
std::vector<Word> SidesIn(const std::string& name) {
  std::vector<Word> sides;
  for (const Word& word : WordsOf(name)) {
    const BodySide side = SideOfWord(name.substr(word.begin, word.size));
    if (side != BodySide::kMiddle) sides.insert(sides.begin(), word);
  }
  return sides;
}

std::string WithOther(std::string name, const Word& word) {
  return name.replace(word.begin, word.size, OtherWord(name.substr(word.begin, word.size)));
}

// "leftfoot".
void AddLongBeginnings(const std::string& name, std::vector<std::string>* others) {
  for (const Word& word : WordsOf(name)) {
    for (const size_t size : {size_t{4}, size_t{5}}) {
      if (word.size <= size) continue;
      const Word beginning = {word.begin, size};
      const std::string other = WithOther(name, beginning);
      if (other != name) others->push_back(other);
    }
  }
}

}  // namespace

BodySide SideNamed(const std::string& name) {
  BodySide side = BodySide::kMiddle;
  for (const Word& word : SidesIn(name)) {
    const BodySide of_word = SideOfWord(name.substr(word.begin, word.size));
    if (side != BodySide::kMiddle && side != of_word) return BodySide::kMiddle;
    side = of_word;
  }
  return side;
}

std::vector<std::string> OtherSideNames(const std::string& name) {
  std::vector<std::string> others;
  const std::vector<Word> sides = SidesIn(name);
  std::string all = name;
  for (const Word& word : sides) all = WithOther(all, word);
  if (!sides.empty()) others.push_back(all);
  if (sides.size() > 1) {
    for (const Word& word : sides) others.push_back(WithOther(name, word));
  }
  AddLongBeginnings(name, &others);
  if (name.size() > 2 && IsLetter(name[1])) {
    const std::string other = WithOther(name, {0, 1});  // "lfemur"
    if (other != name && std::find(others.begin(), others.end(), other) == others.end()) {
      others.push_back(other);
    }
  }
  return others;
}

}  // namespace hazumi
