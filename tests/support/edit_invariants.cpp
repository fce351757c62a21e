// SPDX-License-Identifier: MIT
#include "support/edit_invariants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"
#include "support/singular_values.hpp"

namespace planish::testing {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

double longest_edge(const Positions& positions, std::span<const int> face) {
  double longest = 0.0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Eigen::Vector3d edge =
        positions.col(face[(k + 1) % face.size()]) - positions.col(face[k]);
    longest = std::max(longest, edge.norm());
  }
  return longest;
}

bool same_point(const Positions& a, const Positions& b, int vertex) {
  return same_bits(Positions(a.col(vertex)), Positions(b.col(vertex)));
}

/// `after` differs from `before` exactly at `moved`, which ascends.
AssertionResult moves_exactly(const Positions& before, const Positions& after,
                              const std::vector<int>& moved) {
  if (!after.allFinite()) return AssertionFailure() << "positions are not finite";
  std::vector<int> differing;
  for (int v = 0; v < static_cast<int>(before.cols()); ++v) {
    if (!same_point(before, after, v)) differing.push_back(v);
  }
  if (differing == moved) return AssertionSuccess();
  return AssertionFailure() << "the list names " << moved.size() << " moved vertices, "
                            << differing.size() << " differ";
}

/// No face is worse than both the worst one before and its own promise, and where the status claims
/// flat panels, none than its promise.
AssertionResult is_flat_enough(const Mesh& mesh, const Positions& after,
                               const SolveReport& report) {
  double worst = 0.0, slack = 0.0;
  std::optional<double> before;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const double here = svd_mm_per_m(after, mesh.face(f));
    const double promise = flatness_promise(after, mesh.face(f));
    if (!(here <= promise)) {
      if (report.usable()) {
        return AssertionFailure() << "called " << status_name(report.status) << " with face " << f
                                  << " at " << here << " mm/m";
      }
      if (!before) before = worst_svd_mm_per_m(mesh, mesh.positions);
      if (!(here <= *before)) {
        return AssertionFailure() << "face " << f << " is worse than before: " << *before << " -> "
                                  << here << " mm/m, " << status_name(report.status);
      }
    }
    if (here > worst) worst = here, slack = promise;
  }
  if (!(std::abs(report.planarity_after - worst) <= 1e-3 * worst + slack + 1e-9)) {
    return AssertionFailure() << "reported " << report.planarity_after << " mm/m, measured "
                              << worst;
  }
  return AssertionSuccess();
}

AssertionResult reports_moves(const Positions& before, const Positions& after,
                              const std::vector<int>& moved, const SolveReport& report) {
  if (report.moved_vertices != static_cast<int>(moved.size())) {
    return AssertionFailure() << "reported " << report.moved_vertices << " moved vertices of "
                              << moved.size();
  }
  double largest = 0.0;
  for (const int v : moved) largest = std::max(largest, (after.col(v) - before.col(v)).norm());
  if (std::abs(largest - report.max_displacement) > 1e-9 * largest) {
    return AssertionFailure() << "reported a largest move of " << report.max_displacement
                              << ", measured " << largest;
  }
  return AssertionSuccess();
}

}  // namespace

double svd_mm_per_m(const Positions& positions, std::span<const int> face) {
  if (face.size() < 4) return 0.0;
  const double longest = longest_edge(positions, face);
  if (!(longest > 0.0)) return 0.0;
  Positions points(3, static_cast<Eigen::Index>(face.size()));
  for (std::size_t k = 0; k < face.size(); ++k) {
    points.col(static_cast<Eigen::Index>(k)) =
        (positions.col(face[k]) - positions.col(face[0])) / longest;
  }
  const Eigen::Vector3d mean = points.rowwise().mean();
  points.colwise() -= mean;
  const auto svd = singular_values(points, Eigen::ComputeThinU);
  const Eigen::RowVectorXd distances = svd.matrixU().col(2).transpose() * points;
  return 1000.0 * (distances.maxCoeff() - distances.minCoeff());
}

