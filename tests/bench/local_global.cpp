// SPDX-License-Identifier: MIT
#include "bench/local_global.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <limits>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"

namespace planish::bench {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

LocalGlobal::LocalGlobal(const Mesh& mesh, double closeness)
    : mesh_(mesh), base_(mesh.positions), positions_(mesh.positions), closeness_(closeness) {
  const int n = mesh.vertex_count();
  RaggedRows graph;
  const Adjacency adjacency = build_adjacency(mesh);
  for (int v = 0; v < n; ++v) {
    std::vector<int> near;
    for (const int f : adjacency.faces[v]) {
      for (const int w : mesh.face(f)) {
        if (w != v) near.push_back(w);
      }
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    graph.values.insert(graph.values.end(), near.begin(), near.end());
    graph.offsets.push_back(static_cast<int>(graph.values.size()));
  }
  factor_.analyze(graph, 1);
  factor_.set_zero();
  const auto add = [&](int row, int column, double value) {
    if (factor_.position(row) < factor_.position(column)) return;
    factor_.values()[static_cast<std::size_t>(factor_.slot(row, column).offset)] += value;
  };
  for (int v = 0; v < n; ++v) add(v, v, closeness);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const double share = 1.0 / static_cast<double>(face.size());
    for (const int v : face) {
      for (const int w : face) add(v, w, (v == w ? 1.0 : 0.0) - share);
    }
  }
  if (!factor_.factorize()) std::abort();
  corners_.resize(3, static_cast<Eigen::Index>(mesh.face_vertices.size()));
  normals_.assign(at(mesh.face_count()), Eigen::Vector3d::Zero());
}

/// Local step; returns the energy at `at_positions`.
double LocalGlobal::project_faces(const Positions& at_positions) {
  double energy = closeness_ * (at_positions - base_).squaredNorm();
  for (int f = 0; f < mesh_.face_count(); ++f) {
    const auto face = mesh_.face(f);
    const Eigen::Index begin = mesh_.face_offsets[at(f)];
    const auto size = static_cast<Eigen::Index>(face.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const int v : face) mean += at_positions.col(v);
    mean /= static_cast<double>(face.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (Eigen::Index k = 0; k < size; ++k) {
      corners_.col(begin + k) = at_positions.col(face[static_cast<std::size_t>(k)]) - mean;
      covariance.noalias() += corners_.col(begin + k) * corners_.col(begin + k).transpose();
    }
    normals_[at(f)] = smallest_direction(covariance, normals_[at(f)]);
    const Eigen::Vector3d& normal = normals_[at(f)];
    for (Eigen::Index k = 0; k < size; ++k) {
      const double height = normal.dot(corners_.col(begin + k));
      energy += height * height;
      corners_.col(begin + k) -= height * normal;
    }
  }
  return energy;
}

/// Global step: (MᵀM + wI) p = Mᵀz + w p⁰.
void LocalGlobal::solve_poisson(Positions& out) {
  out = closeness_ * base_;
  for (int f = 0; f < mesh_.face_count(); ++f) {
    const auto face = mesh_.face(f);
    const Eigen::Index begin = mesh_.face_offsets[at(f)];
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < face.size(); ++k) {
      mean += corners_.col(begin + static_cast<Eigen::Index>(k));
    }
    mean /= static_cast<double>(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      out.col(face[k]) += corners_.col(begin + static_cast<Eigen::Index>(k)) - mean;
    }
  }
  factor_.solve_coordinates(out);
}

/// positions_ ← G − ΔG θ with θ = argmin ‖F − ΔF θ‖, F = G(p) − p.
void LocalGlobal::accelerate(int window, const Positions& mapped) {
  const Eigen::Map<const Eigen::VectorXd> g(mapped.data(), mapped.size());
  const Eigen::Map<const Eigen::VectorXd> p(positions_.data(), positions_.size());
  const Eigen::VectorXd residual = g - p;
  if (history_ > 0) {
    const Eigen::Index column = (history_ - 1) % window;
    residual_steps_.col(column) = residual - last_residual_;
    mapped_steps_.col(column) = g - last_mapped_;
  }
  last_residual_ = residual;
  last_mapped_ = g;
  const Eigen::Index used = std::min(history_, window);
  ++history_;
  if (used == 0) {
    positions_ = mapped;
    return;
  }
  const Eigen::MatrixXd gram =
      residual_steps_.leftCols(used).transpose() * residual_steps_.leftCols(used);
  const Eigen::VectorXd theta = gram.completeOrthogonalDecomposition().solve(
      residual_steps_.leftCols(used).transpose() * residual);
  const Eigen::VectorXd next = g - mapped_steps_.leftCols(used) * theta;
  positions_ = Eigen::Map<const Positions>(next.data(), 3, mapped.cols());
}

double LocalGlobal::worst_planarity(const Positions& at_positions) const {
  double worst = 0.0;
  for (int f = 0; f < mesh_.face_count(); ++f) {
    worst = std::max(worst, face_planarity(at_positions, mesh_.face(f)).mm_per_m);
  }
  return 1e-3 * worst;
}

LocalGlobalRun LocalGlobal::run(const LocalGlobalOptions& options) {
  const std::clock_t start = std::clock();
  const auto seconds = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
  LocalGlobalRun result;
  positions_ = base_;
  residual_steps_.resize(base_.size(), options.window);
  mapped_steps_.resize(base_.size(), options.window);
  history_ = 0;
  Positions mapped = base_;
  double before = std::numeric_limits<double>::infinity();
  for (; result.iterations < options.max_iterations; ++result.iterations) {
    double energy = project_faces(positions_);
    if (options.window > 0 && energy > before) {  // the safeguard: back to the plain iterate
      positions_ = mapped;
      energy = project_faces(positions_);
      history_ = 0;
    }
    before = energy;
    // Measuring costs as much as a local step: now and then only.
    if (result.iterations % 10 == 0) {
      result.planarity = worst_planarity(positions_);
      result.reached = result.planarity <= options.planarity;
      if (result.reached || seconds() > options.max_seconds) return result;
    }
    solve_poisson(mapped);
    if (options.window > 0) {
      accelerate(options.window, mapped);
    } else {
      positions_ = mapped;
    }
  }
  return result;
}

}  // namespace planish::bench
