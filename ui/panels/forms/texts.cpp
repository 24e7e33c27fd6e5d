#include "ui/panels/forms/texts.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace hazumi::ui {

namespace {

struct Label {
  const char* name;
  const char* label;
};

// Where the name alone, with a capital, would not say it.
constexpr Label kLabels[] = {{"first", "First frame"},
                             {"last", "Last frame"},
                             {"to_first", "New first frame"},
                             {"to_last", "New last frame"},
                             {"to", "To"},
                             {"by", "Change by"},
                             {"auto_rate", "Automatic rate"},
                             {"within_limits", "Within limits"},
                             {"chain", "Joints that turn"},
                             {"index", "Which"},
                             {"lower", "Lower limit"},
                             {"upper", "Upper limit"},
                             {"add", "Add to selection"},
                             {"never", "Never let go"},
                             {"off", "Play all"},
                             {"about", "About frame"},
                             {"subframe", "Between frames"},
                             {"path", "File"},
                             {"dark", "Dark"},
                             {"feet_stay", "Feet stay"},
                             {"keep_shape", "Keep shape"},
                             {"drag", "Drag"}};

struct Row {
  const char* id;  // empty: any
  const char* first_name;
  const char* label;
};

constexpr Row kRows[] = {{"root.turn", "x", "Axis"}, {"object.move", "x", "Move by"},
                         {"", "first", "Frames"},    {"", "to_first", "New frames"},
                         {"", "num", "Frames"},      {"", "x", "Position"},
                         {"", "lower", "Limits"}};

struct Meaning {
  const char* id;
  const char* word;
  const char* text;
};

constexpr Meaning kMeanings[] = {
    {"placement.set", "pinned",
     "One joint, such as a toe, stays where it is; the figure turns about it."},
    {"placement.set", "gravity", "The figure falls or flies, lands and stands by itself."},
    {"hold.add", "limb", "The limb alone: an arm, a leg."},
    {"hold.add", "body", "All joints up to the root, so that the back helps to reach."},
    {"region.add", "friction", "Speed that is left after 1/30 s: 0 frozen, 1 no friction"},
    {"placement.set", "keyed", "The keys of the root say where the figure is."}};

constexpr Row kMain[] = {
    {"region.add", "joints", ""},
    {"hold.add", "limb", "The limb alone: an arm, a leg."},
    {"hold.add", "body", "All joints up to the root, so that the back helps to reach."},
    {"region.add", "friction", ""},
    {"placement.set", "pin", ""},
    {"placement.set", "landing_pin", ""},
    {"key.set", "value", ""},
    {"key.set", "interpolation", ""},
    {"key.move", "to", ""},
    {"key.move", "by", ""},
    {"pose.rotate", "to", ""},
    {"pose.rotate", "by", ""},
    {"region.friction", "joint", ""},
    {"region.friction", "factor", ""},
    {"object.add_box", "x", ""},
    {"object.add_box", "y", ""},
    {"object.add_box", "z", ""},
    {"object.add_box", "size_x", ""},
    {"object.add_box", "size_y", ""},
    {"object.add_box", "size_z", ""},
    {"time.rate", "den", ""},
    {"figure.joint_limits", "lower", ""},
    {"figure.joint_limits", "upper", ""}};

}  // namespace

std::string LabelOf(const edit::ParameterInfo& info) {
  if (info.label[0] != '\0') return info.label;
  std::string name = info.name;
  for (const Label& label : kLabels) {
    if (name == label.name) return label.label;
  }
  std::replace(name.begin(), name.end(), '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  if (name.size() > 2 && name[name.size() - 2] == ' ') {
    name.back() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.back())));
  }
  return name;
}

std::string LabelOfRow(const std::string& id, const std::string& first_name) {
  for (const Row& row : kRows) {
    const bool is_meant = row.id[0] == '\0' || id == row.id;
    if (is_meant && first_name == row.first_name) return row.label;
  }
  return "";
}

std::vector<std::string> NamesInRow(const std::string& first_name) {
  if (first_name == "first") return {"first", "last"};
  if (first_name == "to_first") return {"to_first", "to_last"};
  if (first_name == "num") return {"num", "den"};
  if (first_name == "lower") return {"lower", "upper"};
  if (!first_name.ends_with('x')) return {first_name};
  const std::string stem = first_name.substr(0, first_name.size() - 1);
  return {stem + 'x', stem + 'y', stem + 'z'};
}

std::string MeaningOf(const std::string& id, const std::string& word) {
  for (const Meaning& meaning : kMeanings) {
    if (id == meaning.id && word == meaning.word) return meaning.text;
  }
  return "";
}

std::vector<std::string> AllFormTexts() {
  std::vector<std::string> texts;
  for (const Label& label : kLabels) texts.push_back(label.label);
  for (const Row& row : kRows) texts.push_back(row.label);
  for (const Meaning& meaning : kMeanings) texts.push_back(meaning.text);
  return texts;
}

bool IsMain(const std::string& id, const std::string& name) {
  return std::any_of(std::begin(kMain), std::end(kMain),
                     [&](const Row& row) { return id == row.id && name == row.first_name; });
}

}  // namespace hazumi::ui
