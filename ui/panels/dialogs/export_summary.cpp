#include "ui/panels/dialogs/export_summary.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "engine/base/utf8.h"
#include "ui/edit/parameters.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

namespace {

using edit::Json;

// A line as it is shown: without tabs and carriage returns, and no longer than a screen.
std::string Shown(const std::string& line) {
  constexpr size_t kLongest = 160;
  std::string shown;
  for (const char c : line.substr(0, kLongest)) {
    if (c == '\t') shown += "  ";
    if (c != '\t' && c != '\r') shown += c;
  }
  return ValidUtf8(shown) + (line.size() > kLongest ? " ..." : "");
}

// The first lines, and a sign that there are more.
std::string HeadOf(const std::string& text, int most) {
  std::istringstream stream(text.substr(0, 100'000));
  std::string head, line;
  for (int i = 0; i < most && std::getline(stream, line); ++i) head += Shown(line) + "\n";
  return stream.peek() == EOF ? head : head + "...\n";
}

// The hierarchy, and the first frame behind it.
void ReadBvh(const std::string& bytes, ExportSummary* summary) {
  std::istringstream stream(bytes);
  int num_lines = 0;
  for (std::string line; std::getline(stream, line); ++num_lines) {
    std::istringstream words(line);
    std::string word;
    int count = 0;
    words >> word;
    if (word == "MOTION") break;
    if (word == "ROOT" || word == "JOINT") ++summary->joints;
    if (word == "CHANNELS" && words >> count) summary->channels += count;
  }
  constexpr int kMotionHead = 4;  // "MOTION", "Frames:", "Frame Time:", a frame
  summary->head = HeadOf(bytes, num_lines + kMotionHead);
}

std::vector<std::string> Split(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') fields.emplace_back();
    if (c != ',' && c != '\r') fields.back() += c;
  }
  return fields;
}

void ReadCsv(const std::string& bytes, ExportSummary* summary) {
  constexpr int kRows = 4;  // behind the names
  std::istringstream stream(bytes);
  std::string line;
  for (int row = 0; row <= kRows && std::getline(stream, line); ++row) {
    std::vector<std::string> fields = Split(line);
    if (row == 0) summary->columns.resize(fields.size());
    for (size_t i = 0; i < std::min(fields.size(), summary->columns.size()); ++i) {
      summary->columns[i].push_back(ValidUtf8(fields[i]));
    }
  }
  summary->channels = static_cast<int>(summary->columns.size());
  for (const auto& column : summary->columns) {
    summary->joints += column.front().ends_with("_deg") ? 1 : 0;
  }
}

// The JSON of a glTF file; of a binary one it is the first chunk, behind a head of 12 bytes and
// its own length and type.
Json GltfJson(const std::string& bytes) {
  constexpr size_t kLengthAt = 12, kTextAt = 20;
  std::uint32_t length = 0;
  if (!bytes.starts_with("glTF")) return Json::parse(bytes, nullptr, false);
  if (bytes.size() < kTextAt) return Json();
  std::memcpy(&length, bytes.data() + kLengthAt, sizeof length);
  return Json::parse(bytes.substr(kTextAt, length), nullptr, false);
}

int CountOf(const Json& json, const char* list) {
  return json.contains(list) ? static_cast<int>(json.at(list).size()) : 0;
}

void CountTriangles(const Json& gltf, ExportSummary* summary) {
  for (const Json& mesh : gltf.value("meshes", Json::array())) {
    for (const Json& primitive : mesh.value("primitives", Json::array())) {
      const size_t indices = primitive.value("indices", size_t{0});
      summary->triangles += gltf.at("accessors").at(indices).value("count", 0) / 3;
    }
  }
}

// A node and those below it, each two columns further in.
void AddTree(const Json& nodes, size_t number, int depth, ExportSummary* summary) {
  const Json& node = nodes.at(number);
  const std::string name = node.value("name", "");
  summary->names.insert(name);
  const char* mesh = node.contains("mesh") ? "  [mesh]" : "";
  summary->head += std::string(2 * static_cast<size_t>(depth), ' ') + Shown(name) + mesh + "\n";
  for (const size_t child : node.value("children", std::vector<size_t>())) {
    AddTree(nodes, child, depth + 1, summary);
  }
}

void ReadGltf(const std::string& bytes, ExportSummary* summary) {
  const Json gltf = GltfJson(bytes);
  if (!gltf.is_object()) return;
  summary->nodes = CountOf(gltf, "nodes");
  summary->meshes = CountOf(gltf, "meshes");
  CountTriangles(gltf, summary);
  for (const Json& animation : gltf.value("animations", Json::array())) {
    ++summary->animations;
    summary->channels += CountOf(animation, "channels");
    const Json extras = animation.value("extras", Json::object()).value("hazumi", Json::object());
    summary->regions += CountOf(extras, "regions");
    summary->placements += CountOf(extras, "placements");
    summary->events += CountOf(extras, "events");
  }
  for (const Json& node : gltf.value("nodes", Json::array()))
    summary->joints += node.contains("mesh") ? 0 : 1;
  for (const Json& scene : gltf.value("scenes", Json::array())) {
    for (const size_t root : scene.value("nodes", std::vector<size_t>()))
      AddTree(gltf.at("nodes"), root, 0, summary);
  }
}

// Its frames begin where the line of the first one does; before it, lists of joints.
void ReadJson(const std::string& bytes, ExportSummary* summary) {
  summary->head = HeadOf(bytes, 40);
  const size_t list = bytes.find("\"joints\"");
  const size_t from = list == std::string::npos ? list : bytes.find('[', list);
  const size_t to = from == std::string::npos ? from : bytes.find(']', from);
  if (to == std::string::npos) return;
  const Json joints = Json::parse(bytes.substr(from, to - from + 1), nullptr, false);
  if (joints.is_array()) summary->joints = static_cast<int>(joints.size());
}

}  // namespace

ExportSummary SummaryOf(MotionFormat format, const std::string& bytes) {
  ExportSummary summary;
  summary.num_bytes = bytes.size();
  if (format == MotionFormat::kBvh) ReadBvh(bytes, &summary);
  if (format == MotionFormat::kCsv) ReadCsv(bytes, &summary);
  if (format == MotionFormat::kJson) ReadJson(bytes, &summary);
  if (format == MotionFormat::kGltf || format == MotionFormat::kGlb) ReadGltf(bytes, &summary);
  return summary;
}

std::string SizeText(size_t num_bytes) {
  const char* const units[] = {"kB", "MB", "GB"};
  if (num_bytes < 1000) return std::to_string(num_bytes) + Tr(" bytes");
  double size = static_cast<double>(num_bytes) / 1000.0;
  size_t unit = 0;
  for (; size >= 999.5 && unit < 2; ++unit) size /= 1000.0;
  char text[32];
  std::snprintf(text, sizeof text, size < 9.95 ? "%.1f %s" : "%.0f %s", size, units[unit]);
  return text;
}

}  // namespace hazumi::ui
