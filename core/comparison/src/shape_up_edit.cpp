// SPDX-License-Identifier: MIT
#include <Eigen/SparseCholesky>

#include "held_boundary.hpp"
#include "planish/comparison/methods.hpp"
#include "planish/numeric/index.hpp"

namespace planish::comparison {
namespace {

/// μ MᵀM + ω_f EᵀE + ω_h D on the free vertices; one factor for x, y and z.
class GlobalStep {
 public:
  GlobalStep(const Patch& patch, double planarity);

  /// Least squares for the projected corners `z`, each face's relative to its mean.
  void solve(const Positions& z, Patch& patch) const;

 private:
  const Patch& patch_;
  double planarity_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Positions fixed_;  ///< right-hand side of handles and of the halo's fairness, 3 × free
};

GlobalStep::GlobalStep(const Patch& patch, double planarity)
    : patch_(patch), planarity_(planarity), fixed_(Positions::Zero(3, patch.free_count)) {
  const int n = patch.free_count;
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < n; ++v) {
    const VertexTerm& term = patch.terms[at(v)];
    entries.emplace_back(v, v, term.square_weight + 1e-12);
    fixed_.col(v) += term.square_weight * term.target;
  }
  for (int f = 0; f < patch.faces.size(); ++f) {
    const auto face = patch.faces[f];
    const double share = 1.0 / static_cast<double>(face.size());
    for (const int v : face) {
      for (const int w : face) {
        if (v < n && w < n) entries.emplace_back(v, w, planarity * ((v == w ? 1.0 : 0.0) - share));
      }
    }
  }
  patch.for_each_fairness_row([&](const FairnessRow& row) {
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      const int v = row.vertices[k];
      if (v >= n) continue;
      for (std::size_t l = 0; l < row.vertices.size(); ++l) {
        const int w = row.vertices[l];
        const double value = patch.fairness_weight * row.weights[k] * row.weights[l];
        if (w < n) {
          entries.emplace_back(v, w, value);
        } else {
          fixed_.col(v) -= value * patch.displacement.col(w);
        }
      }
    }
  });
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(matrix);
}

void GlobalStep::solve(const Positions& z, Patch& patch) const {
  Positions right = fixed_;
  for (int f = 0; f < patch_.faces.size(); ++f) {
    const auto face = patch_.faces[f];
    const Eigen::Index begin = patch_.faces.offsets[at(f)];
    // Mᵀ(z − M p) with the undisplaced p and the halo's displacement: z minus both, centred.
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> corners;
    for (std::size_t k = 0; k < face.size(); ++k) {
      Eigen::Vector3d corner =
          z.col(begin + static_cast<Eigen::Index>(k)) - patch_.points.col(face[k]);
      if (face[k] >= patch_.free_count) corner -= patch_.displacement.col(face[k]);
      corners.push_back(corner);
      mean += corner / static_cast<double>(face.size());
    }
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (face[k] < patch_.free_count) right.col(face[k]) += planarity_ * (corners[k] - mean);
    }
  }
  patch.displacement.leftCols(patch.free_count) = factor_.solve(right.transpose()).transpose();
}

/// Each face's corners, centred and projected onto their plane.
void project_faces(const Patch& patch, std::vector<Eigen::Vector3d>& normals, Positions& z) {
  for (int f = 0; f < patch.faces.size(); ++f) {
    const auto face = patch.faces[f];
    const Eigen::Index begin = patch.faces.offsets[at(f)];
    const auto size = static_cast<Eigen::Index>(face.size());
    for (Eigen::Index k = 0; k < size; ++k) {
      const int v = face[static_cast<std::size_t>(k)];
      z.col(begin + k) = patch.points.col(v) + patch.displacement.col(v);
    }
    project_to_plane_centred(z.middleCols(begin, size), normals[at(f)]);
  }
}

}  // namespace

ComparedEdit edit_by_shape_up(const EditTask& task) {
  constexpr int kMostSteps = 2000;
  constexpr double kSettled = 1e-7;  // mean edges
  const EditTask held = with_held_boundary(task);
  const MeshModel model(held.mesh, held.options.fairness);
  const EditProblem problem = pose(held, model, false);
  Patch patch = cut_all(problem);
  const GlobalStep global(patch, held.options.attraction);
  Positions z(3, static_cast<Eigen::Index>(patch.faces.values.size()));
  std::vector<Eigen::Vector3d> normals(at(patch.faces.size()), Eigen::Vector3d::Zero());
  ComparedEdit result;
  while (result.steps < kMostSteps && !result.finished) {
    const Positions before = patch.displacement;
    project_faces(patch, normals, z);
    global.solve(z, patch);
    ++result.steps;
    result.finished = (patch.displacement - before).cwiseAbs().maxCoeff() <= kSettled;
  }
  result.positions = displaced(model, patch);
  return result;
}

}  // namespace planish::comparison
