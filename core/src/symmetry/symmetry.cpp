// SPDX-License-Identifier: MIT
#include "planish/symmetry/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "numeric/trigonometry.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "planish/text/number.hpp"

namespace planish {
namespace {

/// The points of a mesh's faces in cubes of its mean edge.
class PointGrid {
 public:
  PointGrid(const Mesh& mesh, std::vector<int> vertices, double cell)
      : mesh_(mesh), vertices_(std::move(vertices)), cell_(cell) {
    first_.reserve(vertices_.size());
    next_.resize(at(mesh.vertex_count()), -1);
    if (!vertices_.empty()) origin_ = mesh.positions.col(vertices_.front());
    for (const int v : vertices_) {
      const Eigen::Vector3d place = cells(mesh.positions.col(v));
      const auto [entry, added] = first_.try_emplace(key(place), v);
      if (!added) next_[at(v)] = std::exchange(entry->second, v);
    }
  }

  struct Found {
    int vertex = -1;
    double distance = std::numeric_limits<double>::infinity();
  };

  /// The nearest point within `reach`; of equally near ones the first.
  [[nodiscard]] Found nearest(const Eigen::Vector3d& point, double reach) const {
    const Eigen::Vector3d low = cells(point.array() - reach);
    const Eigen::Vector3d wide = cells(point.array() + reach) - low;
    Found found;
    for (int x = 0; x <= wide.x(); ++x) {
      for (int y = 0; y <= wide.y(); ++y) {
        for (int z = 0; z <= wide.z(); ++z) look(low + Eigen::Vector3d(x, y, z), point, found);
      }
    }
    return found.distance <= reach ? found : Found{};
  }

  [[nodiscard]] const std::vector<int>& vertices() const { return vertices_; }
  [[nodiscard]] double cell() const { return cell_; }

 private:
  [[nodiscard]] Eigen::Vector3d cells(const Eigen::Vector3d& point) const {
    return ((point - origin_) / cell_).array().floor();
  }

  /// Cells that are 2²¹ apart share one: distances tell their points apart.
  static std::uint64_t key(const Eigen::Vector3d& cell) {
    constexpr double kCells = 2097152.0;
    std::uint64_t key = 0;
    for (int c = 0; c < 3; ++c) {
      const double wrapped = cell[c] - kCells * std::floor(cell[c] / kCells);
      key = (key << 21U) | (wrapped > 0.0 ? static_cast<std::uint64_t>(wrapped) : 0U);
    }
    return key;
  }

  void look(const Eigen::Vector3d& cell, const Eigen::Vector3d& point, Found& found) const {
    const auto entry = first_.find(key(cell));
    if (entry == first_.end()) return;
    for (int v = entry->second; v >= 0; v = next_[at(v)]) {
      const double distance = (mesh_.positions.col(v) - point).norm();
      if (distance < found.distance || (distance == found.distance && v < found.vertex)) {
        found = {v, distance};
      }
    }
  }

