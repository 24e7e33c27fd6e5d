#include "engine/exchange/fbx/fbx_motions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>

#include "engine/exchange/fbx/fbx_objects.h"

namespace hazumi {
namespace {

constexpr std::string_view kHelper = "_$AssimpFbx$_";

// Curves of the axes of a property; without one it keeps its value.
struct FbxAxes {
  Vec3 otherwise = Vec3::Zero();
  std::array<ScalarCurve, 3> curves;

  Vec3 At(double t, double slack) const {
    Vec3 value = otherwise;
    for (size_t k = 0; k < 3; ++k)
      if (!curves[k].empty()) value[static_cast<int>(k)] = ValueAt(curves[k], t, slack);
    return value;
  }
};

class FbxMotion : public NodeMotion {
 public:
  explicit FbxMotion(const FbxModel& model) : model_(model) {
    axes_[0].otherwise = model.T;
    axes_[1].otherwise = model.R;
    axes_[2].otherwise = model.S;
  }
  // 0: translation, 1: rotation, 2: scale.
  FbxAxes& axes(size_t property) { return axes_[property]; }
  void Shift(double by) {
    for (FbxAxes& axes : axes_) {
      for (ScalarCurve& curve : axes.curves)
        for (ScalarKey& key : curve) key.t += by;
    }
  }
  bool moves() const {
    return std::any_of(axes_.begin(), axes_.end(), [](const FbxAxes& axes) {
      return std::any_of(axes.curves.begin(), axes.curves.end(),
                         [](const ScalarCurve& curve) { return !curve.empty(); });
    });
  }

  NodeValue At(double t, double slack) const override {
    NodeValue value;
    value.matrix =
        model_.Transform(axes_[0].At(t, slack), axes_[1].At(t, slack), axes_[2].At(t, slack));
    return value;
  }
  void AddTimes(std::vector<double>* times) const override {
    for (const FbxAxes& axes : axes_) {
      for (const ScalarCurve& curve : axes.curves) {
        if (curve.size() < 2) continue;
        for (const ScalarKey& key : curve) times->push_back(key.t);
      }
    }
  }
  bool IsSound() const override {
    return std::all_of(axes_.begin(), axes_.end(), [](const FbxAxes& axes) {
      return std::all_of(axes.curves.begin(), axes.curves.end(), hazumi::IsSound);
    });
  }

 private:
  FbxModel model_;
  std::array<FbxAxes, 3> axes_;
};

// Connection of a record to another, by ids.
struct Connection {
  int64_t to = 0;
  std::string property;  // empty: as a child
};

class FbxReader {
 public:
  FbxReader(const FbxRecord& records, Scene* scene) : scene_(*scene) {
    if (const FbxRecord* objects = records.Find("Objects")) AddObjects(*objects);
    if (const FbxRecord* connections = records.Find("Connections")) AddConnections(*connections);
    for (size_t i = 0; i < scene_.nodes.size(); ++i) {
      const auto [known, is_new] = node_.emplace(scene_.nodes[i].name, static_cast<int>(i));
      if (!is_new) known->second = kTwice;
    }
  }

  void MoveGeometry() {
    for (const auto& [id, model] : models_) {
      const Eigen::Matrix4d G = model.Geometry();
      if (G.isIdentity(1e-12)) continue;
      for (const SceneNode& node : scene_.nodes) {
        const std::string name = node.name.substr(0, node.name.find(kHelper));
        if (name != model.name) continue;
        for (const int mesh : node.meshes) MoveSkin(G, static_cast<size_t>(mesh));
      }
    }
  }

  void ReplaceMotions() {
    for (const auto& [id, stack] : stacks_) {
      const std::string& name = stack.name;
      const auto clip = std::find_if(scene_.clips.begin(), scene_.clips.end(),
                                     [&](const SceneClip& c) { return c.name == name; });
      const std::vector<int64_t> layers = Below(id, layers_);
      if (clip == scene_.clips.end()) continue;
      if (layers.size() == 1) {
        Replace(layers[0], stack, &*clip);
      } else {
        scene_.warnings.push_back(
            {"clip " + name, "it has " + std::to_string(layers.size()) +
                                 " layers; between keys it is read as straight"});
      }
    }
  }

 private:
  static constexpr int kTwice = -2;
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  void AddObjects(const FbxRecord& objects) {
    for (const FbxRecord& record : objects.children) {
      const int64_t id = record.Whole(0);
      if (record.name == "Model") {
        models_[id] = FbxModelOf(record);
        ++named_[models_[id].name];
      } else if (record.name == "AnimationStack") {
        stacks_[id] = FbxStackOf(record);
      } else if (record.name == "AnimationLayer") {
        layers_.insert(id);
      } else if (record.name == "AnimationCurveNode") {
        curve_nodes_[id] =
            Vec3(FbxNumberOf(record, "d|X", kNone), FbxNumberOf(record, "d|Y", kNone),
                 FbxNumberOf(record, "d|Z", kNone));
      } else if (record.name == "AnimationCurve") {
        curves_[id] = FbxCurveOf(record);
      }
    }
  }

