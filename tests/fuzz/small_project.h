#pragma once

namespace hazumi::fuzz {

// A body with a leg of two joints and an arm of one, keys, a region, a placement and a hold.
inline constexpr const char* kSmallProject = R"({
"format":"hazumi-project","version":1,"name":"Small",
"fps":{"num":30,"den":1},"frames":{"first":0,"last":8},
"solver":{"method":"exact","version":1},
"figure":{"format":"hazumi-figure","version":1,"name":"small",
"root":{"name":"body","links":[{"name":"body","from_m":[0,0,0],"to_m":[0,0,0.3],"radius_m":0.1,"mass_kg":9}]},
"joints":[
{"name":"r_hip","parent":"body","offset_m":[0,-0.1,0],"hinges":[{"name":"swing","axis":"y","limits_deg":[-90,90]},{"name":"out","axis":"x","limits_deg":[-40,40]}],
"links":[{"name":"r_thigh","from_m":[0,0,0],"to_m":[0,0,-0.4],"radius_m":0.05,"mass_kg":3}]},
{"name":"r_knee","parent":"r_hip","offset_m":[0,0,-0.4],"hinges":[{"axis":"y","limits_deg":[0,150]}],
"links":[{"name":"r_shank","from_m":[0,0,0],"to_m":[0,0,-0.4],"radius_m":0.04,"mass_kg":2}]},
{"name":"r_ankle","parent":"r_knee","offset_m":[0,0,-0.4],"hinges":[{"axis":"y","limits_deg":[-40,40]}],
"links":[{"name":"r_foot","from_m":[0,0,0],"to_m":[0.1,0,0],"radius_m":0.03,"mass_kg":1}]}]},
"scene":{"gravity_m_s2":9.81,"objects":[{"name":"floor","plane":{"normal":[0,0,1],"offset_m":0}},
{"name":"box","box":{"center_m":[1,0,0.1],"size_m":[0.5,1,0.2]}}]},
"root":{"z":{"keys":[{"frame":0,"position_m":0.85}]}},
"joints":{"r_knee":{"keys":[{"frame":0,"angle_deg":5},{"frame":4,"angle_deg":30},{"frame":8,"angle_deg":10}]},
"r_hip_swing":{"keys":[{"frame":0,"angle_deg":0},{"frame":8,"angle_deg":20,"interpolation":"linear"}]}},
"regions":[{"name":"leg","first_frame":2,"last_frame":6,"joints":["r_knee"],"friction":{"default":0.8}}],
"markers":[{"frame":3,"name":"here"}]})";

}  // namespace hazumi::fuzz
