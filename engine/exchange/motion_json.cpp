#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "engine/analysis/effort.h"
#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"
#include "engine/exchange/motion_text.h"
#include "engine/exchange/units.h"
#include "engine/placement/contact.h"

namespace hazumi {

namespace {

std::string Quote(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// "[a, b, ...]" of what `text_of` makes of each item.
template <typename Items, typename TextOf>
std::string List(const Items& items, TextOf text_of) {
  std::string text = "[";
  for (const auto& item : items) {
    if (text.size() > 1) text += ", ";
    text += text_of(item);
  }
  return text + "]";
}

// The same with each item on a line of its own.
template <typename Items, typename TextOf>
std::string Lines(const Items& items, TextOf text_of) {
  if (items.empty()) return "[]";
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "[\n    " : ",\n    ") + text_of(item);
  return text + "\n  ]";
}

template <typename Vector>
std::string Numbers(const Vector& values) {
  return List(values, FormatNumber);
}

// JSON has no infinite numbers.
std::string NumberOrNull(double value) {
  return std::isfinite(value) ? FormatNumber(value) : "null";
}

std::string InDegrees(const VecX& radians) {
  return List(radians, [](double x) { return FormatNumber(Degrees(x)); });
}

std::string QuaternionText(const Eigen::Quaterniond& q) {
  return Numbers(std::array{q.w(), q.x(), q.y(), q.z()});
}

std::string TorqueText(const FrameEffort& torques) {
  const Wrench& root = torques.from_nowhere;
  return ", \"torques_n_m\": " + Numbers(torques.tau) +
         ", \"unsupported\": {\"force_n\": " + Numbers(root.force) +
         ", \"moment_n_m\": " + Numbers(root.moment) + "}";
}

std::string WrenchText(const Wrench& wrench) {
  return "{\"force_n\": " + Numbers(wrench.force) + ", \"moment_n_m\": " + Numbers(wrench.moment) +
         "}";
}

std::string EffortText(const Figure& figure, const FrameEffort& effort) {
  const auto contact = [&](const EffortContact& from) {
    const std::string name =
        from.joint.is_valid() ? figure.joint(from.joint).name : figure.root_name();
    return "{\"joint\": " + Quote(name) + ", \"grip\": " + (from.is_grip ? "true" : "false") +
           ", \"position_m\": " + Numbers(from.p) + ", \"force_n\": " + Numbers(from.force) + "}";
  };
  const auto share = [](double x) { return x < 0.0 ? "null" : FormatNumber(x); };
  const auto name = [&](JointIndex j) { return Quote(figure.joint(j).name); };
  return ", \"effort\": {\"torques_n_m\": " + Numbers(effort.tau) +
         ", \"share\": " + List(effort.share, share) +
         ", \"least_strength\": " + List(effort.least, name) +
         ", \"contacts\": " + List(effort.contacts, contact) +
         ", \"from_nowhere\": " + WrenchText(effort.from_nowhere) + "}";
}

// Writes the frames of one motion in order.
class FrameWriter {
 public:
  explicit FrameWriter(const Animation& animation)
      : animation_(animation), figure_(*animation.figure), ws_(figure_) {}

  // `torques` and `effort` may be null.
  std::string Write(const MotionFrame& frame, const FrameEffort* torques,
                    const FrameEffort* effort) {
    ComputePositions(figure_, frame.X_WR, frame.q, &ws_);
    turn_ = NearQuaternion(frame.X_WR.R, turn_);
    std::string text = "{\"frame\": " + std::to_string(frame.frame);
    text += ", \"angles_deg\": " + InDegrees(frame.q);
    text += ", \"rates_deg_s\": " + InDegrees(frame.after.qd);
    text += ", \"root\": {\"position\": " + Numbers(frame.X_WR.p);
    text += ", \"quaternion_wxyz\": " + QuaternionText(turn_) + "}";
    text += ", \"com\": " + Numbers(frame.com);
    text += ", \"pinned\": " + (frame.pinned ? Quote(figure_.group(*frame.pinned).name) : "null");
    text += ", \"joint_positions_m\": " + JointPositions();
    text += ", \"clearance_m\": " + Clearance();
    text += ", \"free\": " + FreeJoints(frame);
    if (torques) text += TorqueText(*torques);
    if (effort) text += EffortText(figure_, *effort);
    text += ConstraintForces(frame) + Contacts(frame);
    return text + ", \"objects\": " + Objects(frame) + "}";
  }

 private:
  std::string JointPositions() {
    return List(figure_.groups(), [this](const JointGroup& group) {
      const std::string p = Numbers(ws_.body(group.first).p);
      std::string text = p;
      for (int i = 1; i < group.size; ++i) text += ", " + p;
      return text;
    });
  }

