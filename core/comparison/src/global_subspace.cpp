// SPDX-License-Identifier: MIT
#include "planish/comparison/global_subspace.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>

#include "held_boundary.hpp"
#include "tangent_space.hpp"

namespace planish::comparison {
namespace {

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

/// Smooth, linearly independent starts: products of powers of the coordinates, on each axis.
Eigen::MatrixXd starts(const Patch& patch, Eigen::Index count) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(3 * patch.free_count, count);
  const double size = patch.points.cwiseAbs().maxCoeff();
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto power = static_cast<int>(j / 3);
    for (int v = 0; v < patch.free_count; ++v) {
      const Eigen::Vector3d p = patch.points.col(v) / size;
      columns(3 * v + j % 3, j) = std::pow(p.x(), power % 3) * std::pow(p.y(), power / 3);
    }
  }
  return columns;
}

}  // namespace

Eigen::MatrixXd global_subspace(const Mesh& flat, int dimension, FairnessKind fairness) {
  constexpr int kSweeps = 40;
  constexpr int kSpare = 6;
  const EditTask task = with_held_boundary({.mesh = flat, .targets = {}, .options = {}});
  const MeshModel model(flat, fairness);
  const EditProblem problem = pose(task, model, false);
  const Patch patch = cut_all(problem);
  const TangentSpace space(patch);
  const Eigen::Index count =
      std::min<Eigen::Index>(dimension + kSpare, static_cast<Eigen::Index>(3) * patch.free_count);
  Eigen::MatrixXd t = starts(patch, count);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (Eigen::Index j = 0; j < count; ++j) t.col(j) = space.solve(t.col(j));
    t = orthonormal(t);
  }
  Eigen::MatrixXd image(t.rows(), count);
  for (Eigen::Index j = 0; j < count; ++j) image.col(j) = space.stiffness(t.col(j));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> reduced(
      Eigen::MatrixXd(t.transpose() * image));
  t = (t * reduced.eigenvectors().leftCols(std::min<Eigen::Index>(dimension, count))).eval();
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3) * flat.vertex_count(), t.cols());
  for (int k = 0; k < patch.free_count; ++k) {
    result.middleRows<3>(3 * patch.vertices[static_cast<std::size_t>(k)]) = t.middleRows<3>(3 * k);
  }
  return result;
}

}  // namespace planish::comparison
