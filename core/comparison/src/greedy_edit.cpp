// SPDX-License-Identifier: MIT
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "engines/constraint_correction.hpp"
#include "planish/comparison/methods.hpp"
#include "planish/numeric/index.hpp"

namespace planish::comparison {
namespace {

/// J of the whole mesh, vertex by vertex: the equations that a vertex is in, and its columns.
struct VertexColumns {
  std::vector<Eigen::Index> rows;
  Eigen::Matrix3Xd gradients;  ///< 3 × |rows|
};

std::vector<VertexColumns> vertex_columns(const Patch& patch) {
  std::vector<std::vector<std::pair<Eigen::Index, Eigen::Vector3d>>> entries(
      at(patch.local_count()));
  patch.equations.for_each([&]<class Row>(int e, const Row& row) {
    RowPoints<Row::kArity> points;
    for (int k = 0; k < Row::kArity; ++k) points.col(k) = patch.points.col(row.vertices[at(k)]);
    const RowPoints<Row::kArity> slopes = gradient(row, points);
    for (int k = 0; k < Row::kArity; ++k) {
      entries[at(row.vertices[at(k)])].emplace_back(e, slopes.col(k));
    }
  });
  std::vector<VertexColumns> columns(entries.size());
  for (std::size_t v = 0; v < entries.size(); ++v) {
    columns[v].gradients.resize(3, static_cast<Eigen::Index>(entries[v].size()));
    for (std::size_t k = 0; k < entries[v].size(); ++k) {
      columns[v].rows.push_back(entries[v][k].first);
      columns[v].gradients.col(static_cast<Eigen::Index>(k)) = entries[v][k].second;
    }
  }
  return columns;
}

/// Block-orthogonal matching pursuit for J_free x = −J_handles d̃.
class Pursuit {
 public:
  explicit Pursuit(const Patch& patch);

  /// False if no vertex lowers the residual any more.
  bool add_best_vertex();
  [[nodiscard]] bool done() const { return residual_.norm() <= 1e-9 * first_; }
  [[nodiscard]] const std::vector<int>& chosen() const { return chosen_; }
  /// The shortest solution on the chosen vertices, written into the patch.
  void solve(Patch& patch) const;

 private:
  const Patch& patch_;
  std::vector<VertexColumns> columns_;
  std::vector<Eigen::Matrix3d> whitening_;  ///< (J_vᵀ J_v)^(−1/2): vertices compete on equal terms
  std::vector<char> taken_;
  std::vector<int> chosen_;
  Eigen::VectorXd right_, residual_;
  Eigen::MatrixXd range_;  ///< orthonormal basis of the chosen columns
  double first_ = 0.0;
};

Pursuit::Pursuit(const Patch& patch)
    : patch_(patch), columns_(vertex_columns(patch)), taken_(at(patch.free_count), 0) {
  const auto equations = static_cast<Eigen::Index>(patch.equations.size());
  right_.setZero(equations);
  for (int v = patch.free_count; v < patch.local_count(); ++v) {
    const VertexColumns& column = columns_[at(v)];
    for (std::size_t k = 0; k < column.rows.size(); ++k) {
      right_[column.rows[k]] -=
          column.gradients.col(static_cast<Eigen::Index>(k)).dot(patch.displacement.col(v));
    }
  }
  residual_ = right_;
  first_ = right_.norm();
  range_.resize(equations, 0);
  for (int v = 0; v < patch.free_count; ++v) {
    const Eigen::Matrix3Xd& j = columns_[at(v)].gradients;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> gram(Eigen::Matrix3d(j * j.transpose()));
    Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const double value = gram.eigenvalues()[k];
      if (value > 1e-9 * gram.eigenvalues()[2]) inverse[k] = 1.0 / std::sqrt(value);
    }
    whitening_.emplace_back(inverse.asDiagonal() * gram.eigenvectors().transpose());
  }
}

bool Pursuit::add_best_vertex() {
  int best = -1;
  double gain = 1e-12 * first_;
  for (int v = 0; v < patch_.free_count; ++v) {
    if (taken_[at(v)] != 0) continue;
    const VertexColumns& column = columns_[at(v)];
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < column.rows.size(); ++k) {
      slope += residual_[column.rows[k]] * column.gradients.col(static_cast<Eigen::Index>(k));
    }
    const double explained = (whitening_[at(v)] * slope).norm();
    if (explained > gain) {
      gain = explained;
      best = v;
    }
  }
  if (best < 0) return false;
  taken_[at(best)] = 1;
  chosen_.push_back(best);
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(residual_.size());
    const VertexColumns& entries = columns_[at(best)];
    for (std::size_t k = 0; k < entries.rows.size(); ++k) {
      column[entries.rows[k]] += entries.gradients(axis, static_cast<Eigen::Index>(k));
    }
    const double length = column.norm();
    for (int pass = 0; pass < 2; ++pass) column -= range_ * (range_.transpose() * column);
    if (column.norm() <= 1e-9 * length || length == 0.0) continue;
    range_.conservativeResize(Eigen::NoChange, range_.cols() + 1);
    range_.rightCols<1>() = column.normalized();
    residual_ -= range_.rightCols<1>() * range_.rightCols<1>().dot(residual_);
  }
  return true;
}

void Pursuit::solve(Patch& patch) const {
  if (chosen_.empty()) return;  // the pull breaks no constraint
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(right_.size(), 3 * static_cast<Eigen::Index>(chosen_.size()));
  for (std::size_t c = 0; c < chosen_.size(); ++c) {
    const VertexColumns& entries = columns_[at(chosen_[c])];
    for (std::size_t k = 0; k < entries.rows.size(); ++k) {
      columns.row(entries.rows[k]).segment<3>(3 * static_cast<Eigen::Index>(c)) +=
          entries.gradients.col(static_cast<Eigen::Index>(k)).transpose();
    }
  }
  const Eigen::VectorXd x = columns.completeOrthogonalDecomposition().solve(right_);
  for (std::size_t c = 0; c < chosen_.size(); ++c) {
    patch.displacement.col(chosen_[c]) = x.segment<3>(3 * static_cast<Eigen::Index>(c));
  }
}

}  // namespace

ComparedEdit edit_greedily(const EditTask& task) {
  constexpr int kPasses = 30;
  constexpr double kFlat = 1e-9;  // mean edges
  const MeshModel model(task.mesh, task.options.fairness);
  const EditProblem problem = pose(task, model, true);
  Patch whole = cut_all(problem);
  Pursuit pursuit(whole);
  while (!pursuit.done() && pursuit.add_best_vertex()) {
  }
  pursuit.solve(whole);
  std::vector<int> chosen;
  for (const int v : pursuit.chosen()) chosen.push_back(whole.vertices[at(v)]);
  Patch patch = cut(problem, chosen);
  Eigen::Matrix3Xd free(3, patch.free_count);
  for (int k = 0; k < patch.free_count; ++k) {
    free.col(k) = whole.displacement.col(pursuit.chosen()[at(k)]);
  }
  ComparedEdit result;
  result.steps = static_cast<int>(chosen.size());
  int passes = 0;
  result.finished = correct_constraints(patch, kPasses, free, passes) <= kFlat;
  patch.displacement.leftCols(patch.free_count) = free;
  result.positions = displaced(model, patch);
  return result;
}

}  // namespace planish::comparison