  void AddConnections(const FbxRecord& connections) {
    for (const FbxRecord& c : connections.children) {
      if (c.values.size() < 3) continue;
      from_[c.Whole(2)].push_back(c.Whole(1));
      to_[c.Whole(1)].push_back({c.Whole(2), c.Text(3)});
    }
  }

  template <typename Set>
  std::vector<int64_t> Below(int64_t id, const Set& among) const {
    std::vector<int64_t> found;
    const auto all = from_.find(id);
    if (all == from_.end()) return found;
    for (const int64_t below : all->second)
      if (among.contains(below)) found.push_back(below);
    return found;
  }

  void MoveSkin(const Eigen::Matrix4d& G, size_t mesh) {
    SceneMesh& skin = scene_.meshes[mesh];
    if (!skin.is_skinned || !moved_.insert(mesh).second) return;
    for (SceneMesh::Bind& bind : skin.binds) bind.inverse_bind = (bind.inverse_bind * G).eval();
  }

  void Replace(int64_t layer, const FbxStack& stack, SceneClip* clip) {
    std::map<int64_t, std::unique_ptr<FbxMotion>> motions;  // by model
    for (const int64_t curve_node : Below(layer, curve_nodes_)) {
      const auto connections = to_.find(curve_node);
      if (connections == to_.end()) continue;
      for (const Connection& to : connections->second) AddCurves(curve_node, to, &motions);
    }
    const double start = stack.has_times() ? stack.start : FirstKeyOf(motions);
    for (auto& [id, motion] : motions) {
      motion->Shift(-start);
      const std::string& name = models_.at(id).name;
      const auto node = node_.find(name);
      if (!motion->moves() || node == node_.end() || node->second < 0 || named_.at(name) > 1)
        continue;
      std::erase_if(clip->motions, [&](const auto& known) {
        const std::string& of = scene_.nodes[static_cast<size_t>(known.first)].name;
        return of.substr(0, of.find(kHelper)) == name;
      });
      clip->motions.emplace_back(node->second, std::move(motion));
    }
    std::stable_sort(clip->motions.begin(), clip->motions.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  static double FirstKeyOf(const std::map<int64_t, std::unique_ptr<FbxMotion>>& motions) {
    std::vector<double> times;
    for (const auto& [id, motion] : motions) motion->AddTimes(&times);
    return times.empty() ? 0.0 : *std::min_element(times.begin(), times.end());
  }

  void AddCurves(int64_t curve_node, const Connection& to,
                 std::map<int64_t, std::unique_ptr<FbxMotion>>* motions) const {
    constexpr std::string_view kProperties[] = {"Lcl Translation", "Lcl Rotation", "Lcl Scaling"};
    constexpr std::string_view kAxes[] = {"d|X", "d|Y", "d|Z"};
    const auto* property = std::find(std::begin(kProperties), std::end(kProperties), to.property);
    if (property == std::end(kProperties) || !models_.contains(to.to)) return;
    std::unique_ptr<FbxMotion>& motion = (*motions)[to.to];
    if (!motion) motion = std::make_unique<FbxMotion>(models_.at(to.to));
    FbxAxes& axes = motion->axes(static_cast<size_t>(property - std::begin(kProperties)));
    const Vec3& stated = curve_nodes_.at(curve_node);
    for (int k = 0; k < 3; ++k)
      if (!std::isnan(stated[k])) axes.otherwise[k] = stated[k];
    const auto below = from_.find(curve_node);
    if (below == from_.end()) return;
    for (const int64_t id : below->second) {
      const auto curve = curves_.find(id);
      if (curve == curves_.end()) continue;
      for (const Connection& at : to_.at(id)) {
        const auto* axis = std::find(std::begin(kAxes), std::end(kAxes), at.property);
        if (at.to != curve_node || axis == std::end(kAxes)) continue;
        axes.curves[static_cast<size_t>(axis - std::begin(kAxes))] = curve->second;
      }
    }
  }

  Scene& scene_;
  std::map<int64_t, FbxModel> models_;
  std::map<std::string, int> named_;  // how many models have a name
  std::map<int64_t, FbxStack> stacks_;
  std::set<int64_t> layers_;
  std::map<int64_t, Vec3> curve_nodes_;  // the values of axes without a curve
  std::map<int64_t, ScalarCurve> curves_;
  std::unordered_map<int64_t, std::vector<int64_t>> from_;  // what hangs on an id
  std::unordered_map<int64_t, std::vector<Connection>> to_;
  std::unordered_map<std::string, int> node_;  // of the scene, by name
  std::set<size_t> moved_;                     // meshes
};

}  // namespace

void TakeFbxMotions(const FbxRecord& records, Scene* scene) {
  FbxReader reader(records, scene);
  reader.MoveGeometry();
  reader.ReplaceMotions();
}

}  // namespace hazumi
