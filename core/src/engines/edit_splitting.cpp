// SPDX-License-Identifier: MIT
#include "engines/edit_splitting.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

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

EditSplitting::EditSplitting(Patch& patch, Executor* executor)
    : patch_(patch), executor_(executor), blocks_(patch.faces) {
  add_row_blocks();
  find_corners();
  const auto corners = static_cast<Eigen::Index>(blocks_.values.size());
  const int n = patch.free_count;
  analysed_.analyze(graph(), 1);
  rows_ = std::max(1.0, static_cast<double>(3 * (n + corners)));
  normals_.assign(at(patch.faces.size()), Eigen::Vector3d::Zero());
  y_ = patch.displacement.leftCols(n);
  y_multiplier_.setZero(3, n);
  mapped_.resize(3, corners);
  halo_mapped_.resize(3, corners);
  Positions halo = patch.displacement;
  halo.leftCols(n).setZero();
  for (int block = 0; block < blocks_.size(); ++block) {
    apply_map(patch.displacement, block, mapped_);
    apply_map(halo, block, halo_mapped_);
  }
  z_ = mapped_;
  z_multiplier_.setZero(3, corners);
  right_.resize(3, n);
  vertex_change_.resize(3, n);
  pull_.resize(3, corners);
  corner_change_.resize(3, corners);
  taken_.resize(3, blocks_.size());
  halo_fairness_.setZero(3, n);
  patch.for_each_fairness_row([&](const FairnessRow& row) {
    const auto fixed_part = [&](int v) -> Eigen::Vector3d {
      if (v < n) return Eigen::Vector3d::Zero();
      return patch.displacement.col(v);
    };
    const Eigen::Vector3d part = row.sum(fixed_part);
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      const int v = row.vertices[k];
      if (v < n) halo_fairness_.col(v) -= patch.fairness_weight * row.weights[k] * part;
    }
  });
}

/// Flatness has its faces; every row of another kind is a block of its own.
void EditSplitting::add_row_blocks() {
  for_each_kind_beside_planarity([&](const auto& rows) {
    for (const auto& row : rows) {
      blocks_.values.insert(blocks_.values.end(), row.vertices.begin(), row.vertices.end());
      blocks_.offsets.push_back(static_cast<int>(blocks_.values.size()));
    }
  });
}

void EditSplitting::find_corners() {
  const int n = patch_.free_count;
  corners_.offsets.assign(at(n) + 1, 0);
  for (int block = 0; block < blocks_.size(); ++block) {
    block_of_.insert(block_of_.end(), blocks_[block].size(), block);
    for (const int v : blocks_[block]) {
      if (v < n) ++corners_.offsets[at(v) + 1];
    }
  }
  std::partial_sum(corners_.offsets.begin(), corners_.offsets.end(), corners_.offsets.begin());
  corners_.values.resize(at(corners_.offsets.back()));
  std::vector<int> next = corners_.offsets;
  for (std::size_t place = 0; place < blocks_.values.size(); ++place) {
    const int v = blocks_.values[place];
    if (v < n) corners_.values[at(next[at(v)]++)] = static_cast<int>(place);
  }
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

/// M(p + d): a block's corners less their mean (or less the last corner).
void EditSplitting::apply_map(const Positions& displacement, int block, Positions& out) const {
  const auto face = blocks_[block];
  const Eigen::Index begin = blocks_.offsets[at(block)];
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Eigen::Vector3d here = patch_.points.col(face[k]) + displacement.col(face[k]);
    out.col(begin + static_cast<Eigen::Index>(k)) = here;
    origin += here;
  }
  origin /= static_cast<double>(face.size());
  if (is_large(block)) origin = out.col(begin + static_cast<Eigen::Index>(face.size()) - 1);
  for (std::size_t k = 0; k < face.size(); ++k) {
    out.col(begin + static_cast<Eigen::Index>(k)) -= origin;
  }
}

/// out += Mᵀ corners at a free vertex. Expects what each block takes off in taken_.
void EditSplitting::add_transposed_map(const Positions& corners, int vertex, Positions& out) const {
  Eigen::Vector3d sum = out.col(vertex);
  for (const int place : corners_[vertex]) {
    const int block = block_of_[at(place)];
    sum += corners.col(place);
    const bool is_last = place + 1 == blocks_.offsets[at(block) + 1];
    if (is_last || !is_large(block)) sum -= taken_.col(block);
  }
  out.col(vertex) = sum;
}

/// (13) and (14).
void EditSplitting::shrink(int vertex) {
  const VertexTerm& term = patch_.terms[at(vertex)];
  const Eigen::Vector3d a = patch_.displacement.col(vertex) - y_multiplier_.col(vertex) / penalty_;
  // min q/2 ‖y − target‖² + w/2 ‖y‖ + μ/2 ‖y − a‖²: blend first, then shrink.
  const double total = term.square_weight + penalty_;
  const Eigen::Vector3d blend = (term.square_weight * term.target + penalty_ * a) / total;
  const double threshold = 0.5 * term.norm_weight / total;
  const double length = blend.norm();
  if (length <= threshold) {
    y_.col(vertex).setZero();
  } else {
    y_.col(vertex) = (1.0 - threshold / length) * blend;
  }
}

