#include "tests/unit/exchange/small_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "engine/base/base64.h"
#include "engine/exchange/read_character.h"
#include "tests/support/temporary_folder.h"

namespace hazumi::test {
namespace {

constexpr const char* kFbxBefore = R"(; FBX 7.3.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7300
}
GlobalSettings:  {
	Version: 1000
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",2
		P: "UpAxisSign", "int", "Integer", "",1
		P: "FrontAxis", "int", "Integer", "",1
		P: "FrontAxisSign", "int", "Integer", "",-1
		P: "CoordAxis", "int", "Integer", "",0
		P: "CoordAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",100
		P: "TimeMode", "enum", "", "",6
	}
}
Objects:  {
	Model: 1000, "Model::Hips", "LimbNode" {
		Version: 232
		Properties70:  {
			P: "PreRotation", "Vector3D", "Vector", "",0,0,90
			P: "RotationActive", "bool", "", "",1
)";
constexpr const char* kFbxAfter =
    R"(			P: "Lcl Translation", "Lcl Translation", "", "A",0,0,1
			P: "Lcl Rotation", "Lcl Rotation", "", "A",10,0,0
		}
	}
	Model: 1001, "Model::SpineTip", "LimbNode" {
		Version: 232
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",0.5,0,0
		}
	}
	AnimationStack: 2000, "AnimStack::Take1", "" {
		Properties70:  {
			P: "LocalStart", "KTime", "Time", "",0
			P: "LocalStop", "KTime", "Time", "",46186158000
		}
	}
	AnimationLayer: 2001, "AnimLayer::Base", "" {
	}
	AnimationCurveNode: 2002, "AnimCurveNode::R", "" {
		Properties70:  {
			P: "d|X", "Number", "", "A",10
			P: "d|Y", "Number", "", "A",0
			P: "d|Z", "Number", "", "A",0
		}
	}
	AnimationCurve: 2003, "AnimCurve::", "" {
		Default: 10
		KeyVer: 4008
		KeyTime: *2 {
			a: 0,46186158000
		}
		KeyValueFloat: *2 {
			a: 10,70
		}
		KeyAttrFlags: *1 {
			a: 24836
		}
		KeyAttrDataFloat: *4 {
			a: 0,0,0,0
		}
		KeyAttrRefCount: *1 {
			a: 2
		}
	}
}
Connections:  {
	C: "OO",1000,0
	C: "OO",1001,1000
	C: "OO",2001,2000
	C: "OO",2002,2001
	C: "OP",2002,1000, "Lcl Rotation"
	C: "OP",2003,2002, "d|X"
}
)";
constexpr const char* kCollada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_visual_scenes><visual_scene id="S" name="S"><node id="Hips" name="Hips" sid="Hips" type="JOINT"><matrix sid="transform">1 0 0 0 0 1 0 0 0 0 1 100 0 0 0 1</matrix><node id="SpineTip" name="SpineTip" type="JOINT"><matrix sid="transform">1 0 0 0 0 1 0 0 0 0 1 50 0 0 0 1</matrix></node></node></visual_scene></library_visual_scenes>
<library_animations><animation id="a"><source id="i"><float_array id="ia" count="2">0 1</float_array><technique_common><accessor source="#ia" count="2" stride="1"><param name="TIME" type="float"/></accessor></technique_common></source>
<source id="o"><float_array id="oa" count="32">1 0 0 0 0 1 0 0 0 0 1 100 0 0 0 1 0 -1 0 0 1 0 0 0 0 0 1 100 0 0 0 1</float_array><technique_common><accessor source="#oa" count="2" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor></technique_common></source>
<sampler id="s"><input semantic="INPUT" source="#i"/><input semantic="OUTPUT" source="#o"/></sampler><channel source="#s" target="Hips/transform"/></animation></library_animations>
<scene><instance_visual_scene url="#S"/></scene></COLLADA>
)";

using Json = nlohmann::json;

// The buffer of a glTF file, an accessor at a time.
class Buffer {
 public:
  explicit Buffer(Json* document) : document_(*document) {}

  template <typename T>
  size_t Add(const std::vector<T>& values, size_t components, int component_type) {
    static const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    const size_t length = values.size() * sizeof(T);
    document_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", length}});
    bytes_.append(reinterpret_cast<const char*>(values.data()), length);
    document_["accessors"].push_back({{"bufferView", document_["bufferViews"].size() - 1},
                                      {"componentType", component_type},
                                      {"count", values.size() / components},
                                      {"type", components == 16 ? "MAT4" : kTypes[components]}});
    return document_["accessors"].size() - 1;
  }
  size_t Floats(const std::vector<float>& values, size_t components) {
    return Add(values, components, 5126);
  }
  void Close() {
    document_["buffers"] = {{{"byteLength", bytes_.size()},
                             {"uri", "data:application/octet-stream;base64," + ToBase64(bytes_)}}};
  }

 private:
  Json& document_;
  std::string bytes_;
};

template <typename T>
size_t AddWeights(Buffer* buffer, const std::vector<double>& weights, double one, int type) {
  std::vector<T> values;
  for (const double weight : weights) values.push_back(static_cast<T>(weight * one));
  return buffer->Add(values, 4, type);
}

// A quaternion xyzw for each time, about z from 0 to 90 degrees.
std::vector<float> Turns(size_t count) {
  std::vector<float> turns;
  for (size_t i = 0; i < count; ++i) {
    const double half = 0.25 * std::numbers::pi * static_cast<double>(i) / (count - 1.0);
    for (const double part : {0.0, 0.0, std::sin(half), std::cos(half)})
      turns.push_back(static_cast<float>(part));
  }
  return turns;
}