  std::string Clearance() {
    const auto contact = NearestContact(figure_, animation_.scene, ws_);
    return contact ? FormatNumber(contact->clearance) : "null";
  }

  std::string FreeJoints(const MotionFrame& frame) {
    std::vector<std::string> names;
    for (int j = 0; j < figure_.num_joints(); ++j) {
      if (frame.in_region[j]) names.push_back(figure_.joints()[j].name);
    }
    return List(names, Quote);
  }

  // Of an animation that has constraints.
  std::string ConstraintForces(const MotionFrame& frame) {
    if (animation_.constraints.empty()) return "";
    return ", \"constraint_forces_n\": " + List(frame.constraint_forces, FormatNumber);
  }

  // Of an animation that has regions with contacts.
  std::string Contacts(const MotionFrame& frame) {
    const auto& regions = animation_.regions;
    const auto touches = [](const DynamicsRegion& region) {
      return region.touches_scene || region.touches_self;
    };
    if (std::none_of(regions.begin(), regions.end(), touches)) return "";
    const auto link_name = [&](int i) { return i < 0 ? "null" : Quote(figure_.links()[i].name); };
    const auto contact = [&](const ContactPush& push) {
      const std::string object =
          push.object < 0 ? "null" : Quote(animation_.scene[push.object].name);
      std::string by;
      if (push.by_link >= 0) by = ", \"by_link\": " + link_name(push.by_link);
      if (push.by_ball >= 0) {
        by = ", \"by_held_object\": " + Quote(animation_.held_objects[push.by_ball].name);
      }
      return "{\"link\": " + link_name(push.link) + ", \"object\": " + object + by +
             ", \"position_m\": " + Numbers(push.p) + ", \"force_n\": " + Numbers(push.force) + "}";
    };
    return ", \"contacts\": " + List(frame.contacts.pushes, contact);
  }

  std::string Objects(const MotionFrame& frame) {
    std::string text = "[";
    for (size_t i = 0; i < frame.objects.size(); ++i) {
      const ObjectPose& object = frame.objects[i];
      text +=
          (i ? ", {" : "{") + std::string("\"name\": ") + Quote(animation_.held_objects[i].name);
      text += ", \"position\": " + Numbers(object.X_WO.p);
      text += ", \"quaternion_wxyz\": " + QuaternionText(Eigen::Quaterniond(object.X_WO.R));
      text += std::string(", \"held\": ") + (object.is_held() ? "true" : "false") + "}";
    }
    return text + "]";
  }

