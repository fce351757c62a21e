// SPDX-License-Identifier: MIT
#include "planish/engines/exact_finish.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planish/engines/constraint_correction.hpp"
#include "planish/index.hpp"
#include "planish/metrics.hpp"

namespace planish {
namespace {

constexpr int kMostPasses = 8;

}  // namespace

ExactFinish::ExactFinish(const MeshModel& model)
    : model_(model),
      cutter_(model.vertex_count(), model.mesh.face_count(),
              static_cast<int>(model.fairness.rows())),
      grower_(model),
      local_of_(at(model.vertex_count()), -1),
      face_mark_(at(model.mesh.face_count()), 0) {}

ExactDesign ExactFinish::attempt(const EditProblem& problem, std::span<const int> support,
                                 const DisplacementField& field, bool hold_handles) {
  std::vector<int> free;
  std::vector<int> held;
  for (const int v : support) {
    const VertexTerm& term = problem.terms[at(v)];
    (term.fixed || (hold_handles && term.handle) ? held : free).push_back(v);
  }
  cutter_.cut(problem, free, patch_);
  for (int k = patch_.free_count; k < patch_.local_count(); ++k) {
    const int v = patch_.vertices[at(k)];
    if (std::binary_search(held.begin(), held.end(), v) && !problem.terms[at(v)].fixed) {
      patch_.displacement.col(k) = field.displacement(v);
    }
  }
  Eigen::Matrix3Xd displacement(3, patch_.free_count);
  for (int k = 0; k < patch_.free_count; ++k) {
    displacement.col(k) = field.displacement(patch_.vertices[at(k)]);
  }
  ExactDesign design;
  (void)correct_constraints(patch_, kMostPasses, displacement, design.factorizations);
  std::vector<std::pair<int, Eigen::Vector3d>> moved;
  for (int k = 0; k < patch_.free_count; ++k) {
    if (!displacement.col(k).isZero(0.0))
      moved.emplace_back(patch_.vertices[at(k)], displacement.col(k));
  }
  for (const int v : held) {
    const VertexTerm& term = problem.terms[at(v)];
    const Eigen::Vector3d d = term.fixed ? term.target : field.displacement(v);
    if (!d.isZero(0.0)) moved.emplace_back(v, d);
  }
  std::sort(moved.begin(), moved.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  design.displacement.resize(3, static_cast<Eigen::Index>(moved.size()));
  for (std::size_t k = 0; k < moved.size(); ++k) {
    design.vertices.push_back(moved[k].first);
    design.displacement.col(static_cast<Eigen::Index>(k)) = moved[k].second;
  }
  design.positions.resize(3, design.displacement.cols());
  for (std::size_t k = 0; k < moved.size(); ++k) {
    design.positions.col(static_cast<Eigen::Index>(k)) =
        model_.mesh.positions.col(design.vertices[k]) + model_.unit() * moved[k].second;
  }
  measure(design);
  return design;
}

void ExactFinish::measure(ExactDesign& design) {
  ++stamp_;
  for (std::size_t k = 0; k < design.vertices.size(); ++k) {
    local_of_[at(design.vertices[k])] = static_cast<int>(k);
  }
  Positions corners;
  std::vector<int> order;
  for (const int v : design.vertices) {
    for (const int f : model_.adjacency.faces[v]) {
      if (face_mark_[at(f)] == stamp_) continue;
      face_mark_[at(f)] = stamp_;
      design.faces.push_back(f);
      const auto face = model_.face(f);
      corners.resize(3, static_cast<Eigen::Index>(face.size()));
      order.resize(face.size());
      for (std::size_t c = 0; c < face.size(); ++c) {
        const int local = local_of_[at(face[c])];
        order[c] = static_cast<int>(c);
        if (local >= 0) {
          corners.col(static_cast<Eigen::Index>(c)) = design.positions.col(local);
        } else {
          corners.col(static_cast<Eigen::Index>(c)) = model_.mesh.positions.col(face[c]);
        }
      }
      const FacePlanarity flatness = face_planarity(corners, order);
      // Negated, so that a NaN is the worst of all.
      if (!(flatness.mm_per_m <= design.worst_mm_per_m)) design.worst_mm_per_m = flatness.mm_per_m;
      if (!(flatness.excess <= design.worst_excess)) design.worst_excess = flatness.excess;
    }
  }
  std::sort(design.faces.begin(), design.faces.end());
  for (const int v : design.vertices) local_of_[at(v)] = -1;
}

ExactDesign ExactFinish::finish(const EditProblem& problem, std::span<const int> support,
                                const DisplacementField& field, double tolerance) {
  constexpr int kMostRings = 3;
  ExactDesign best = attempt(problem, support, field, true);
  int factorizations = best.factorizations;
  std::vector<int> wider(support.begin(), support.end());
  for (int ring = 0; ring <= kMostRings && !(best.worst_excess <= tolerance); ++ring) {
    if (ring > 0) wider = grower_.grow(wider, 1);
    ExactDesign next = attempt(problem, wider, field, ring > 0 && ring < kMostRings);
    factorizations += next.factorizations;
    if (next.worst_mm_per_m < best.worst_mm_per_m || std::isnan(best.worst_mm_per_m)) {
      best = std::move(next);
    }
  }
  best.factorizations = factorizations;
  return best;
}

ObjectiveTerms design_objective(const EditProblem& problem, const ExactDesign& design,
                                PatchCutter& cutter) {
  Patch patch;
  // Handles that did not move still have their term.
  std::vector<int> free = design.vertices;
  for (const int v : problem.handles) free.push_back(v);
  std::sort(free.begin(), free.end());
  free.erase(std::unique(free.begin(), free.end()), free.end());
  cutter.cut(problem, free, patch);
  for (int k = 0; k < patch.local_count(); ++k) {
    const auto found =
        std::lower_bound(design.vertices.begin(), design.vertices.end(), patch.vertices[at(k)]);
    if (found == design.vertices.end() || *found != patch.vertices[at(k)]) continue;
    patch.displacement.col(k) = design.displacement.col(found - design.vertices.begin());
  }
  return objective(patch);
}

}  // namespace planish