  const Mesh& mesh_;
  std::vector<int> vertices_;
  double cell_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::unordered_map<std::uint64_t, int> first_;  ///< a vertex of each cell
  std::vector<int> next_;                         ///< the next one in the same cell, or −1
};

/// The turn by 2π/order about an axis, or the mirror at right angles to it. Quarter turns are
/// exact.
Eigen::Matrix3d turn_of(const SymmetryElement& element) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (element.order == 0) {
    turn(element.axis, element.axis) = -1.0;
    return turn;
  }
  const double angle = 2.0 * kPi / element.order;
  double c = cosine(angle), s = sine(angle);
  if (element.order == 2) c = -1.0, s = 0.0;
  if (element.order == 4) c = 0.0, s = 1.0;
  const int u = (element.axis + 1) % 3, v = (element.axis + 2) % 3;
  turn(u, u) = turn(v, v) = c;
  turn(v, u) = s;
  turn(u, v) = -s;
  return turn;
}

/// Row `row` of a motion, relative to the centre: kept and mirrored coordinates keep their digits.
double moved_coordinate(const Eigen::Matrix3d& turn, const Eigen::Vector3d& centre,
                        const Eigen::Vector3d& point, int row) {
  if (turn(row, row) == 1.0) return point[row];
  if (turn(row, row) == -1.0) return 2.0 * centre[row] - point[row];
  return centre[row] + turn.row(row).dot((point - centre).transpose());
}

Eigen::Vector3d moved_by(const Eigen::Matrix3d& turn, const Eigen::Vector3d& centre,
                         const Eigen::Vector3d& point) {
  return {moved_coordinate(turn, centre, point, 0), moved_coordinate(turn, centre, point, 1),
          moved_coordinate(turn, centre, point, 2)};
}

bool is_same_cycle(std::span<const int> a, const std::vector<int>& b) {
  if (a.size() != b.size()) return false;
  const std::size_t n = a.size();
  const auto found = std::find(a.begin(), a.end(), b.front());
  if (found == a.end()) return false;
  const auto start = static_cast<std::size_t>(found - a.begin());
  bool forward = true, backward = true;
  for (std::size_t k = 0; k < n; ++k) {
    forward = forward && a[(start + k) % n] == b[k];
    backward = backward && a[(start + n - k) % n] == b[k];
  }
  return forward || backward;
}

std::vector<int> face_vertices(const Mesh& mesh) {
  std::vector<int> vertices = mesh.face_vertices;
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

class SymmetryFinder {
 public:
  explicit SymmetryFinder(const Mesh& mesh)
      : mesh_(mesh),
        adjacency_(build_adjacency(mesh)),
        edge_(mean_edge_length(mesh)),
        grid_(mesh, face_vertices(mesh), edge_ > 0.0 ? edge_ : 1.0) {
    if (grid_.vertices().empty()) return;
    const Positions used = mesh.positions(Eigen::all, grid_.vertices());
    box_ = 0.5 * (used.rowwise().minCoeff() + used.rowwise().maxCoeff());
    mean_ = box_ + (used.colwise() - box_).rowwise().mean();  // far from the origin digits count
  }

  /// The middle that a motion keeps: of the box where it turns a coordinate round, else the mean.
  [[nodiscard]] Eigen::Vector3d centre_of(const std::vector<Eigen::Matrix3d>& turns) const {
    Eigen::Vector3d centre = mean_;
    for (int c = 0; c < 3; ++c) {
      const bool flips = std::any_of(turns.begin(), turns.end(),
                                     [&](const auto& turn) { return turn(c, c) == -1.0; });
      if (flips) centre[c] = box_[c];
      // The centre goes through 0 where it nearly does: mirrored coordinates then only change their
      // sign.
      if (std::abs(centre[c]) <= kSymmetric * edge_) centre[c] = 0.0;
    }
    return centre;
  }
  [[nodiscard]] Eigen::Vector3d centre_of(const SymmetryElement& element) const {
    const bool flips = element.order % 2 == 0;  // half a turn, or a mirror
    return flips ? box_ : mean_;
  }

  /// The image of every vertex, or the sentence that says why there is none.
  [[nodiscard]] std::variant<std::vector<int>, std::string> images(
      const SymmetryElement& element) const {
    const Eigen::Matrix3d turn = turn_of(element);
    const Eigen::Vector3d centre = centre_of(element);
    std::vector<int> image(at(mesh_.vertex_count()));
    for (int v = 0; v < mesh_.vertex_count(); ++v) image[at(v)] = v;
    std::vector<char> taken(image.size(), 0);
    for (const int v : grid_.vertices()) {
      const auto found =
          grid_.nearest(moved_by(turn, centre, mesh_.positions.col(v)), kSymmetryReach * edge_);
      if (found.vertex < 0 || taken[at(found.vertex)] != 0) return worst(element, turn, centre);
      image[at(v)] = found.vertex;
      taken[at(found.vertex)] = 1;
    }
    if (auto problem = find_broken_face(element, image)) return std::move(*problem);
    return image;
  }

  /// Whether there is such a motion that moves anything: all points of a flat mesh lie on its
  /// plane.
  [[nodiscard]] bool has(const SymmetryElement& element) const {
    const Eigen::Matrix3d turn = turn_of(element);
    const Eigen::Vector3d centre = centre_of(element);
    const auto& vertices = grid_.vertices();
    bool moves = false;
    for (const int v : vertices) {
      const Eigen::Vector3d image = moved_by(turn, centre, mesh_.positions.col(v));
      const int found = grid_.nearest(image, kSymmetryReach * edge_).vertex;
      if (found < 0) return false;
      moves = moves || found != v;
    }
    return moves && std::holds_alternative<std::vector<int>>(images(element));
  }

  [[nodiscard]] bool is_empty() const { return grid_.vertices().empty() || !(edge_ > 0.0); }

 private:
  /// What to say of a symmetry that the points do not have.
  [[nodiscard]] std::string worst(const SymmetryElement& element, const Eigen::Matrix3d& turn,
                                  const Eigen::Vector3d& centre) const {
    constexpr double kLooked = 2.0;  // mean edges
    const std::string name = "symmetry: the mesh does not have " + symmetry_text(element) + ": ";
    int worst = -1;
    double distance = 0.0;
    for (const int v : grid_.vertices()) {
      const Eigen::Vector3d image = moved_by(turn, centre, mesh_.positions.col(v));
      const auto found = grid_.nearest(image, kLooked * edge_);
      if (found.vertex < 0) {
        return name + "no vertex is within two mean edges (" + three_digits(kLooked * edge_) +
               ") of the image of vertex " + std::to_string(v);
      }
      if (found.distance > distance) {
        worst = v;
        distance = found.distance;
      }
    }
    if (distance <= kSymmetryReach * edge_) return name + "two vertices have one image";
    return name + "the image of vertex " + std::to_string(worst) + " is " + three_digits(distance) +
           " away from the nearest vertex; " + three_digits(kSymmetryReach * edge_) + " is allowed";
  }

  [[nodiscard]] Refusal find_broken_face(const SymmetryElement& element,
                                         const std::vector<int>& image) const {
    std::vector<int> moved;
    for (int f = 0; f < mesh_.face_count(); ++f) {
      moved.clear();
      for (const int v : mesh_.face(f)) moved.push_back(image[at(v)]);
      const auto around = adjacency_.faces[moved.front()];
      const bool found = std::any_of(around.begin(), around.end(), [&](int other) {
        return is_same_cycle(mesh_.face(other), moved);
      });
      if (found) continue;
      return "symmetry: the mesh does not have " + symmetry_text(element) +
             ": its points do, but face " + std::to_string(f) + " has no image";
    }
    return std::nullopt;
  }

  const Mesh& mesh_;
  Adjacency adjacency_;
  double edge_;
  PointGrid grid_;
  Eigen::Vector3d box_ = Eigen::Vector3d::Zero();   ///< middle of the box
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();  ///< of the points
};

/// What `auto` asks for: see StatedSymmetry.
std::vector<SymmetryElement> all_of(const SymmetryFinder& finder) {
  std::vector<SymmetryElement> elements;
  for (int axis = 0; axis < 3; ++axis) {
    if (finder.has({axis, 0})) elements.push_back({axis, 0});
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int order = kMostFolds; order >= 2; --order) {
      if (!finder.has({axis, order})) continue;
      elements.push_back({axis, order});
      break;
    }
  }
  return elements;
}

SymmetryOperation after(const SymmetryOperation& first, const SymmetryOperation& then) {
  SymmetryOperation both{then.turn * first.turn, first.image};
  for (int& v : both.image) v = then.image[at(v)];
  return both;
}

/// Everything that `makers` make one after the other; false where that is too much, or where two
/// ways to one motion end at different vertices.
bool close_group(const std::vector<SymmetryOperation>& makers,
                 std::vector<SymmetryOperation>& group) {
  constexpr double kSame = 1e-9;
  for (std::size_t k = 0; k < group.size(); ++k) {
    for (const SymmetryOperation& maker : makers) {
      SymmetryOperation next = after(group[k], maker);
      const auto known = std::find_if(group.begin(), group.end(), [&](const auto& one) {
        return (one.turn - next.turn).cwiseAbs().maxCoeff() < kSame;
      });
      if (known != group.end()) {
        if (known->image != next.image) return false;
        continue;
      }
      if (group.size() >= at(kMostImages)) return false;
      group.push_back(std::move(next));
    }
  }
  return true;
}

}  // namespace

