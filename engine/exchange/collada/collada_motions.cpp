#include "engine/exchange/collada/collada_motions.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <set>

#include "engine/base/utf8.h"
#include "engine/exchange/scene/scalar_curve.h"
#include "engine/exchange/scene/scene_tree.h"

namespace hazumi {
namespace {

std::vector<double> NumbersIn(const char* text) {
  std::vector<double> numbers;
  for (char* rest = nullptr;; text = rest) {
    const double number = std::strtod(text, &rest);
    if (rest == text) return numbers;
    numbers.push_back(number);
  }
}

std::vector<std::string> WordsIn(const char* text) {
  std::vector<std::string> words;
  constexpr const char* kBlanks = " \t\r\n";
  for (text += std::strspn(text, kBlanks); *text; text += std::strspn(text, kBlanks)) {
    const size_t length = std::strcspn(text, kBlanks);
    words.emplace_back(text, length);
    text += length;
  }
  return words;
}

// One element of a node's transform, its numbers at rest, and curves of some of them.
struct TransformPart {
  enum class Kind { kTranslate, kRotate, kScale, kMatrix };
  Kind kind = Kind::kTranslate;
  std::string sid;
  std::vector<double> numbers;
  std::map<size_t, ScalarCurve> curves;  // by number
  KeyedMotion keys;                      // of a matrix

  bool moves() const { return !curves.empty() || !keys.translation.empty(); }
};

size_t CountOf(TransformPart::Kind kind) {
  return kind == TransformPart::Kind::kMatrix ? 16 : kind == TransformPart::Kind::kRotate ? 4 : 3;
}

Eigen::Matrix4d MatrixOf(const std::vector<double>& rows) {
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.data());
}

Eigen::Matrix4d TransformOf(TransformPart::Kind kind, const std::vector<double>& numbers) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  const Vec3 v(numbers[0], numbers[1], numbers[2]);
  switch (kind) {
    case TransformPart::Kind::kTranslate:
      M.topRightCorner<3, 1>() = v;
      break;
    case TransformPart::Kind::kRotate:
      if (v.norm() > 1e-9) {
        M.topLeftCorner<3, 3>() =
            Eigen::AngleAxisd(numbers[3] * std::numbers::pi / 180.0, v.normalized())
                .toRotationMatrix();
      }
      break;
    case TransformPart::Kind::kScale:
      M.topLeftCorner<3, 3>() = v.asDiagonal().toDenseMatrix();
      break;
    case TransformPart::Kind::kMatrix:
      return MatrixOf(numbers);
  }
  return M;
}

class ColladaMotion : public NodeMotion {
 public:
  explicit ColladaMotion(std::vector<TransformPart> elements) : elements_(std::move(elements)) {}

  NodeValue At(double t, double slack) const override {
    Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
    for (const TransformPart& element : elements_) product = product * Transform(element, t, slack);
    NodeValue value;
    value.matrix = product;
    return value;
  }
  void AddTimes(std::vector<double>* times) const override {
    for (const TransformPart& element : elements_) {
      for (const auto& [number, curve] : element.curves) {
        if (curve.size() < 2) continue;
        for (const ScalarKey& key : curve) times->push_back(key.t);
      }
      element.keys.AddTimes(times);
    }
  }
  bool IsSound() const override {
    return std::all_of(elements_.begin(), elements_.end(), [](const TransformPart& element) {
      return element.keys.IsSound() &&
             std::all_of(element.curves.begin(), element.curves.end(),
                         [](const auto& curve) { return hazumi::IsSound(curve.second); });
    });
  }

 private:
  static Eigen::Matrix4d Transform(const TransformPart& element, double t, double slack) {
    if (!element.keys.translation.empty()) {
      const NodeValue value = element.keys.At(t, slack);
      MatrixParts parts;
      parts.X = {value.rotation->toRotationMatrix(), *value.translation};
      parts.scale = *value.scale;
      return Compose(parts);
    }
    std::vector<double> numbers = element.numbers;
    for (const auto& [number, curve] : element.curves) numbers[number] = ValueAt(curve, t, slack);
    return TransformOf(element.kind, numbers);
  }

  std::vector<TransformPart> elements_;
};

// The sources that a sampler names.
struct ColladaSampler {
  std::vector<double> times, values, before, behind;
  std::vector<std::string> interpolations;

  ScalarKey::Kind KindOf(size_t key) const {
    const std::string name = key < interpolations.size() ? interpolations[key] : "";
    if (name == "STEP") return ScalarKey::Kind::kStep;
    return name == "BEZIER" ? ScalarKey::Kind::kBezier : ScalarKey::Kind::kLinear;
  }
  bool IsAll(const char* name) const {
    return !interpolations.empty() &&
           std::all_of(interpolations.begin(), interpolations.end(),
                       [&](const std::string& word) { return word == name; });
  }
};

