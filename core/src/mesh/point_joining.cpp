// SPDX-License-Identifier: MIT
#include "planish/mesh/point_joining.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "planish/mesh/mesh_repair.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

using Cell = std::array<double, 3>;

/// The kept points by the cell of a grid that they are in.
class PointGrid {
 public:
  explicit PointGrid(double size) : size_(size) {}

  void add(const Eigen::Vector3d& at, int number) { cells_[cell_of(at)].push_back(number); }

  /// Calls `visit` for each number in the cells around `at`.
  template <class Visit>
  void visit_near(const Eigen::Vector3d& at, Visit visit) const {
    const Cell centre = cell_of(at);
    for (int k = 0; k < 27; ++k) {
      const std::array<int, 3> step = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
      const auto found =
          cells_.find({centre[0] + step[0], centre[1] + step[1], centre[2] + step[2]});
      if (found == cells_.end()) continue;
      for (const int number : found->second) visit(number);
    }
  }

 private:
  /// Adding 0 makes −0 and 0 one cell.
  [[nodiscard]] Cell cell_of(const Eigen::Vector3d& at) const {
    if (size_ == 0) return {at.x() + 0.0, at.y() + 0.0, at.z() + 0.0};
    return {std::floor(at.x() / size_), std::floor(at.y() / size_), std::floor(at.z() / size_)};
  }

  double size_;
  std::map<Cell, std::vector<int>> cells_;
};

/// `within`, or 0 where coordinates are too large to tell cells of that size apart.
double usable_reach(const Positions& positions, double within) {
  const double largest = positions.cwiseAbs().maxCoeff();
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  return within > 2 * kRounding * largest ? within : 0.0;
}

JoinedPoints all_apart(Eigen::Index count) {
  JoinedPoints joined;
  for (int v = 0; v < count; ++v) {
    joined.target.push_back(v);
    joined.kept.push_back(v);
  }
  return joined;
}

/// The number of the kept point at exactly this place; −1 for none.
int same_place(const std::map<Cell, int>& places, const Eigen::Vector3d& at) {
  const auto found = places.find({at.x() + 0.0, at.y() + 0.0, at.z() + 0.0});
  return found == places.end() ? -1 : found->second;
}

/// The shortest of the sides longer than `least`; infinite without any.
double shortest_side(const Mesh& mesh, double least) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      const double side = (mesh.positions.col(a) - mesh.positions.col(b)).norm();
      if (side > least) shortest = std::min(shortest, side);
    }
  }
  return shortest;
}

}  // namespace

JoinedPoints find_joined_points(const Positions& positions, double within) {
  if (positions.cols() == 0 || !positions.allFinite()) return all_apart(positions.cols());
  const double reach = usable_reach(positions, within);
  JoinedPoints joined;
  std::map<Cell, int> places;
  PointGrid grid(reach);
  for (int v = 0; v < positions.cols(); ++v) {
    const Eigen::Vector3d at = positions.col(v);
    int target = same_place(places, at);
    double nearest = target < 0 ? reach : 0.0;
    if (target < 0 && reach > 0) {
      grid.visit_near(at, [&](int number) {
        const int point = joined.kept[static_cast<std::size_t>(number)];
        const double distance = (positions.col(point) - at).norm();
        const bool nearer = distance < nearest || (distance == nearest && target < 0) ||
                            (distance == nearest && number < target);
        if (!nearer) return;
        nearest = distance;
        target = number;
      });
    }
    if (target >= 0) {
      joined.largest = std::max(joined.largest, nearest);
    } else {
      target = static_cast<int>(joined.kept.size());
      joined.kept.push_back(v);
      places[{at.x() + 0.0, at.y() + 0.0, at.z() + 0.0}] = target;
      if (reach > 0) grid.add(at, target);
    }
    joined.target.push_back(target);
  }
  return joined;
}

Mesh with_joined_points(Mesh mesh, const JoinedPoints& joined) {
  if (joined.joined() == 0) return mesh;
  mesh.positions = Positions(mesh.positions(Eigen::all, joined.kept));
  for (int& v : mesh.face_vertices) v = joined.target[static_cast<std::size_t>(v)];
  return mesh;
}

std::string joined_text(const JoinedPoints& joined) {
  return count_text(joined.joined(), "vertex was", "vertices were") +
         " joined with another one at the same place" +
         (joined.largest > 0 ? ", up to " + number_text(joined.largest) + " away" : "");
}

double safe_joining(const Mesh& mesh, double within) {
  return std::min(within, shortest_side(mesh, within) / 10);
}

double usual_joining(const Mesh& mesh) {
  constexpr double kUsual = 1e-6;
  const auto& points = mesh.positions;
  const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
  return safe_joining(mesh, kUsual * size);
}

ReadResult join_points(const Mesh& mesh, std::optional<double> within) {
  const double shortest = shortest_side(mesh, 0.0);
  if (within && (!(*within >= 0) || *within >= shortest / 2)) {
    return ReadError{"points can be joined within less than half the shortest side, which is " +
                     number_text(shortest) + " long"};
  }
  const JoinedPoints joined =
      find_joined_points(mesh.positions, within ? *within : usual_joining(mesh));
  ReadResult result = repair_and_check(with_joined_points(mesh, joined));
  if (auto* error = std::get_if<ReadError>(&result)) {
    error->message = "once its points are joined, " + error->message;
  } else if (joined.joined() > 0) {
    auto& warnings = std::get<MeshFile>(result).warnings;
    warnings.insert(warnings.begin(), joined_text(joined));
  }
  return result;
}

}  // namespace planish
