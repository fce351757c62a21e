// SPDX-License-Identifier: MIT
#include "engines/edit_splitting.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engines/coupling_graph.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Residual of a row, and its gradient into the second argument, 3 × arity.
using RowAt = std::function<double(const Eigen::Matrix3Xd&, Eigen::Matrix3Xd&)>;

/// Moves `points` to the nearest that keep a row, by Newton's method: each step is the nearest
/// point of the plane that touches the row at the last one.
void move_to_nearest(const RowAt& row_at, Eigen::Matrix3Xd& points) {
  constexpr int kMostSteps = 20;
  constexpr double kSettled = 1e-13;
  const Eigen::Matrix3Xd from = points;
  Eigen::Matrix3Xd slope(3, points.cols());
  for (int step = 0; step < kMostSteps; ++step) {
    const double here = row_at(points, slope);
    const double miss = here + slope.cwiseProduct(from - points).sum();
    const Eigen::Matrix3Xd next = from - (miss / slope.squaredNorm()) * slope;
    const double moved = (next - points).norm();
    points = std::isfinite(moved) ? next : from;
    if (!(moved > kSettled)) break;
  }
}

}  // namespace

EditSplitting::EditSplitting(Patch& patch) : patch_(patch), blocks_(patch.faces) {
  add_row_blocks();
  const auto corners = static_cast<Eigen::Index>(blocks_.values.size());
  const int n = patch.free_count;
  analysed_.analyze(graph(), 1);
  rows_ = std::max(1.0, static_cast<double>(3 * (n + corners)));
  normals_.assign(at(patch.faces.size()), Eigen::Vector3d::Zero());
  y_ = patch.displacement.leftCols(n);
  y_multiplier_.setZero(3, n);
  mapped_.resize(3, corners);
  corner_work_.resize(3, corners);
  apply_map(patch.displacement, mapped_);
  z_ = mapped_;
  z_multiplier_.setZero(3, corners);
  right_.resize(3, n);
  previous_.resize(3, patch.local_count());
  change_.resize(3, corners);
  halo_fairness_.setZero(3, n);
  patch.for_each_fairness_row([&](const FairnessRow& row) {
    const auto fixed_part = [&](int v) -> Eigen::Vector3d {
      if (v < n) return Eigen::Vector3d::Zero();
      return patch.displacement.col(v);
    };
    const Eigen::Vector3d halo = row.sum(fixed_part);
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      const int v = row.vertices[k];
      if (v < n) halo_fairness_.col(v) -= patch.fairness_weight * row.weights[k] * halo;
    }
  });
}

/// Flatness has its faces; every row of another kind is a block of its own.
void EditSplitting::add_row_blocks() {
  for_each_row_beside_planarity([&](const auto& row) {
    blocks_.values.insert(blocks_.values.end(), row.vertices.begin(), row.vertices.end());
    blocks_.offsets.push_back(static_cast<int>(blocks_.values.size()));
  });
}

/// The pattern of AᵀA + EᵀE on the free vertices.
RaggedRows EditSplitting::graph() const {
  Cliques cliques;
  for (int f = 0; f < blocks_.size(); ++f) {
    const auto block = blocks_[f];
    if (!is_large(f)) {
      cliques.add(block);
      continue;
    }
    for (const int v : block) cliques.add(v, block.back());
  }
  for (int r = 0; r < patch_.fairness_vertices.size(); ++r)
    cliques.add(patch_.fairness_vertices[r]);
  return cliques.graph(patch_.free_count);
}

/// μ (I + MᵀM) + ω_f EᵀE, (17).
void EditSplitting::assemble(double penalty, SparseCholesky& factor) const {
  const int n = patch_.free_count;
  factor.set_zero();
  std::vector<double>& values = factor.values();
  const auto add = [&](int row, int column, double value) {
    if (row >= n || column >= n || factor.position(row) < factor.position(column)) return;
    values[static_cast<std::size_t>(factor.slot(row, column).offset)] += value;
  };
  for (int v = 0; v < n; ++v) add(v, v, penalty);
  for (int f = 0; f < blocks_.size(); ++f) {
    const auto face = blocks_[f];
    const double size = static_cast<double>(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (is_large(f)) {
        if (k + 1 == face.size()) continue;
        add(face[k], face[k], penalty);
        add(face.back(), face.back(), penalty);
        add(face[k], face.back(), -penalty);
        add(face.back(), face[k], -penalty);
        continue;
      }
      for (std::size_t l = 0; l < face.size(); ++l) {
        add(face[k], face[l], penalty * ((k == l ? 1.0 : 0.0) - 1.0 / size));
      }
    }
  }
  patch_.for_each_fairness_row([&](const FairnessRow& row) {
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      for (std::size_t l = 0; l < row.vertices.size(); ++l) {
        add(row.vertices[k], row.vertices[l],
            patch_.fairness_weight * row.weights[k] * row.weights[l]);
      }
    }
  });
}

bool EditSplitting::set_penalty(double penalty) {
  penalty_ = penalty;
  auto found = factors_.find(penalty);
  if (found == factors_.end()) {
    found = factors_.emplace(penalty, analysed_).first;
    assemble(penalty, found->second);
    if (!found->second.factorize()) return false;
  }
  factor_ = &found->second;
  return true;
}