// A number of each key, of `width` numbers a key. Tangents are points of time and value for each
// number; exporters of one number alone also write them for several at once.
ScalarCurve CurveOf(const ColladaSampler& sampler, size_t width, size_t number) {
  ScalarCurve curve;
  const size_t count = sampler.times.size();
  const auto tangent = [&](const std::vector<double>& points, size_t key) -> const double* {
    return points.size() == 2 * width * count ? points.data() + 2 * (width * key + number)
                                              : nullptr;
  };
  for (size_t i = 0; i < count; ++i) {
    ScalarKey key;
    key.t = sampler.times[i];
    key.v = sampler.values[width * i + number];
    key.kind = sampler.KindOf(i);
    if (key.kind == ScalarKey::Kind::kBezier && i + 1 < count) {
      const double *behind = tangent(sampler.behind, i), *before = tangent(sampler.before, i + 1);
      const double next_t = sampler.times[i + 1], next_v = sampler.values[width * (i + 1) + number];
      if (behind && before) {
        key.behind = {behind[0] - key.t, behind[1] - key.v};
        key.before = {next_t - before[0], next_v - before[1]};
      } else {
        key.kind = ScalarKey::Kind::kLinear;
      }
    }
    curve.push_back(key);
  }
  return curve;
}

void SetMatrixKeys(const ColladaSampler& sampler, TransformPart* element) {
  const KeyInterpolation how =
      sampler.IsAll("STEP") ? KeyInterpolation::kStep : KeyInterpolation::kLinear;
  for (JointKeys* keys :
       {&element->keys.translation, &element->keys.rotation, &element->keys.scale}) {
    *keys = {};
    keys->interpolation = how;
    keys->times = sampler.times;
  }
  for (size_t i = 0; i < sampler.times.size(); ++i) {
    const auto from = sampler.values.begin() + static_cast<std::ptrdiff_t>(16 * i);
    const MatrixParts parts = Decompose(MatrixOf({from, from + 16}));
    const Eigen::Quaterniond q(parts.X.R);
    element->keys.translation.values.emplace_back(parts.X.p.x(), parts.X.p.y(), parts.X.p.z(), 0.0);
    element->keys.rotation.values.push_back(q.coeffs());
    element->keys.scale.values.emplace_back(parts.scale.x(), parts.scale.y(), parts.scale.z(), 0.0);
  }
}

// Target of a channel: "node/sid", "node/sid.ANGLE", "node/sid(2)", "node/sid(1)(3)".
struct ColladaTarget {
  std::string node, sid, member;
};

ColladaTarget TargetOf(const std::string& text) {
  ColladaTarget target;
  const size_t slash = text.find('/');
  target.node = text.substr(0, slash);
  if (slash == std::string::npos) return target;
  const std::string rest = text.substr(slash + 1);
  const size_t end = rest.find_first_of(".(");
  target.sid = rest.substr(0, end);
  if (end != std::string::npos) target.member = rest.substr(end);
  return target;
}

// Index of the number that a member names; none: all numbers.
std::optional<size_t> NumberOf(const TransformPart& element, const std::string& member) {
  if (member == ".ANGLE") return 3;
  if (member == ".X") return 0;
  if (member == ".Y") return 1;
  if (member == ".Z") return 2;
  int first = 0, second = 0;
  const int read = std::sscanf(member.c_str(), "(%d)(%d)", &first, &second);
  if (read == 1 && first >= 0) return static_cast<size_t>(first);
  if (read == 2 && first >= 0 && second >= 0 && element.kind == TransformPart::Kind::kMatrix)
    return static_cast<size_t>(4 * first + second);
  return std::nullopt;
}

class ColladaReader {
 public:
  ColladaReader(const pugi::xml_node& top, Scene* scene) : scene_(*scene) {
    for (size_t i = 0; i < scene_.nodes.size(); ++i) {
      const auto [known, is_new] = of_scene_.emplace(scene_.nodes[i].name, static_cast<int>(i));
      if (!is_new) known->second = -1;
    }
    for (const pugi::xml_node& library : top.children("library_visual_scenes"))
      for (const pugi::xml_node& one : library.children("visual_scene")) AddNodes(one, 0);
    for (const pugi::xml_node& library : top.children("library_nodes")) AddNodes(library, 0);
    for (const pugi::xml_node& library : top.children("library_animations"))
      AddAnimations(library, 0);
  }

