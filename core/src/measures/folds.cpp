// SPDX-License-Identifier: MIT
#include "planish/measures/folds.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>

#include "numeric/trigonometry.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// One side of one face.
struct Side {
  int low = 0, high = 0;  ///< vertices of the edge
  std::size_t panel = 0;  ///< place of the face in the list of panels
  bool forward = false;   ///< the face runs from low to high

  friend bool operator<(const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.panel) < std::tie(b.low, b.high, b.panel);
  }
};

/// The normal, of length 1, or 0 for a panel without area.
Eigen::Vector3d normal_of(const Positions& positions, std::span<const int> face) {
  return area_vector(positions, face).stableNormalized();
}

/// The sides of all panels, by edge.
std::vector<Side> sides_of(const Mesh& mesh, std::span<const int> panels) {
  std::vector<Side> sides;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const auto face = mesh.face(panels[p]);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k];
      const int b = face[(k + 1) % face.size()];
      sides.push_back({std::min(a, b), std::max(a, b), p, a < b});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  if (a.isZero(0.0) || b.isZero(0.0)) return 0.0;
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / kPi;
}

using FoldVisit = std::function<void(double degrees, std::size_t p, std::size_t q)>;

/// Calls visit(degrees, p, q) for each two of `panels`, by place, that share an edge with no third.
void for_each_fold(const Mesh& mesh, const Positions& positions, std::span<const int> panels,
                   const FoldVisit& visit) {
  Positions normals(3, static_cast<Eigen::Index>(panels.size()));
  for (std::size_t p = 0; p < panels.size(); ++p) {
    normals.col(static_cast<Eigen::Index>(p)) = normal_of(positions, mesh.face(panels[p]));
  }
  const std::vector<Side> sides = sides_of(mesh, panels);
  for (std::size_t k = 0, end = 0; k < sides.size(); k = end) {
    const Side& first = sides[k];
    while (end < sides.size() && sides[end].low == first.low && sides[end].high == first.high) {
      ++end;
    }
    const Side& second = sides[end - 1];
    if (end - k != 2) continue;
    const Eigen::Vector3d here = normals.col(static_cast<Eigen::Index>(first.panel));
    Eigen::Vector3d there = normals.col(static_cast<Eigen::Index>(second.panel));
    if (first.forward == second.forward) there = -there;  // the two are not oriented alike
    visit(degrees_between(here, there), first.panel, second.panel);
  }
}

}  // namespace

std::vector<int> faces_of(const Adjacency& adjacency, std::span<const int> vertices) {
  std::vector<int> faces;
  for (const int v : vertices) {
    const auto around = adjacency.faces[v];
    faces.insert(faces.end(), around.begin(), around.end());
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

namespace {

/// `faces` and their neighbours, ascending.
std::vector<int> with_neighbours(const Mesh& mesh, const Adjacency& adjacency,
                                 std::span<const int> faces) {
  std::vector<int> corners;
  for (const int f : faces) {
    const auto face = mesh.face(f);
    corners.insert(corners.end(), face.begin(), face.end());
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return faces_of(adjacency, corners);
}

}  // namespace

Fold sharpest_fold(const Mesh& mesh, const Adjacency& adjacency, const Positions& positions,
                   std::span<const int> faces) {
  const std::vector<int> panels = with_neighbours(mesh, adjacency, faces);
  const auto asked = [&](std::size_t panel) {
    return std::binary_search(faces.begin(), faces.end(), panels[panel]);
  };
  Fold sharpest;
  for_each_fold(mesh, positions, panels, [&](double degrees, std::size_t p, std::size_t q) {
    if (degrees > sharpest.degrees && (asked(p) || asked(q))) {
      sharpest = {degrees, panels[p], panels[q]};
    }
  });
  return sharpest;
}

double largest_fold_growth(const Mesh& mesh, const Adjacency& adjacency, const Positions& before,
                           const Positions& after, std::span<const int> faces) {
  const std::vector<int> panels = with_neighbours(mesh, adjacency, faces);
  std::vector<double> folds;
  for_each_fold(mesh, before, panels,
                [&](double degrees, std::size_t, std::size_t) { folds.push_back(degrees); });
  std::size_t fold = 0;
  double growth = 0.0;
  for_each_fold(mesh, after, panels, [&](double degrees, std::size_t, std::size_t) {
    growth = std::max(growth, degrees - folds[fold++]);
  });
  return growth;
}

std::vector<double> face_folds(const Mesh& mesh, const Positions& positions) {
  std::vector<int> panels(static_cast<std::size_t>(mesh.face_count()));
  std::iota(panels.begin(), panels.end(), 0);
  std::vector<double> folds(panels.size(), 0.0);
  for_each_fold(mesh, positions, panels, [&](double degrees, std::size_t p, std::size_t q) {
    folds[p] = std::max(folds[p], degrees);
    folds[q] = std::max(folds[q], degrees);
  });
  return folds;
}

}  // namespace planish
