// SPDX-License-Identifier: MIT
#include "planish/problem/edit_freedom.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <utility>

#include "planish/constraints/elements.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Gradients are pure numbers of size 1; what a rank counts must stand out of their rounding.
constexpr double kRankThreshold = 1e-8;
/// Multiplications of the factorization: about a second in a browser.
constexpr double kMostWork = 2e9;
/// Forces below this share of the largest are rounding.
constexpr double kLeastShare = 1e-6;

/// Faces that use a vertex of `free`, ascending.
std::vector<int> faces_around(const Adjacency& adjacency, std::span<const int> free) {
  std::vector<int> faces;
  for (const int v : free) {
    faces.insert(faces.end(), adjacency.faces[v].begin(), adjacency.faces[v].end());
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// Vertices of `free` and their neighbours, ascending.
std::vector<int> stars_around(const Adjacency& adjacency, std::span<const int> free) {
  std::vector<int> stars(free.begin(), free.end());
  for (const int v : free) {
    stars.insert(stars.end(), adjacency.neighbours[v].begin(), adjacency.neighbours[v].end());
  }
  std::sort(stars.begin(), stars.end());
  stars.erase(std::unique(stars.begin(), stars.end()), stars.end());
  return stars;
}

/// The place of a vertex in `free`, or −1.
Eigen::Index place(std::span<const int> free, int vertex) {
  const auto found = std::lower_bound(free.begin(), free.end(), vertex);
  return found != free.end() && *found == vertex ? found - free.begin() : -1;
}

/// The equations of some faces, and their derivatives by the free points.
struct Linearised {
  std::vector<int> faces;  ///< of each equation; −1 where it hangs on none
  Eigen::MatrixXd slopes;  ///< 3·free × equations: the transposed Jacobian
};

Linearised linearise(const Mesh& mesh, const Adjacency& adjacency, const Positions& positions,
                     const std::vector<int>& faces, std::span<const int> free,
                     const KeptKinds& kept) {
  Linearised result;
  ConstraintRows equations;
  MeshElements elements(mesh, adjacency);
  const std::vector<int> stars = stars_around(adjacency, free);
  kept.for_each([&](auto tag, std::size_t) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kElement == Element::kFace) {
      for (const int f : faces) {
        Kind::append_rows(positions, mesh.face(f), equations.of<Kind>());
        result.faces.resize(equations.size(), f);
      }
    } else {
      for (const int v : stars) {
        Kind::append_rows(positions, elements.of(Kind::kElement, v), equations.of<Kind>());
      }
      result.faces.resize(equations.size(), -1);
    }
  });
  const auto rows = 3 * static_cast<Eigen::Index>(free.size());
  result.slopes.setZero(rows, static_cast<Eigen::Index>(equations.size()));
  equations.for_each([&]<class Row>(int e, const Row& equation) {
    RowPoints<Row::kArity> corners;
    for (int k = 0; k < Row::kArity; ++k) corners.col(k) = positions.col(equation.vertices[at(k)]);
    const RowPoints<Row::kArity> slope = gradient(equation, corners);
    for (int k = 0; k < Row::kArity; ++k) {
      const Eigen::Index row = place(free, equation.vertices[at(k)]);
      if (row >= 0) result.slopes.col(e).segment<3>(3 * row) += slope.col(k);
    }
  });
  return result;
}

/// The force of every panel, largest first. @param forces one multiplier per equation
std::vector<HoldingPanel> by_panel(const Linearised& system, const Eigen::VectorXd& forces,
                                   double pull) {
  std::vector<HoldingPanel> panels;
  for (Eigen::Index e = 0; e < forces.size(); ++e) {
    if (system.faces[at(e)] < 0) continue;
    const double share = std::abs(forces[e]) * system.slopes.col(e).norm() / pull;
    if (panels.empty() || panels.back().face != system.faces[at(e)]) {
      panels.push_back({system.faces[at(e)], 0.0});
    }
    panels.back().share += share;
  }
  const auto stronger = [](const auto& a, const auto& b) { return a.share > b.share; };
  std::stable_sort(panels.begin(), panels.end(), stronger);
  const double least = panels.empty() ? 0.0 : kLeastShare * panels.front().share;
  std::erase_if(panels, [&](const HoldingPanel& p) { return !(p.share > least); });
  return panels;
}

}  // namespace

std::optional<EditFreedom> measure_freedom(const Mesh& mesh, const Adjacency& adjacency,
                                           const Positions& positions, std::span<const int> free,
                                           std::span<const Pull> pulls, const KeptKinds& kept) {
  const std::vector<int> faces = faces_around(adjacency, free);
  double equations = 0.0;
  kept.for_each([&](auto, std::size_t) {
    for (const int f : faces) equations += static_cast<double>(mesh.face(f).size() - 3);
  });
  const double rows = 3.0 * static_cast<double>(free.size());
  if (2.0 * rows * equations * std::min(rows, equations) > kMostWork) return std::nullopt;

  const Linearised system = linearise(mesh, adjacency, positions, faces, free, kept);
  EditFreedom result;
  result.points = static_cast<int>(free.size());
  result.equations = static_cast<int>(system.slopes.cols());
  if (system.slopes.size() == 0) return result;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(system.slopes.rows(), system.slopes.cols());
  factor.setThreshold(kRankThreshold);
  factor.compute(system.slopes);
  result.rank = static_cast<int>(factor.rank());

  Eigen::VectorXd pull = Eigen::VectorXd::Zero(system.slopes.rows());
  for (const Pull& one : pulls) {
    const Eigen::Index row = place(free, one.vertex);
    if (row >= 0) pull.segment<3>(3 * row) += one.rest;
  }
  const double size = pull.norm();
  if (!(size > 0.0)) return result;
  const Eigen::VectorXd forces = factor.solve(pull);
  result.borne = (system.slopes * forces).norm() / size;
  result.holding = by_panel(system, forces, size);
  return result;
}

}  // namespace planish
