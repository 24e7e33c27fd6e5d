#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/exchange/import/figure_parts.h"

namespace hazumi {

namespace {

constexpr double kShortest = 0.01;     // of a segment, as a share of the height
constexpr double kStub = 0.3;          // of a bone of no known length, as a share of the one before
constexpr double kThickest = 0.45;     // radius of an unknown bone, as a share of its length
constexpr double kMostOfHeight = 0.1;  // radius, as a share of the height
constexpr double kRoundest = 0.25;     // the same of a head or a fist, measured
constexpr double kThinnest = 0.005;    // radius of a foot, as a share of the height
constexpr int kFewVertices = 12;

// The skin's vertices that follow each kept bone most, at rest in its body's frame [m].
std::vector<std::vector<Vec3>> VerticesOf(const Skin& skin, size_t num_bodies) {
  std::vector<std::vector<Vec3>> vertices(num_bodies);
  for (const SkinMesh& mesh : skin.meshes) {
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      const auto& weights = mesh.weights[v];
      const auto most = std::max_element(weights.begin(), weights.end()) - weights.begin();
      const SkinMesh::Bind& bind = mesh.binds[mesh.bind_indices[v][most]];
      vertices[bind.bone].push_back(
          (bind.inverse_bind * mesh.positions[v].cast<double>().homogeneous()).head<3>());
    }
  }
  return vertices;
}

double DistanceFrom(const LinkSpec& link, const Vec3& p) {
  const Vec3 along = link.to - link.from;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - link.from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - link.from - t * along).norm();
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class LinkMaker {
 public:
  LinkMaker(const Character& character, const Skeleton& skeleton, const FigurePlan& plan,
            const Skin& skin, const WorldFrame& world)
      : character_(character),
        skeleton_(skeleton),
        plan_(plan),
        world_(world),
        vertices_(VerticesOf(skin, skeleton.bones.size())),
        rest_(RestBodies(plan)) {}

  std::vector<std::vector<LinkSpec>> Make() const {
    std::vector<std::vector<LinkSpec>> links;
    for (size_t k = 0; k < skeleton_.bones.size(); ++k) {
      links.push_back(LinksOn(k));
      if (!IsOfFoot(k) || vertices_[k].empty()) continue;
      for (LinkSpec& link : links.back()) PutOnSole(k, &link);
    }
    return links;
  }

 private:
  const BodyName& body(size_t k) const { return skeleton_.bones[k].body; }

  std::vector<LinkSpec> LinksOn(size_t k) const {
    std::vector<LinkSpec> links;
    if (IsShapedBySkin(k)) return {LinkAround(k)};
    for (const Vec3& end : EndsOf(k)) {
      LinkSpec link;
      link.to = end;
      link.radius = RadiusOf(k, link);
      link.name = plan_.joints[k].name;
      if (!links.empty()) link.name += "_" + std::to_string(links.size() + 1);
      links.push_back(std::move(link));
    }
    return links;
  }

  bool IsOfFoot(size_t k) const {
    const BodyRole role = skeleton_.bones[k].place.role;
    return role == BodyRole::kFoot || role == BodyRole::kToe;
  }

  // At rest, when feet are flat, no thicker than the skin is high there, and not below it.
  void PutOnSole(size_t k, LinkSpec* link) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& p : vertices_[k]) {
      const double z = (rest_[k] * p).z();
      low = std::min(low, z);
      high = std::max(high, z);
    }
    link->radius = std::min(link->radius, std::max(0.5 * (high - low), kThinnest * world_.height));
    for (Vec3* end : {&link->from, &link->to}) {
      const double below = low + link->radius - (rest_[k] * *end).z();
      if (below > 0.0) *end += below * rest_[k].R.row(2).transpose();
    }
  }

  // Whether nothing but the skin says how far the bone goes.
  bool IsShapedBySkin(size_t k) const {
    return skeleton_.bones[k].children.empty() &&
           !character_.bones[skeleton_.bones[k].bone].end_site &&
           static_cast<int>(vertices_[k].size()) >= kFewVertices;
  }

  // Along the line from the joint through the middle of the vertices, as far as they go.
  LinkSpec LinkAround(size_t k) const {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : vertices_[k]) mean += p / static_cast<double>(vertices_[k].size());
    const Vec3 along = mean.norm() > kShortest * world_.height ? mean.normalized() : Vec3::UnitZ();
    std::vector<double> heights, distances;
    for (const Vec3& p : vertices_[k]) {
      heights.push_back(p.dot(along));
      distances.push_back((p - heights.back() * along).norm());
    }
    std::sort(heights.begin(), heights.end());
    const size_t few = heights.size() / 20;
    const double low = heights[few], high = heights[heights.size() - 1 - few];
    LinkSpec link;
    link.name = plan_.joints[k].name;
    link.radius = std::clamp(Median(std::move(distances)), kShortest * world_.height,
                             kRoundest * world_.height);
    const bool begins_at_joint = low > link.radius;  // the skin of the way there follows others
    if (!begins_at_joint) link.from = std::min(low + link.radius, 0.5 * (low + high)) * along;
    link.to = std::max(high - link.radius, 0.5 * (low + high)) * along;
    return link;
  }

  // The joints beyond, or where the bone ends.
  std::vector<Vec3> EndsOf(size_t k) const {
    std::vector<Vec3> ends;
    const auto add = [&](const Vec3& end) {
      if (end.norm() > kShortest * world_.height) ends.push_back(end);
    };
    for (const int child : skeleton_.bones[k].children) add(plan_.joints[child].offset);
    const BonePose& rest = skeleton_.rest[skeleton_.bones[k].bone];
    const Bone& bone = character_.bones[skeleton_.bones[k].bone];
    if (bone.end_site) {
      const Vec3 end = rest.stretch * *bone.end_site;
      add(k == 0 ? world_.Placed(rest.R * end) : world_.Way(end));
    }
    if (ends.empty() && !vertices_[k].empty()) {
      Vec3 mean = Vec3::Zero();
      for (const Vec3& p : vertices_[k]) mean += p;
      add(1.6 * mean / static_cast<double>(vertices_[k].size()));
    }
    if (ends.empty()) ends.push_back(StubOf(k));
    return ends;
  }

  // Of a bone of no length: a little farther the way that the bone before it goes. Not a mere ball
  // about the joint, whose weight would turn it nowhere, so that it would spin for ever in a
  // dynamics region.
  Vec3 StubOf(size_t k) const {
    const PlannedJoint& joint = plan_.joints[k];
    const double length = std::max(kStub * joint.offset.norm(), kShortest * world_.height);
    const Vec3 along = joint.orientation.transpose() * joint.offset;
    return length * (along.norm() > 0.0 ? along.normalized() : Vec3(-Vec3::UnitZ()));
  }

  double RadiusOf(size_t k, const LinkSpec& link) const {
    const double length = (link.to - link.from).norm();
    const double usual = RadiusShareOf(body(k)) * world_.height;
    if (static_cast<int>(vertices_[k].size()) >= kFewVertices) {
      std::vector<double> distances;
      distances.reserve(vertices_[k].size());
      for (const Vec3& p : vertices_[k]) distances.push_back(DistanceFrom(link, p));
      return std::clamp(Median(std::move(distances)), 0.2 * usual, kMostOfHeight * world_.height);
    }
    if (length == 0.0) return usual;
    return body(k).part == BodyPart::kOther ? std::min(usual, kThickest * length) : usual;
  }

  const Character& character_;
  const Skeleton& skeleton_;
  const FigurePlan& plan_;
  const WorldFrame& world_;
  std::vector<std::vector<Vec3>> vertices_;
  std::vector<Pose> rest_;  // of the bodies
};

}  // namespace

std::vector<std::vector<LinkSpec>> LinksOf(const Character& character, const Skeleton& skeleton,
                                           const FigurePlan& plan, const Skin& skin,
                                           const WorldFrame& world) {
  return LinkMaker(character, skeleton, plan, skin, world).Make();
}

}  // namespace hazumi
