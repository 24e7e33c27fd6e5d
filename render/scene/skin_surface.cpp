#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>

#include "render/scene/skin_triangles.h"

namespace hazumi::render {
namespace {

constexpr double kMostBorder = 2.0;  // squared length over area

using Triangle = std::array<std::uint32_t, 3>;

// For every vertex, the one that stands for all in its place.
std::vector<std::uint32_t> Weld(const SkinMesh& mesh) {
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const Eigen::Vector3f &p = mesh.positions[a], &q = mesh.positions[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::vector<std::uint32_t> order(mesh.positions.size()), welded(order.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), less);
  for (size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || less(order[i - 1], order[i]);
    welded[order[i]] = is_new ? order[i] : welded[order[i - 1]];
  }
  return welded;
}

std::uint32_t RootOf(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

struct Piece {
  double area2 = 0.0, border = 0.0;  // twice the area
  double along_normals = 0.0;        // > 0: wound as the normals say
  bool lacks_normals = false;

  bool is_open() const { return lacks_normals || border * border > kMostBorder * 0.5 * area2; }
};

class Splitter {
 public:
  explicit Splitter(const SkinMesh& mesh) : mesh_(mesh), welded_(Weld(mesh)), parents_(welded_) {
    for (const Triangle& t : mesh.triangles) {
      const Triangle w = Welded(t);
      if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0]) continue;
      kept_.push_back(t);
      parents_[RootOf(parents_, w[0])] = RootOf(parents_, w[1]);
      parents_[RootOf(parents_, w[1])] = RootOf(parents_, w[2]);
    }
    pieces_.resize(welded_.size());
    for (const Triangle& t : kept_) AddTriangle(t);
    AddBorders();
  }

  SkinSurface Split() {
    SkinSurface surface;
    for (Triangle t : kept_) {
      const Piece& piece = PieceOf(t[0]);
      if (piece.along_normals < 0.0) std::swap(t[1], t[2]);
      std::vector<std::uint32_t>& to = piece.is_open() ? surface.open : surface.closed;
      to.insert(to.end(), t.begin(), t.end());
    }
    return surface;
  }

 private:
  Triangle Welded(const Triangle& t) const { return {welded_[t[0]], welded_[t[1]], welded_[t[2]]}; }
  Piece& PieceOf(std::uint32_t vertex) { return pieces_[RootOf(parents_, welded_[vertex])]; }

  void AddTriangle(const Triangle& t) {
    Piece& piece = PieceOf(t[0]);
    const auto p = [&](int k) -> Eigen::Vector3d { return mesh_.positions[t[k]].cast<double>(); };
    const Eigen::Vector3d normal2 = (p(1) - p(0)).cross(p(2) - p(0));
    piece.area2 += normal2.norm();
    for (const std::uint32_t vertex : t) {
      const Eigen::Vector3d n = mesh_.normals[vertex].cast<double>();
      piece.along_normals += normal2.dot(n);
      piece.lacks_normals |= n.squaredNorm() < 1e-4;
    }
  }

  // An edge of one triangle only is a border.
  void AddBorders() {
    std::vector<std::uint64_t> edges;  // two vertices, the smaller one above
    edges.reserve(3 * kept_.size());
    for (const Triangle& t : kept_) {
      const Triangle w = Welded(t);
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(w[k], w[(k + 1) % 3]);
        edges.push_back(std::uint64_t{low} << 32 | high);
      }
    }
    std::sort(edges.begin(), edges.end());
    for (size_t i = 0, next = 0; i < edges.size(); i = next) {
      while (next < edges.size() && edges[next] == edges[i]) ++next;
      if (next - i > 1) continue;
      const auto a = static_cast<std::uint32_t>(edges[i] >> 32);
      const auto b = static_cast<std::uint32_t>(edges[i]);
      PieceOf(a).border += (mesh_.positions[a] - mesh_.positions[b]).norm();
    }
  }

  const SkinMesh& mesh_;
  std::vector<std::uint32_t> welded_, parents_;
  std::vector<Triangle> kept_;
  std::vector<Piece> pieces_;  // by the root of their vertices
};

}  // namespace

SkinSurface SplitSurface(const SkinMesh& mesh) { return Splitter(mesh).Split(); }

}  // namespace hazumi::render