  const Animation& animation_;
  const Figure& figure_;
  DynamicsWorkspace ws_;
  Eigen::Quaterniond turn_ = Eigen::Quaterniond::Identity();
};

std::string EventText(const MotionEvent& event) {
  return "{\"kind\": " + Quote(NameOf(event.kind)) + ", \"frame\": " + std::to_string(event.frame) +
         ", \"time_s\": " + FormatNumber(event.time) +
         ", \"joint\": " + (event.joint.empty() ? "null" : Quote(event.joint)) +
         (event.kind == EventKind::kTouchDown
              ? ", \"link\": " + Quote(event.link) + ", \"on\": " + Quote(event.on)
              : "") +
         (event.count == 1 ? ""
                           : ", \"count\": " + std::to_string(event.count) +
                                 ", \"last_time_s\": " + FormatNumber(event.last_time)) +
         "}";
}

// What the motion is as fine as: the field that the method heeds.
std::string FinenessText(Method method, double step, double tolerance) {
  std::string text = "\"method\": " + Quote(NameOf(method));
  if (method == Method::kPaper) return text + ", \"step_s\": " + FormatNumber(step);
  return text + ", \"tolerance_deg\": " + FormatNumber(StatedDegrees(tolerance));
}

std::string ModelText(const RegionReport& region) {
  return ", \"groups\": " + List(region.islands, [](int size) { return std::to_string(size); }) +
         ", \"bodies\": " + std::to_string(region.bodies) +
         ", \"error_estimate_deg\": " + NumberOrNull(Degrees(region.error_estimate)) +
         (region.estimated_until
              ? ", \"estimated_until_frame\": " + FormatNumber(*region.estimated_until)
              : "") +
         (region.branches_from ? ", \"branches_from_frame\": " + FormatNumber(*region.branches_from)
                               : "");
}

std::string EnergyText(const EnergyBalance& energy) {
  std::string text;
  for (const auto& [name, joules] : TermsOf(energy)) {
    text += (text.empty() ? "" : ", ") + Quote(name) + ": " + NumberOrNull(joules);
  }
  return ", \"energy_j\": {" + text + "}";
}

std::string RegionText(const RegionReport& region, bool timings) {
  std::string text = "{\"name\": " + Quote(region.name);
  text += ", " + FinenessText(region.method, region.step, region.tolerance);
  text += ", \"steps\": " + std::to_string(region.steps);
  text += ", \"evaluations\": " + std::to_string(region.evaluations);
  text += ", \"solves\": " + std::to_string(region.solves);
  if (timings) text += ", \"microseconds\": " + FormatNumber(region.microseconds);
  text += ", \"free_joints\": " + std::to_string(region.free_joints);
  text += ", \"all_joints\": " + std::to_string(region.all_joints);
  if (region.method == Method::kExact) text += ModelText(region);
  if (region.energy) text += EnergyText(*region.energy);
  return text + "}";
}

std::string WarningText(const Warning& warning) {
  return "{\"place\": " + Quote(warning.place) + ", \"message\": " + Quote(warning.message) + "}";
}

std::string JumpText(const PlacementJump& jump) {
  return "{\"placement\": " + std::to_string(jump.placement) +
         ", \"frame\": " + std::to_string(jump.frame) +
         ", \"speed_m_s\": " + FormatNumber(jump.speed) +
         ", \"distance_m\": " + FormatNumber(jump.distance) +
         ", \"seconds\": " + FormatNumber(jump.seconds) + "}";
}

}  // namespace

double StatedDegrees(double radians) {
  constexpr int kDigits = 12;
  char text[32];
  const auto end = std::to_chars(std::begin(text), std::end(text), Degrees(radians),
                                 std::chars_format::general, kDigits)
                       .ptr;
  double degrees = 0.0;
  std::from_chars(text, end, degrees);
  return degrees;
}

std::vector<std::pair<std::string, double>> TermsOf(const EnergyBalance& energy) {
  std::vector<std::pair<std::string, double>> terms = {{"kinetic_start", energy.kinetic_start},
                                                       {"kinetic_end", energy.kinetic_end},
                                                       {"potential_start", energy.potential_start},
                                                       {"potential_end", energy.potential_end}};
  for (const EnergyBalance::Work& work : energy.laws) terms.emplace_back(work.law, work.joules);
  terms.emplace_back("stops", energy.limits);
  terms.emplace_back("impacts", energy.impacts);
  terms.emplace_back("keyed", energy.keyed);
  terms.emplace_back("residual", energy.residual());
  return terms;
}

std::string MotionToJson(const Animation& animation, const Motion& motion,
                         const MotionJsonOptions& options) {
  const SolverSettings& solver = animation.solver;
  std::string text = "{\n  \"format\": \"hazumi-motion\", \"version\": 1,\n";
  text += "  \"fps\": " + FormatNumber(motion.rate.frames_per_second()) +
          ", \"fps_num\": " + std::to_string(motion.rate.num) +
          ", \"fps_den\": " + std::to_string(motion.rate.den);
  text += ",\n  \"solver\": {" + FinenessText(solver.method, solver.step, solver.tolerance) +
          ", \"version\": " + std::to_string(solver.version) + "}";
  if (!options.made_by.program.empty()) {
    text += ",\n  \"made_by\": {\"program\": " + Quote(options.made_by.program) +
            ", \"options\": " + List(options.made_by.options, Quote) + "}";
  }
  text += ",\n  \"joints\": " +
          List(animation.figure->joints(), [](const Joint& joint) { return Quote(joint.name); });
  text += ",\n  \"joint_groups\": " + List(animation.figure->joints(), [&](const Joint& joint) {
            return Quote(animation.figure->group(joint.group).name);
          });
  FrameWriter writer(animation);
  Effort effort;
  if (options.torques || options.effort) effort = EffortOf(animation, motion);
  if (options.effort) {
    text += ",\n  \"effort\": {\"filtered_hz\": " +
            (effort.is_filtered ? FormatNumber(effort.cutoff) : "null") +
            ", \"friction\": " + FormatNumber(kGroundFriction) + "}";
  }
  size_t written = 0;
  text += ",\n  \"frames\": " + Lines(motion.frames, [&](const MotionFrame& frame) {
            const size_t i = written++;
            const FrameEffort* asked = effort.frames.empty() ? nullptr : &effort.frames[i];
            return writer.Write(frame, options.torques ? asked : nullptr,
                                options.effort ? asked : nullptr);
          });
  text += ",\n  \"events\": " + Lines(motion.events, EventText);
  text += ",\n  \"regions\": " + Lines(motion.regions, [&](const RegionReport& region) {
            return RegionText(region, options.timings);
          });
  text += ",\n  \"warnings\": " + Lines(motion.warnings, WarningText);
  if (!motion.placement_jumps.empty()) {
    text += ",\n  \"placement_jumps\": " + Lines(motion.placement_jumps, JumpText);
  }
  if (!motion.seams.empty()) {
    text += ",\n  \"seams\": " +
            Lines(motion.seams, [&](const Seam& seam) { return SeamToJson(animation, seam); });
  }
  return text + "\n}\n";
}

}  // namespace hazumi
