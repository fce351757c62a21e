// SPDX-License-Identifier: MIT
#include "planish/comparison/edit_measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "planish/measures/metrics.hpp"

namespace planish::comparison {
namespace {

constexpr double kVisible = 1e-3;  ///< of the largest pull

/// Twice the area vector of a face, whichever its size.
Eigen::Vector3d face_normal(const Positions& positions, std::span<const int> face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Eigen::Vector3d a = positions.col(face[k]);
    const Eigen::Vector3d b = positions.col(face[(k + 1) % face.size()]);
    sum += (a - positions.col(face[0])).cross(b - positions.col(face[0]));
  }
  return sum.normalized();
}

double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Largest relative change of length, and of the angle across, over all edges.
void measure_edges(const Mesh& mesh, const Positions& after, EditMeasure& out) {
  std::map<std::pair<int, int>, int> first_face;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k];
      const int b = face[(k + 1) % face.size()];
      const double before = (mesh.positions.col(a) - mesh.positions.col(b)).norm();
      const double now = (after.col(a) - after.col(b)).norm();
      if (before > 0.0) out.edge_strain = std::max(out.edge_strain, std::abs(now / before - 1.0));
      const auto [entry, fresh] = first_face.try_emplace(std::minmax(a, b), f);
      if (fresh) continue;
      const int other = entry->second;
      const auto across = [&](const Positions& p) {
        return angle(face_normal(p, mesh.face(other)), face_normal(p, face));
      };
      const double change = std::abs(across(after) - across(mesh.positions));
      out.fold_change = std::max(out.fold_change, change * 180.0 / std::acos(-1.0));
    }
  }
}

}  // namespace

EditMeasure measure(const EditTask& task, const Positions& positions) {
  EditMeasure result;
  const MeshModel model(task.mesh, task.options.fairness);
  const double visible = kVisible * farthest_handle(task.targets.handles, task.mesh.positions);
  const Positions d = (positions - task.mesh.positions) / model.unit();
  for (int v = 0; v < model.vertex_count(); ++v) {
    result.displacement += d.col(v).norm();
    if (model.unit() * d.col(v).norm() > visible) ++result.moved_visibly;
  }
  result.moved = moved_vertex_count(task.mesh.positions, positions);
  result.planarity = planarity_summary(task.mesh, positions).max;
  double attraction = 0.0;
  for (const Handle& handle : task.targets.handles) {
    const double error = (positions.col(handle.vertex) - handle.target).norm();
    result.handle_error = std::max(result.handle_error, error);
    attraction += std::pow(error / model.unit(), 2);
    result.displacement -= d.col(handle.vertex).norm();
  }
  for (int r = 0; r < model.fairness.rows(); ++r) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (FairnessOperator::InnerIterator entry(model.fairness, r); entry; ++entry) {
      sum += entry.value() * d.col(entry.col());
    }
    result.fairness += sum.squaredNorm();
  }
  result.objective =
      0.5 * (task.options.attraction * attraction + task.options.locality * result.displacement +
             task.options.smoothness * result.fairness);
  measure_edges(task.mesh, positions, result);
  return result;
}

}  // namespace planish::comparison
