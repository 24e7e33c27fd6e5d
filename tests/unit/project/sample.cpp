#include "tests/unit/project/sample.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "engine/base/assert.h"
#include "engine/project/project_reader.h"

namespace hazumi::testing {

namespace {

constexpr const char* kSample = R"({
  "format": "hazumi-project", "version": 1, "name": "Sample",
  "fps": {"num": 30, "den": 1},
  "frames": {"first": 0, "last": 30},
  "solver": {"method": "paper", "step_s": 0.03333333333333333, "version": 1},
  "figure": {
    "format": "hazumi-figure", "version": 1, "name": "doll", "notes": ["a note"],
    "root": {
      "name": "pelvis",
      "links": [{"name": "pelvis", "from_m": [0, -0.1, 0], "to_m": [0, 0.1, 0], "radius_m": 0.1,
                 "mass_kg": 10, "com_m": [0, 0, 0.01],
                 "inertia_kg_m2": [0.05, 0.04, 0.05, 0, 0, 0]}]
    },
    "joints": [
      {"name": "waist", "parent": "pelvis", "offset_m": [0, 0, 0.1],
       "hinges": [{"axis": "y", "limits_deg": [-30, 60], "rest_deg": 0}],
       "links": [{"name": "chest", "from_m": [0, 0, 0], "to_m": [0, 0, 0.4], "radius_m": 0.1,
                  "density_kg_m3": 1000,
                  "look": [{"shape": "ellipsoid", "center_m": [0, 0, 0.2],
                            "half_axes_m": [0.1, 0.2, 0.3], "color": "#4f7d8c"}]}]},
      {"name": "r_shoulder", "parent": "waist", "offset_m": [0, -0.2, 0.4],
       "orientation_deg": [0, 0, 10],
       "hinges": [{"name": "flexion", "axis": [0, -1, 0], "limits_deg": [-70, 180]},
                  {"name": "twist", "axis": "z", "limits_deg": [0, 0]},
                  {"name": "abduction", "axis": "-x", "limits_deg": [-45, 180]}],
       "links": [{"name": "r_upper_arm", "from_m": [0, 0, 0], "to_m": [0, 0, -0.3],
                  "radius_m": 0.04, "mass_kg": 2,
                  "look": [{"shape": "tapered_capsule", "from_m": [0, 0, 0], "to_m": [0, 0, -0.3],
                            "radii_m": [0.05, 0.04], "color": "#c98f6b",
                            "mirror_color": "#b97f5b"}]}]},
      {"name": "r_elbow", "parent": "r_shoulder", "offset_m": [0, 0, -0.3],
       "hinges": [{"axis": "-y", "limits_deg": [0, 150]}],
       "links": [{"name": "r_forearm", "from_m": [0, 0, 0], "to_m": [0, 0, -0.25],
                  "radius_m": 0.03, "mass_kg": 1.5}]},
      {"name": "r_wrist", "parent": "r_elbow", "offset_m": [0, 0, -0.25],
       "hinges": [{"name": "flexion", "axis": "x", "limits_deg": [-70, 80]},
                  {"name": "deviation", "axis": "-y", "limits_deg": [-30, 20]}],
       "links": [{"name": "r_hand", "from_m": [0, 0, 0], "to_m": [0, 0, -0.1],
                  "radius_m": 0.03, "mass_kg": 0.4}]},
      {"name": "r_hip", "parent": "pelvis", "offset_m": [0, -0.1, 0],
       "hinges": [{"name": "flexion", "axis": "-y", "limits_deg": [-15, 125]},
                  {"name": "abduction", "axis": "-x", "limits_deg": [-45, 45]}],
       "links": [{"name": "r_thigh", "from_m": [0, 0, 0], "to_m": [0, 0, -0.4],
                  "radius_m": 0.06, "mass_kg": 9}]},
      {"name": "r_knee", "parent": "r_hip", "offset_m": [0, 0, -0.4],
       "hinges": [{"axis": "y", "limits_deg": [0, 150]}],
       "links": [{"name": "r_shank", "from_m": [0, 0, 0], "to_m": [0, 0, -0.4],
                  "radius_m": 0.05, "mass_kg": 3}]},
      {"name": "r_ankle", "parent": "r_knee", "offset_m": [0, 0, -0.4],
       "hinges": [{"axis": "-y", "limits_deg": [-50, 20]}],
       "links": [{"name": "r_foot", "from_m": [0, 0, 0], "to_m": [0.15, 0, 0],
                  "radius_m": 0.03, "mass_kg": 1}]}
    ],
    "mirror": {"from": "r_", "to": "l_"}
  },
  "scene": {
    "gravity_m_s2": 9.8,
    "objects": [
      {"name": "ground", "plane": {"normal": [0, 0, 1], "offset_m": 0}, "color": "#808080"},
      {"name": "platform", "box": {"center_m": [0, 0, 0.1], "size_m": [1, 1, 0.2],
                                   "rotation_deg": [90, 0, 0]}, "color": "#aabbcc"}
    ]
  },
  "root": {
    "z": {"keys": [{"frame": 0, "position_m": 0.9, "rate_m_s": 0.1}]},
    "angle_z": {"keys": [{"frame": 0, "angle_deg": 90}]}
  },
  "joints": {
    "r_knee": {"keys": [
      {"frame": 0, "angle_deg": 12, "rate_deg_s": 30, "interpolation": "linear"},
      {"frame": 2.5, "angle_deg": 20.25},
      {"frame": 30, "angle_deg": 40, "type": "extreme"}]},
    "r_shoulder_flexion": {"keys": [{"frame": 0, "angle_deg": 45}]}
  },
  "size_is_guessed": true,
  "source": {"file": "walk.glb", "character": "rig", "clip": "walk", "above": "Rig/root", "fps": 30, "z_up": true,
             "metres_per_unit": 0.01, "reduce_deg": 1, "file_hinges": true,
             "file_facing": true},
  "regions": [
    {"name": "arm", "first_frame": 5, "last_frame": 15,
     "joints": ["r_wrist", "r_elbow", {"beyond": "l_shoulder"}],
     "friction": {"default": 0.8, "joints": {"r_wrist_flexion": 0.3, "r_wrist": 0.4}},
     "method": "paper", "step_s": 0.01, "tolerance_deg": 0.5,
     "limit_tangents": true, "blend_frames": 3},
    {"name": "leg", "first_frame": 15, "last_frame": 20, "joints": ["r_knee"],
     "friction": {"default": 1}}
  ],
  "placements": [
    {"kind": "gravity", "pin": "r_ankle", "landing_pin": "l_ankle", "first_frame": 15,
     "last_frame": 30},
    {"kind": "pinned", "joint": "l_ankle", "first_frame": 5, "last_frame": 15},
    {"kind": "keyed", "first_frame": 0, "last_frame": 5}
  ],
  "holds": [{"joint": "r_ankle", "orientation": true, "first_frame": 0, "last_frame": 5}],
  "held_objects": [
    {"name": "ball", "sphere": {"radius_m": 0.037}, "mass_kg": 0.145, "joint": "r_wrist_flexion",
     "offset_m": [0, 0, -0.09], "release_frame": 9, "color": "#d9482b"},
    {"name": "brick", "box": {"size_m": [0.2, 0.1, 0.05]}, "mass_kg": 2, "joint": "l_wrist"}
  ],
  "camera": {"eye_m": [0, -3, 1], "target_m": [0, 0, 1], "vertical_fov_deg": 35},
  "audio": {"file": "voice.wav", "start_frame": -4, "gain_db": -6.5, "mute": true},
  "reference": {"file": "take.mp4", "start_frame": 3, "view": "plane", "center_m": [1, 2, 0.8],
                "turn_deg": 30, "height_m": 1.5, "opacity": 0.7, "mute": true, "rendered": true},
  "markers": [{"frame": 9, "name": "throw"}, {"frame": -3, "name": "before"}],
  "preview": {"first": 5, "last": 15},
  "selection_sets": [{"name": "arm", "joints": ["r_elbow", {"beyond": "l_shoulder"}]},
                     {"name": "root", "joints": ["pelvis"]}],
  "fills": [{"name": "arm", "first_frame": 0, "last_frame": 10, "joints": ["r_elbow"],
             "relative_to": "body", "ends": "free", "snap": -0.5, "tolerance_deg": 0.2},
            {"name": "legs", "first_frame": 2, "last_frame": 8, "joints": [{"beyond": "l_hip"}, "pelvis"]}],
  "goals": [{"name": "meet", "kind": "pose", "frame": 7, "joints": ["r_elbow", {"beyond": "l_shoulder"}],
             "tolerance_deg": 0.5, "rests": true},
            {"name": "button", "kind": "point", "frame": 8, "joint": "r_wrist", "offset_m": [0, 0, -0.1],
             "position_m": [0.4, -0.2, 1.2], "tolerance_m": 0.01},
            {"name": "basket", "kind": "object", "frame": 6, "object": "ball", "style": "overarm",
             "height_m": 0.7, "position_m": [3, 0.2, 0.04], "tolerance_m": 0.02}]
})";

}  // namespace

Json SampleProject() { return Json::parse(kSample); }

Json Changed(Json document, const Changes& changes) {
  for (const auto& [pointer_text, value] : changes) {
    const Json::json_pointer pointer(pointer_text);
    if (value.empty()) {
      document[pointer.parent_pointer()].erase(pointer.back());
    } else {
      document[pointer] = Json::parse(value);
    }
  }
  return document;
}

Project ParseGood(const Json& document) {
  Result<Project> project = ParseProject(document.dump(), "sample.kfa");
  if (!project.ok()) std::fprintf(stderr, "%s\n", project.error().ToString().c_str());
  return std::move(project).value();
}

std::string ReadFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void WriteFile(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace hazumi::testing