double worst_svd_mm_per_m(const Mesh& mesh, const Positions& positions) {
  double worst = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const double here = svd_mm_per_m(positions, mesh.face(f));
    if (!(here <= worst)) worst = here;
  }
  return worst;
}

double flatness_promise(const Positions& positions, std::span<const int> face) {
  constexpr double kCoarsest = 1e-3;  // mm/m
  double largest = 0.0;
  for (const int v : face) largest = std::max(largest, positions.col(v).cwiseAbs().maxCoeff());
  const double step = std::numeric_limits<double>::epsilon() * largest;
  const double rounding = 1000.0 * 8.0 * step / longest_edge(positions, face);
  return std::max(kPromise, std::min(kCoarsest, rounding));
}

Positions apply(const Mesh& mesh, const ProjectionResult& result) {
  Positions positions = mesh.positions;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    positions.col(result.moved[k]) = result.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  return positions;
}

AssertionResult is_valid_edit(const Mesh& mesh, const EditTargets& targets,
                              const HandleEditResult& result) {
  const Positions after = planish::apply(mesh, result);
  if (AssertionResult r = moves_exactly(mesh.positions, after, result.moved); !r) return r;
  if (AssertionResult r = is_flat_enough(mesh, after, result.report); !r) return r;
  if (AssertionResult r = reports_moves(mesh.positions, after, result.moved, result.report); !r) {
    return r;
  }
  for (const int pin : targets.pins) {
    if (!same_point(mesh.positions, after, pin))
      return AssertionFailure() << "pin " << pin << " moved";
  }
  double error = 0.0;
  for (const Handle& handle : targets.handles) {
    error = std::max(error, (after.col(handle.vertex) - handle.target).norm());
  }
  const double size = mesh.positions.cwiseAbs().maxCoeff();
  if (std::abs(error - result.report.handle_error) > 1e-9 * error + 1e-14 * size) {
    return AssertionFailure() << "reported a handle error of " << result.report.handle_error
                              << ", measured " << error;
  }
  return AssertionSuccess();
}

AssertionResult is_valid_projection(const Mesh& mesh, const std::vector<int>& pins,
                                    const ProjectionResult& result) {
  const Positions after = apply(mesh, result);
  if (AssertionResult r = moves_exactly(mesh.positions, after, result.moved); !r) return r;
  if (AssertionResult r = is_flat_enough(mesh, after, result.report); !r) return r;
  if (AssertionResult r = reports_moves(mesh.positions, after, result.moved, result.report); !r) {
    return r;
  }
  for (const int pin : pins) {
    if (!same_point(mesh.positions, after, pin))
      return AssertionFailure() << "pin " << pin << " moved";
  }
  return AssertionSuccess();
}

AssertionResult is_valid_subspace(const Positions& edited, const Subspace& subspace) {
  if (!subspace.basis.allFinite() || !subspace.scale.allFinite()) {
    return AssertionFailure() << "the basis is not finite";
  }
  if (!std::is_sorted(subspace.support.begin(), subspace.support.end())) {
    return AssertionFailure() << "the support does not ascend";
  }
  const Eigen::Index s = subspace.basis.cols();
  const Eigen::MatrixXd gram = subspace.basis.transpose() * subspace.basis;
  const double error = s > 0 ? (gram - Eigen::MatrixXd::Identity(s, s)).cwiseAbs().maxCoeff() : 0.0;
  if (error > 1e-8) return AssertionFailure() << "orthonormal only to " << error;
  Positions at_zero;
  evaluate(subspace, Eigen::VectorXd::Zero(s), at_zero);
  const Positions origin = edited(Eigen::all, subspace.support);
  if (!same_bits(at_zero, origin)) return AssertionFailure() << "coefficients 0 are not the edit";
  return AssertionSuccess();
}

}  // namespace planish::testing
