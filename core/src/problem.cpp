// SPDX-License-Identifier: MIT
#include "planish/problem.hpp"

#include <cassert>

#include "planish/index.hpp"

namespace planish {
MeshModel::MeshModel(const Mesh& given, FairnessKind kind)
    : mesh(given), adjacency(build_adjacency(given)) {
  const double edge = mean_edge_length(mesh);
  unit_ = edge > 0.0 ? edge : 1.0;
  // Relative to a vertex first: the mean of coordinates far from the origin loses digits.
  const Eigen::Vector3d origin =
      mesh.vertex_count() > 0 ? mesh.positions.col(0).eval() : Eigen::Vector3d::Zero().eval();
  points = mesh.positions.colwise() - origin;
  if (mesh.vertex_count() > 0) points.colwise() -= points.rowwise().mean().eval();
  points /= unit_;
  fairness = fairness_operator(mesh, adjacency, kind);
  fairness_columns = fairness.transpose();
  face_equations.assign(1, 0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    append_flatness_equations(points, mesh.face(f), equations);
    face_equations.push_back(static_cast<int>(equations.size()));
  }
}

std::span<const int> MeshModel::face(int f) const { return mesh.face(f); }

PatchCutter::PatchCutter(int vertex_count, int face_count, int fairness_rows)
    : local_of_(at(vertex_count), -1),
      face_mark_(at(face_count), 0),
      row_mark_(at(fairness_rows), 0) {}

int PatchCutter::local(int vertex, Patch& patch) {
  int& found = local_of_[at(vertex)];
  if (found < 0) {
    found = patch.local_count();
    patch.vertices.push_back(vertex);
  }
  return found;
}

void PatchCutter::cut(const EditProblem& problem, std::span<const int> free, Patch& patch) {
  const MeshModel& model = *problem.model;
  patch.vertices.clear();
  patch.equations.clear();
  patch.equation_ids.clear();
  patch.face_ids.clear();
  patch.faces.offsets.assign(1, 0);
  patch.faces.values.clear();
  patch.fairness_vertices.offsets.assign(1, 0);
  patch.fairness_vertices.values.clear();
  patch.fairness_values.clear();
  patch.fairness_weight = problem.fairness_weight;
  ++stamp_;
  for (const int v : free) {
    if (!problem.terms[at(v)].fixed) (void)local(v, patch);
  }
  patch.free_count = patch.local_count();
  for (int k = 0; k < patch.free_count; ++k) {
    const int v = patch.vertices[at(k)];
    for (const int f : model.adjacency.faces[v]) {
      if (face_mark_[at(f)] == stamp_ || model.face(f).size() < 4) continue;
      face_mark_[at(f)] = stamp_;
      patch.face_ids.push_back(f);
      for (const int w : model.face(f)) patch.faces.values.push_back(local(w, patch));
      patch.faces.offsets.push_back(static_cast<int>(patch.faces.values.size()));
      for (int e = model.face_equations[at(f)]; e < model.face_equations[at(f) + 1]; ++e) {
        FlatnessEquation equation = model.equations[at(e)];
        bool touches = false;
        for (int& w : equation.vertices) {
          w = local(w, patch);
          touches = touches || w < patch.free_count;
        }
        if (!touches) continue;
        patch.equations.push_back(equation);
        patch.equation_ids.push_back(e);
      }
    }
    if (problem.fairness_weight <= 0.0) continue;
    for (FairnessOperator::InnerIterator row(model.fairness_columns, v); row; ++row) {
      const auto r = static_cast<int>(row.col());
      if (row_mark_[at(r)] == stamp_) continue;
      row_mark_[at(r)] = stamp_;
      for (FairnessOperator::InnerIterator entry(model.fairness, r); entry; ++entry) {
        const int w = local(static_cast<int>(entry.col()), patch);
        patch.fairness_vertices.values.push_back(w);
        patch.fairness_values.push_back(entry.value());
      }
      patch.fairness_vertices.offsets.push_back(
          static_cast<int>(patch.fairness_vertices.values.size()));
    }
  }
  patch.points.resize(3, patch.local_count());
  patch.displacement.setZero(3, patch.local_count());
  patch.terms.resize(at(patch.free_count));
  for (int k = 0; k < patch.local_count(); ++k) {
    const int v = patch.vertices[at(k)];
    patch.points.col(k) = model.points.col(v);
    const VertexTerm& term = problem.terms[at(v)];
    if (k < patch.free_count) patch.terms[at(k)] = term;
    if (term.fixed) patch.displacement.col(k) = term.target;
    local_of_[at(v)] = -1;
  }
}

ObjectiveTerms objective(const Patch& patch) {
  ObjectiveTerms result;
  for (int k = 0; k < patch.free_count; ++k) {
    const VertexTerm& term = patch.terms[at(k)];
    const Eigen::Vector3d d = patch.displacement.col(k);
    const double square = 0.5 * term.square_weight * (d - term.target).squaredNorm();
    (term.handle ? result.handle : result.sparsity) += square;
    result.sparsity += 0.5 * term.norm_weight * d.norm();
  }
  for (int r = 0; r < patch.fairness_vertices.size(); ++r) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const auto begin = at(patch.fairness_vertices.offsets[at(r)]);
    const auto row = patch.fairness_vertices[r];
    for (std::size_t k = 0; k < row.size(); ++k) {
      sum += patch.fairness_values[begin + k] * patch.displacement.col(row[k]);
    }
    result.fairness += 0.5 * patch.fairness_weight * sum.squaredNorm();
  }
  return result;
}

FourPoints corners_at(const Patch& patch, const Eigen::Matrix3Xd& displacement,
                      const FlatnessEquation& equation) {
  FourPoints result;
  for (int k = 0; k < 4; ++k) {
    const int v = equation.vertices[at(k)];
    result.col(k) = patch.points.col(v);
    if (v < patch.free_count) {
      result.col(k) += displacement.col(v);
    } else {
      result.col(k) += patch.displacement.col(v);
    }
  }
  return result;
}

FourPoints corners(const Patch& patch, const FlatnessEquation& equation) {
  FourPoints result;
  for (int k = 0; k < 4; ++k) {
    const int v = equation.vertices[at(k)];
    result.col(k) = patch.points.col(v) + patch.displacement.col(v);
  }
  return result;
}

void residuals(const Patch& patch, Eigen::VectorXd& out) {
  out.resize(static_cast<Eigen::Index>(patch.equations.size()));
  for (std::size_t e = 0; e < patch.equations.size(); ++e) {
    const FourPoints points = corners(patch, patch.equations[e]);
    out[static_cast<Eigen::Index>(e)] = residual(patch.equations[e], points);
  }
}

}  // namespace planish