  void ReplaceMotions() {
    if (scene_.clips.size() != 1) return;
    SceneClip& clip = scene_.clips[0];
    for (auto& [id, node] : nodes_) {
      const auto known = of_scene_.find(node.name);
      const bool moves = std::any_of(node.elements.begin(), node.elements.end(),
                                     [](const TransformPart& element) { return element.moves(); });
      if (!moves) continue;
      if (node.is_strange || known == of_scene_.end() || known->second < 0) {
        kept_.insert(ValidUtf8(node.name));
        continue;
      }
      std::erase_if(clip.motions,
                    [&](const auto& motion) { return motion.first == known->second; });
      clip.motions.emplace_back(known->second,
                                std::make_unique<ColladaMotion>(std::move(node.elements)));
    }
    std::stable_sort(clip.motions.begin(), clip.motions.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    if (kept_.empty()) return;
    std::string names;
    for (const std::string& name : kept_) names += (names.empty() ? "" : ", ") + name;
    scene_.warnings.push_back({"clips", "between keys these are read as straight: " + names});
  }

 private:
  static constexpr int kDeepest = 1'000;
  struct Node {
    std::string name;
    std::vector<TransformPart> elements;
    bool is_strange = false;  // has elements of other kinds, or curves that are not understood
  };

  void AddNodes(const pugi::xml_node& parent, int depth) {
    if (depth > kDeepest) return;
    for (const pugi::xml_node& node : parent.children("node")) {
      const std::string id = node.attribute("id").as_string();
      Node made;
      made.name = node.attribute("name").as_string(id.c_str());
      for (const pugi::xml_node& child : node.children()) AddElement(child, &made);
      if (!id.empty()) nodes_[id] = std::move(made);
      AddNodes(node, depth + 1);
    }
  }

  static void AddElement(const pugi::xml_node& child, Node* node) {
    const std::string name = child.name();
    TransformPart element;
    if (name == "lookat" || name == "skew") {
      node->is_strange = true;
      return;
    }
    if (name == "rotate") {
      element.kind = TransformPart::Kind::kRotate;
    } else if (name == "scale") {
      element.kind = TransformPart::Kind::kScale;
    } else if (name == "matrix") {
      element.kind = TransformPart::Kind::kMatrix;
    } else if (name != "translate") {
      return;
    }
    element.sid = child.attribute("sid").as_string();
    element.numbers = NumbersIn(child.child_value());
    if (element.numbers.size() != CountOf(element.kind)) node->is_strange = true;
    node->elements.push_back(std::move(element));
  }

  void AddAnimations(const pugi::xml_node& parent, int depth) {
    if (depth > kDeepest) return;
    for (const pugi::xml_node& animation : parent.children("animation")) {
      for (const pugi::xml_node& channel : animation.children("channel"))
        AddChannel(animation, channel);
      AddAnimations(animation, depth + 1);
    }
  }

  void AddChannel(const pugi::xml_node& animation, const pugi::xml_node& channel) {
    const ColladaTarget target = TargetOf(channel.attribute("target").as_string());
    const auto node = nodes_.find(target.node);
    if (node == nodes_.end()) return;
    const auto element =
        std::find_if(node->second.elements.begin(), node->second.elements.end(),
                     [&](const TransformPart& e) { return !e.sid.empty() && e.sid == target.sid; });
    if (element == node->second.elements.end()) return;
    const std::optional<ColladaSampler> sampler = SamplerOf(animation, channel);
    if (!sampler || !SetCurves(*sampler, target.member, &*element)) node->second.is_strange = true;
  }

  static bool SetCurves(const ColladaSampler& sampler, const std::string& member,
                        TransformPart* element) {
    const size_t count = sampler.times.size(), width = CountOf(element->kind);
    const std::optional<size_t> number = NumberOf(*element, member);
    if (count == 0 || (!member.empty() && (!number || *number >= width))) return false;
    if (sampler.values.size() != (number ? 1 : width) * count) return false;
    if (number) {
      element->curves[*number] = CurveOf(sampler, 1, 0);
    } else if (element->kind == TransformPart::Kind::kMatrix) {
      SetMatrixKeys(sampler, element);
    } else {
      for (size_t k = 0; k < width; ++k) element->curves[k] = CurveOf(sampler, width, k);
    }
    return true;
  }

  static pugi::xml_node ById(const pugi::xml_node& animation, const char* name,
                             const std::string& reference) {
    if (!reference.starts_with("#")) return {};
    return animation.find_child_by_attribute(name, "id", reference.c_str() + 1);
  }

  static std::optional<ColladaSampler> SamplerOf(const pugi::xml_node& animation,
                                                 const pugi::xml_node& channel) {
    const pugi::xml_node from = ById(animation, "sampler", channel.attribute("source").as_string());
    if (!from) return std::nullopt;
    ColladaSampler sampler;
    for (const pugi::xml_node& input : from.children("input")) {
      const std::string semantic = input.attribute("semantic").as_string();
      const pugi::xml_node source =
          ById(animation, "source", input.attribute("source").as_string());
      const char* numbers = source.child("float_array").child_value();
      if (semantic == "INPUT") sampler.times = NumbersIn(numbers);
      if (semantic == "OUTPUT") sampler.values = NumbersIn(numbers);
      if (semantic == "IN_TANGENT") sampler.before = NumbersIn(numbers);
      if (semantic == "OUT_TANGENT") sampler.behind = NumbersIn(numbers);
      if (semantic == "INTERPOLATION")
        sampler.interpolations = WordsIn(source.child("Name_array").child_value());
    }
    return sampler;
  }

  Scene& scene_;
  std::map<std::string, int> of_scene_;  // by name; -1: several
  std::map<std::string, Node> nodes_;    // by id
  std::set<std::string> kept_;           // as assimp has them
};

}  // namespace

void TakeColladaMotions(std::string_view bytes, Scene* scene) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
  if (!parsed) {
    scene->warnings.push_back(
        {"clips", "the curves between keys cannot be read; they are taken as straight"});
    return;
  }
  ColladaReader(document.child("COLLADA"), scene).ReplaceMotions();
}

}  // namespace hazumi