Eigen::Vector3d MeshSymmetry::moved(std::size_t k, const Eigen::Vector3d& point) const {
  return moved_by(operations[k].turn, centre, point);
}

std::variant<MeshSymmetry, std::string> find_symmetry(const Mesh& mesh,
                                                      const StatedSymmetry& stated) {
  MeshSymmetry symmetry;
  SymmetryOperation identity;
  for (int v = 0; v < mesh.vertex_count(); ++v) identity.image.push_back(v);
  symmetry.operations.push_back(std::move(identity));
  const SymmetryFinder finder(mesh);
  if (finder.is_empty()) {
    if (stated.elements.empty()) return symmetry;
    return "symmetry: the mesh has no faces";
  }
  symmetry.elements = stated.automatic ? all_of(finder) : stated.elements;
  std::vector<SymmetryOperation> makers;
  for (const SymmetryElement& element : symmetry.elements) {
    auto found = finder.images(element);
    if (auto* problem = std::get_if<std::string>(&found)) return std::move(*problem);
    makers.push_back({turn_of(element), std::move(std::get<std::vector<int>>(found))});
  }
  if (!close_group(makers, symmetry.operations)) {
    return "symmetry: together these make more than " + std::to_string(kMostImages) +
           " images of a point, or more than one at a place";
  }
  std::vector<Eigen::Matrix3d> turns;
  for (const SymmetryOperation& one : symmetry.operations) turns.push_back(one.turn);
  symmetry.centre = finder.centre_of(turns);
  return symmetry;
}

}  // namespace planish