// `weight_bytes`: 0 for floats.
Json MakeGltf(const std::vector<double>& weights, size_t weight_bytes,
              const std::vector<float>& key_times = {0.0f, 0.5f}) {
  Json document = {{"asset", {{"version", "2.0"}}},
                   {"scene", 0},
                   {"scenes", {{{"nodes", {0, 1}}}}},
                   {"nodes",
                    {{{"name", "strip"}, {"mesh", 0}, {"skin", 0}},
                     {{"name", "lower"}, {"children", {2}}},
                     {{"name", "upper"}, {"translation", {0, 1, 0}}}}}};
  Buffer buffer(&document);
  const size_t positions = buffer.Floats({0, 0, 0, 1, 0, 0, 0, 2, 0, 1, 2, 0}, 3);
  const size_t indices = buffer.Add<uint16_t>({0, 1, 2, 1, 3, 2}, 1, 5123);
  const size_t joints =
      buffer.Add<uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 4, 5121);
  const size_t of_vertices = weight_bytes == 0 ? AddWeights<float>(&buffer, weights, 1.0, 5126)
                             : weight_bytes == 1
                                 ? AddWeights<uint8_t>(&buffer, weights, 255.0, 5121)
                                 : AddWeights<uint16_t>(&buffer, weights, 65535.0, 5123);
  // Columns first; "upper" is a unit above "lower".
  const size_t binds = buffer.Floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1},
                                     16);
  const size_t times = buffer.Floats(key_times, 1);
  const size_t turns = buffer.Floats(Turns(key_times.size()), 4);
  buffer.Close();
  document["meshes"] = {
      {{"primitives",
        {{{"attributes",
           {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", of_vertices}}},
          {"indices", indices}}}}}};
  document["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", binds}}};
  document["animations"] = {
      {{"name", "turn"},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}}}},
       {"samplers", {{{"input", times}, {"output", turns}, {"interpolation", "LINEAR"}}}}}};
  return document;
}

Result<Character> Read(const std::string& name, const std::string& contents) {
  const TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary) << contents;
  return ReadCharacter(folder / name);
}

}  // namespace

std::string SmallFbx(const std::string& extra) { return kFbxBefore + extra + kFbxAfter; }
std::string SmallCollada() { return kCollada; }
Json SmallGltf() { return SmallGltfWithTimes({0.0f, 0.5f}); }
Json SmallGltfWithTimes(const std::vector<float>& times) {
  return MakeGltf({1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 0, times);
}
Json SmallGltfWithIntegerWeights(size_t bytes) {
  return MakeGltf({1, 0, 0, 0, 1, 0, 0, 0, 0.2, 0.8, 0, 0, 0.2, 0.8, 0, 0}, bytes);
}

Json BareGltf(const std::vector<BareNode>& nodes) {
  Json document = {
      {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", Json::array({Json::object()})}};
  Buffer buffer(&document);
  const size_t triangle = buffer.Floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
  const size_t times = buffer.Floats({0.0f, 0.5f, 1.0f}, 1);
  Json animation = {{"name", "go"}};
  for (size_t i = 0; i < nodes.size(); ++i) {
    const BareNode& node = nodes[i];
    document["nodes"].push_back({{"name", node.name}, {"translation", node.at}});
    Json& above = node.parent < 0 ? document["scenes"][0]["nodes"]
                                  : document["nodes"][static_cast<size_t>(node.parent)]["children"];
    above.push_back(i);
    if (node.has_mesh) document["nodes"][i]["mesh"] = 0;
    if (node.is_camera) document["nodes"][i]["camera"] = 0;
    if (!node.moves) continue;
    std::vector<float> places;
    for (const double away : {0.0, 1.0, 0.0}) {
      for (size_t k = 0; k < 3; ++k)
        places.push_back(static_cast<float>(node.at[k] + (k == 0 ? away : 0.0)));
    }
    animation["samplers"].push_back({{"input", times}, {"output", buffer.Floats(places, 3)}});
    animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                     {"target", {{"node", i}, {"path", "translation"}}}});
  }
  buffer.Close();
  // Braces alone mean an array of one to g++ and its entry to clang++.
  document["animations"] = Json::array({animation});
  const Json primitive = Json::object({{"attributes", {{"POSITION", triangle}}}});
  document["meshes"] = Json::array({Json::object({{"primitives", Json::array({primitive})}})});
  document["cameras"] = Json::array(
      {Json::object({{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}})});
  return document;
}

Character ReadSmall(const std::string& name, const std::string& contents) {
  Result<Character> result = Read(name, contents);
  EXPECT_TRUE(result.ok()) << result.error().ToString();
  return result.ok() ? std::move(result).value() : Character();
}

Error ErrorOfSmall(const std::string& name, const std::string& contents) {
  const Result<Character> result = Read(name, contents);
  EXPECT_FALSE(result.ok());
  return result.ok() ? Error() : result.error();
}

double UpperTurnAt(const Character& character, size_t frame) {
  const Eigen::Quaterniond& q = character.clips.at(0).tracks.at(1).rotations.at(frame);
  return 2.0 * std::atan2(q.z(), q.w()) * 180.0 / std::numbers::pi;
}

Pose WorldRest(const Character& character, size_t bone) {
  const Bone& b = character.bones[bone];
  return b.parent < 0 ? b.rest : WorldRest(character, static_cast<size_t>(b.parent)) * b.rest;
}

}  // namespace hazumi::test
