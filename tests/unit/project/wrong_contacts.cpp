// Contacts that cannot be, and those that do nothing.

#include <limits>

#include "tests/unit/project/wrong_makers.h"
#include "tests/unit/project/wrong_projects.h"

namespace hazumi::testing {

namespace {

// The arm touches the scene.
Changes Touching(const std::string& contacts, const Changes& more = {}) {
  Changes changes = {{"/solver/method", "\"exact\""},
                     {"/regions/0/method", "\"exact\""},
                     {"/regions/0/contacts", contacts}};
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}
const std::string kTouchesScene = R"({"scene": true})";

std::vector<WrongProject> WrongContactValues() {
  const std::string place = "regions[0].contacts";
  return {
      {Check::kWrongType, Read(Touching("true")),
       place + ": expected an object, found true or false"},
      {Check::kWrongType, Read(Touching(R"(["scene"])")),
       place + ": expected an object, found an array"},
      {Check::kWrongType, Read(Touching(R"({"scene": "floor"})")),
       place + ".scene: expected true or false, found a string"},
      {Check::kWrongType, Read(Touching(R"({"scene": true, "self": 1})")),
       place + ".self: expected true or false, found a number"},
      {Check::kUnknownField, Doubt("/regions/0/contacts", R"({"scen": true})"),
       place + ": unknown field \"scen\"; did you mean \"scene\"?"},
      {Check::kNumChecks, Compile(Touching(R"({"scene": true, "self": true})")), "no complaint"},
      {Check::kNumChecks, Compile(Touching(R"({"self": true})")), "no complaint"},
      {Check::kNumChecks, Compile({{"/regions/0/contacts", R"({"scene": false})"}}),
       "no complaint"},
  };
}

std::vector<WrongProject> WrongFrictionCoefficients() {
  const std::string place = "scene.objects[1].friction_coefficient";
  const std::string pointer = "/scene/objects/1/friction_coefficient";
  return {
      {Check::kNegative, Read(pointer, "-0.1"), place + ": must not be negative, is -0.1"},
      {Check::kWrongType, Read(pointer, "\"ice\""), place + ": expected a number, found a string"},
      {Check::kNumberTooLarge, Read(pointer, "1e10"),
       place + ": 1e+10 is too large: numbers lie between -1e9 and 1e9"},
      {Check::kNotFinite, Spoilt([](Project& p) {
         p.scene.objects[1].friction_coefficient = std::numeric_limits<double>::infinity();
       }),
       place + ": must be a finite number"},
      {Check::kUnknownField, Doubt("/scene/objects/1/friction", "0.3"),
       "scene.objects[1]: unknown field \"friction\"; did you mean \"friction_coefficient\"?"},
      {Check::kNumChecks, Compile({{pointer, "0"}}), "no complaint"},
  };
}

std::vector<WrongProject> ContactContradictions() {
  const auto in_paper = [](const std::string& name) {
    return "region \"" + name +
           "\" has contacts and method \"paper\", which knows no contacts; choose method \"exact\" "
           "for it, or let it touch nothing";
  };
  return {
      {Check::kContactInPaper, Compile({{"/regions/0/contacts", kTouchesScene}}),
       "regions[0].contacts: " + in_paper("arm")},
      // By the solver's method.
      {Check::kContactInPaper, Compile({{"/regions/1/contacts", kTouchesScene}}),
       "regions[1].contacts: " + in_paper("leg")},
      {Check::kContactInPaper, Compile({{"/regions/0/contacts", R"({"self": true})"}}),
       "regions[0].contacts: " + in_paper("arm")},
      {Check::kNumChecks,
       Compile({{"/regions/0/contacts", kTouchesScene}, {"/regions/0/mute", "true"}}),
       "no complaint"},
  };
}

// Of the ball and the brick that are held.
std::vector<WrongProject> WrongHeldContacts() {
  const std::string ball = "held_objects[0].", brick = "held_objects[1].";
  const std::string bounces =
      " (what is left of its speed as it bounces; 0: it does not bounce, 1: nothing is lost)";
  const std::string to_ball = "/held_objects/0/", exact = "\"exact\"";
  return {
      {Check::kRange, Read(to_ball + "restitution", "1.5"),
       ball + "restitution: must lie between 0 and 1, is 1.5" + bounces},
      {Check::kRange, Read(to_ball + "restitution", "-0.1"),
       ball + "restitution: must lie between 0 and 1, is -0.1" + bounces},
      {Check::kNegative, Read(to_ball + "friction_coefficient", "-0.1"),
       ball + "friction_coefficient: must not be negative, is -0.1"},
      {Check::kWrongType, Read(to_ball + "contacts", R"({"scene": true})"),
       ball + "contacts: expected true or false, found an object"},
      {Check::kNotFinite, Spoilt([](Project& p) {
         p.held_objects[0].restitution = std::numeric_limits<double>::quiet_NaN();
       }),
       ball + "restitution: must be a finite number"},
      {Check::kObjectContactInPaper, Compile({{to_ball + "contacts", "true"}}),
       ball + "contacts: \"ball\" touches the scene and the solver's method is \"paper\", which "
              "knows no contacts; choose method \"exact\" for the solver, or let it touch nothing"},
      {Check::kBoxWithContacts,
       Compile({{"/solver/method", exact}, {"/held_objects/1/contacts", "true"}}),
       brick + "contacts: \"brick\" is a box, and of what is let go only balls can touch the scene "
               "yet; make it a sphere, or let it touch nothing"},
  };
}

// Gravity places the figure in frames 15 to 30.
std::vector<WrongProject> ContactWarnings() {
  const auto tumble = [](const std::string& first, const std::string& last) {
    return Touching(kTouchesScene, {{"/regions/0/joints", R"(["root"])"},
                                    {"/regions/0/friction", R"({"default": 1})"},
                                    {"/regions/0/first_frame", first},
                                    {"/regions/0/last_frame", last},
                                    {"/placements/1/last_frame", first}});
  };
  const auto unpinned = [](const std::string& place, const std::string& joint,
                           const std::string& frames) {
    return "placements[0]." + place + ": \"" + joint + "\" is not pinned: in frames " + frames +
           " region \"arm\" moves the root and touches the scene, so that contact alone places the "
           "figure; leave the pin out, or the root out of the region";
  };
  return {
      {Check::kNothingToTouch, Warn(Touching(kTouchesScene, {{"/scene/objects", "[]"}})),
       "regions[0].contacts: region \"arm\" touches the scene, in which there is no plane or box; "
       "add one, or let it touch nothing"},
      {Check::kPinWhileTouching, Warn(tumble("15", "25")), unpinned("pin", "r_ankle", "15 to 25")},
      {Check::kPinWhileTouching, Warn(tumble("15", "30")),
       unpinned("landing_pin", "l_ankle", "15 to 30")},
  };
}

}  // namespace

std::vector<WrongProject> WrongContacts() {
  std::vector<WrongProject> all = WrongContactValues();
  for (const auto& list : {WrongFrictionCoefficients(), WrongHeldContacts(),
                           ContactContradictions(), ContactWarnings()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace hazumi::testing