/// z of a face, by (15) and (16).
void EditSplitting::project_face(int face) {
  const Eigen::Index begin = blocks_.offsets[at(face)];
  const auto size = static_cast<Eigen::Index>(blocks_[face].size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Eigen::Index k = begin; k < begin + size; ++k) {
    const Eigen::Vector3d c = mapped_.col(k) - z_multiplier_.col(k) / penalty_;
    z_.col(k) = c;
    covariance.noalias() += c * c.transpose();
  }
  normals_[at(face)] = smallest_direction(covariance, normals_[at(face)]);
  const Eigen::Vector3d& normal = normals_[at(face)];
  for (Eigen::Index k = begin; k < begin + size; ++k) z_.col(k) -= normal * normal.dot(z_.col(k));
}

/// z of a row that is no face: z − (M(p + d) − λ/μ) along the row's gradient at z, and c(z) = 0.
template <class Row>
void EditSplitting::project_row(const Row& row, int block) {
  const Eigen::Index begin = blocks_.offsets[at(block)];
  Eigen::Matrix3Xd points = mapped_.middleCols(begin, Row::kArity) -
                            z_multiplier_.middleCols(begin, Row::kArity) / penalty_;
  const auto row_at = [&row](const Eigen::Matrix3Xd& here, Eigen::Matrix3Xd& slope) {
    const RowPoints<Row::kArity> fixed = here;
    slope = gradient(row, fixed);
    return residual(row, fixed);
  };
  move_to_nearest(row_at, points);
  z_.middleCols(begin, Row::kArity) = points;
}

void EditSplitting::update_auxiliaries() {
  for_each(patch_.free_count, [&](int v) { shrink(v); });
  for_each(patch_.faces.size(), [&](int f) { project_face(f); });
  int first = patch_.faces.size();
  for_each_kind_beside_planarity([&](const auto& rows) {
    for_each(static_cast<int>(rows.size()), [&](int r) { project_row(rows[at(r)], first + r); });
    first += static_cast<int>(rows.size());
  });
}

/// M d = M(p + d) − M p, and the halo's displacement is constant: solves for the free part of
/// μ AᵀA d = μ Aᵀ(x − b + λ/μ) − ω_f EᵀE (halo), with b = M(p + halo).
void EditSplitting::update_primal() {
  const int n = patch_.free_count;
  for_each(blocks_.size(), [&](int block) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = blocks_.offsets[at(block)]; k < blocks_.offsets[at(block) + 1]; ++k) {
      pull_.col(k) = penalty_ * (z_.col(k) - halo_mapped_.col(k)) + z_multiplier_.col(k);
      sum += pull_.col(k);
    }
    if (!is_large(block)) sum /= static_cast<double>(blocks_[block].size());
    taken_.col(block) = sum;
  });
  for_each(n, [&](int v) {
    right_.col(v) = penalty_ * y_.col(v) + y_multiplier_.col(v) + halo_fairness_.col(v);
    add_transposed_map(pull_, v, right_);
  });
  factor_->solve_coordinates(right_, executor_);
  for_each(n, [&](int v) {
    vertex_change_.col(v) = right_.col(v) - patch_.displacement.col(v);
    patch_.displacement.col(v) = right_.col(v);
  });
  for_each(blocks_.size(), [&](int block) {
    const Eigen::Index begin = blocks_.offsets[at(block)];
    const auto size = static_cast<Eigen::Index>(blocks_[block].size());
    corner_change_.middleCols(begin, size) = mapped_.middleCols(begin, size);
    apply_map(patch_.displacement, block, mapped_);
    corner_change_.middleCols(begin, size) -= mapped_.middleCols(begin, size);
  });
  // One sum each, whatever the threads: stops must not depend on them.
  const double square = vertex_change_.squaredNorm() + corner_change_.squaredNorm();
  dual_residual_ = penalty_ * std::sqrt(square / rows_);
}

double EditSplitting::update_multipliers() {
  for_each(patch_.free_count, [&](int v) {
    vertex_change_.col(v) = y_.col(v) - patch_.displacement.col(v);
    y_multiplier_.col(v) += penalty_ * vertex_change_.col(v);
  });
  for_each(static_cast<int>(z_.cols()), [&](int k) {
    corner_change_.col(k) = z_.col(k) - mapped_.col(k);
    z_multiplier_.col(k) += penalty_ * corner_change_.col(k);
  });
  return std::sqrt((vertex_change_.squaredNorm() + corner_change_.squaredNorm()) / rows_);
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