/// M(p + d): each block's corners less their mean (or less the last corner).
void EditSplitting::apply_map(const Positions& displacement, Positions& out) const {
  for (int f = 0; f < blocks_.size(); ++f) {
    const auto face = blocks_[f];
    const Eigen::Index begin = blocks_.offsets[at(f)];
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Eigen::Vector3d here = patch_.points.col(face[k]) + displacement.col(face[k]);
      out.col(begin + static_cast<Eigen::Index>(k)) = here;
      origin += here;
    }
    origin /= static_cast<double>(face.size());
    if (is_large(f)) origin = out.col(begin + static_cast<Eigen::Index>(face.size()) - 1);
    for (std::size_t k = 0; k < face.size(); ++k) {
      out.col(begin + static_cast<Eigen::Index>(k)) -= origin;
    }
  }
}

/// out += Mᵀ corners, on the free vertices.
void EditSplitting::add_transposed_map(const Positions& corners, Positions& out) const {
  const int n = patch_.free_count;
  for (int f = 0; f < blocks_.size(); ++f) {
    const auto face = blocks_[f];
    const Eigen::Index begin = blocks_.offsets[at(f)];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < face.size(); ++k) {
      sum += corners.col(begin + static_cast<Eigen::Index>(k));
    }
    const Eigen::Vector3d mean = sum / static_cast<double>(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (face[k] >= n) continue;
      out.col(face[k]) += corners.col(begin + static_cast<Eigen::Index>(k));
      if (!is_large(f)) out.col(face[k]) -= mean;
    }
    if (is_large(f) && face.back() < n) out.col(face.back()) -= sum;
  }
}

/// (13) and (14).
void EditSplitting::shrink_vertices() {
  for (int v = 0; v < patch_.free_count; ++v) {
    const VertexTerm& term = patch_.terms[at(v)];
    const Eigen::Vector3d a = patch_.displacement.col(v) - y_multiplier_.col(v) / penalty_;
    // min q/2 ‖y − target‖² + w/2 ‖y‖ + μ/2 ‖y − a‖²: blend first, then shrink.
    const double total = term.square_weight + penalty_;
    const Eigen::Vector3d blend = (term.square_weight * term.target + penalty_ * a) / total;
    const double threshold = 0.5 * term.norm_weight / total;
    const double length = blend.norm();
    if (length <= threshold) {
      y_.col(v).setZero();
    } else {
      y_.col(v) = (1.0 - threshold / length) * blend;
    }
  }
}

/// (15) and (16).
void EditSplitting::project_faces() {
  for (int f = 0; f < patch_.faces.size(); ++f) {
    const Eigen::Index begin = blocks_.offsets[at(f)];
    const auto size = static_cast<Eigen::Index>(blocks_[f].size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (Eigen::Index k = begin; k < begin + size; ++k) {
      const Eigen::Vector3d c = mapped_.col(k) - z_multiplier_.col(k) / penalty_;
      z_.col(k) = c;
      covariance.noalias() += c * c.transpose();
    }
    normals_[at(f)] = smallest_direction(covariance, normals_[at(f)]);
    const Eigen::Vector3d& normal = normals_[at(f)];
    for (Eigen::Index k = begin; k < begin + size; ++k) z_.col(k) -= normal * normal.dot(z_.col(k));
  }
}

/// The same for the other rows: z − (M(p + d) − λ/μ) along the row's gradient at z, and c(z) = 0.
void EditSplitting::project_rows() {
  int block = patch_.faces.size();
  Eigen::Matrix3Xd points;
  for_each_row_beside_planarity([&]<class Row>(const Row& row) {
    const Eigen::Index begin = blocks_.offsets[at(block++)];
    points = mapped_.middleCols(begin, Row::kArity) -
             z_multiplier_.middleCols(begin, Row::kArity) / penalty_;
    const auto row_at = [&row](const Eigen::Matrix3Xd& here, Eigen::Matrix3Xd& slope) {
      const RowPoints<Row::kArity> fixed = here;
      slope = gradient(row, fixed);
      return residual(row, fixed);
    };
    move_to_nearest(row_at, points);
    z_.middleCols(begin, Row::kArity) = points;
  });
}

void EditSplitting::update_auxiliaries() {
  shrink_vertices();
  project_faces();
  project_rows();
}

void EditSplitting::update_primal() {
  const int n = patch_.free_count;
  previous_ = patch_.displacement;
  // M d = M(p + d) − M p, and the halo's displacement is constant: solve for the free part of
  // μ AᵀA d = μ Aᵀ(x − b + λ/μ) − ω_f EᵀE (halo), with b = M(p + halo).
  previous_.leftCols(n).setZero();
  apply_map(previous_, corner_work_);
  corner_work_ = penalty_ * (z_ - corner_work_) + z_multiplier_;
  right_ = penalty_ * y_ + y_multiplier_ + halo_fairness_;
  add_transposed_map(corner_work_, right_);
  factor_->solve_coordinates(right_);
  const double vertex_change = (right_ - patch_.displacement.leftCols(n)).squaredNorm();
  patch_.displacement.leftCols(n) = right_;
  change_ = mapped_;
  apply_map(patch_.displacement, mapped_);
  change_ -= mapped_;
  dual_residual_ = penalty_ * std::sqrt((vertex_change + change_.squaredNorm()) / rows_);
}

double EditSplitting::update_multipliers() {
  const auto d = patch_.displacement.leftCols(patch_.free_count);
  y_multiplier_ += penalty_ * (y_ - d);
  z_multiplier_ += penalty_ * (z_ - mapped_);
  return std::sqrt(((y_ - d).squaredNorm() + (z_ - mapped_).squaredNorm()) / rows_);
}

double EditSplitting::objective() const { return planish::objective(patch_).total(); }

std::vector<int> EditSplitting::support() const {
  std::vector<int> result;
  for (int v = 0; v < patch_.free_count; ++v) {
    if (patch_.terms[at(v)].handle || !y_.col(v).isZero(0.0)) result.push_back(v);
  }
  return result;
}

}  // namespace planish
