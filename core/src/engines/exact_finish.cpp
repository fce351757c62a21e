// SPDX-License-Identifier: MIT
#include "engines/exact_finish.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engines/constraint_correction.hpp"
#include "engines/limit_correction.hpp"
#include "planish/constraints/elements.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr int kMostPasses = 8;

/// A correction moves points of the support that have nothing to do by up to 1e-12 mean edges;
/// moves that an edit wants are above 1e-9.
constexpr double kNoMove = 1e-11;

/// The largest move that is rounding, mean edges: four steps of the largest coordinate, or more.
double largest_rounding(const MeshModel& model) {
  constexpr double kSteps = 4.0 * std::numeric_limits<double>::epsilon();
  const double largest = model.mesh.positions.cwiseAbs().maxCoeff();
  return std::max(kNoMove, kSteps * largest / model.unit());
}

/// Where a held handle is: a keep-out may have come to hold it since the last step, and a step ends
/// near a surface.
Eigen::Vector3d held_place(const EditProblem& problem, int vertex, const DisplacementField& field) {
  const VertexTerm& term = problem.terms[at(vertex)];
  if (term.fixed) return term.target;
  Eigen::Vector3d d = field.displacement(vertex);
  if (problem.slides == nullptr) return d;
  if (problem.slides->has_rests()) d = problem.slides->nearest(vertex, d);
  return problem.slides->has_feet() ? problem.slides->on_surface(vertex, d) : d;
}

}  // namespace

ExactFinish::ExactFinish(const MeshModel& model)
    : model_(model),
      cutter_(model),
      grower_(model),
      rounding_(largest_rounding(model)),
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
      patch_.displacement.col(k) = held_place(problem, v, field);
    }
  }
  Eigen::Matrix3Xd displacement(3, patch_.free_count);
  for (int k = 0; k < patch_.free_count; ++k) {
    displacement.col(k) = field.displacement(patch_.vertices[at(k)]);
  }
  put_on_tracks(patch_, displacement);
  ExactDesign design;
  (void)correct_constraints(patch_, kMostPasses, displacement, design.cost.factorizations);
  const bool limited =
      problem.limits != nullptr || !patch_.inequalities.of<StraightBound>().empty();
  if (limited && breaks_limits(patch_, displacement)) {
    // A handle that stays where a step led it may be what is beyond a limit.
    if (hold_handles) return attempt(problem, support, field, false);
    correct_limits(patch_, displacement, design.cost.factorizations);
    (void)correct_constraints(patch_, kMostPasses, displacement, design.cost.factorizations);
  }
  std::vector<std::pair<int, Eigen::Vector3d>> moved;
  for (int k = 0; k < patch_.free_count; ++k) {
    if (!displacement.col(k).isZero(0.0))
      moved.emplace_back(patch_.vertices[at(k)], displacement.col(k));
  }
  for (const int v : held) {
    const Eigen::Vector3d d = held_place(problem, v, field);
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

ExactDesign ExactFinish::measured(std::vector<int> vertices, Positions positions) {
  ExactDesign design;
  design.vertices = std::move(vertices);
  design.positions = std::move(positions);
  const Positions base = model_.mesh.positions(Eigen::all, design.vertices);
  design.displacement = (design.positions - base) / model_.unit();
  measure(design);
  return design;
}

void ExactFinish::measure(ExactDesign& design) {
  ++stamp_;
  for (std::size_t k = 0; k < design.vertices.size(); ++k) {
    local_of_[at(design.vertices[k])] = static_cast<int>(k);
  }
  for (const int v : design.vertices) {
    for (const int f : model_.adjacency.faces[v]) {
      if (face_mark_[at(f)] == stamp_) continue;
      face_mark_[at(f)] = stamp_;
      design.faces.push_back(f);
      measure_element(Element::kFace, f, model_.face(f), design);
    }
  }
  std::sort(design.faces.begin(), design.faces.end());
  if (model_.kept.has_element(Element::kVertex)) find_stars(design);
  for (const int v : design.vertices) local_of_[at(v)] = -1;
}

/// The stars that a moved vertex is part of, measured.
void ExactFinish::find_stars(ExactDesign& design) {
  design.stars = grower_.neighbourhood(design.vertices);
  MeshElements elements(model_.mesh, model_.adjacency);
  for (const int v : design.stars) {
    measure_element(Element::kVertex, v, elements.of(Element::kVertex, v), design);
  }
}

/// Raises the worst of each kept kind that hangs on such elements to that of one of them.
void ExactFinish::measure_element(Element element, int index, std::span<const int> vertices,
                                  ExactDesign& design) {
  corners_.resize(3, static_cast<Eigen::Index>(vertices.size()));
  order_.resize(vertices.size());
  for (std::size_t c = 0; c < vertices.size(); ++c) {
    const int local = local_of_[at(vertices[c])];
    order_[c] = static_cast<int>(c);
    if (local >= 0) {
      corners_.col(order_[c]) = design.positions.col(local);
    } else {
      corners_.col(order_[c]) = model_.mesh.positions.col(vertices[c]);
    }
  }
  model_.kept.for_each([&](auto tag, std::size_t kind) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kElement != element) return;
    design.worst[kind].raise_to(model_.violation<Kind>(index, corners_, order_));
  });
}

ExactDesign ExactFinish::finish(const EditProblem& problem, std::span<const int> support,
                                const DisplacementField& field, const KeptKinds& kept) {
  constexpr int kMostRings = 3;
  ExactDesign best = attempt(problem, support, field, true);
  SolveCost cost = best.cost;
  std::vector<int> wider(support.begin(), support.end());
  for (int ring = 0; ring <= kMostRings && !is_within(best.worst, kept); ++ring) {
    if (ring > 0) wider = grower_.grow(wider, 1);
    ExactDesign next = attempt(problem, wider, field, ring > 0 && ring < kMostRings);
    cost += next.cost;
    if (strain(next.worst, kept) < strain(best.worst, kept) ||
        std::isnan(strain(best.worst, kept))) {
      best = std::move(next);
    }
  }
  best.cost = cost;
  return is_within(best.worst, kept) ? without_rounding(std::move(best), problem, kept)
                                     : std::move(best);
}

ExactDesign ExactFinish::without_rounding(ExactDesign design, const EditProblem& problem,
                                          const KeptKinds& kept) {
  std::vector<Eigen::Index> moves;
  ExactDesign rest;
  for (std::size_t k = 0; k < design.vertices.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const int v = design.vertices[k];
    const bool told = problem.terms[at(v)].fixed;
    if (!told && design.displacement.col(column).norm() <= rounding_) continue;
    moves.push_back(column);
    rest.vertices.push_back(v);
  }
  if (rest.vertices.size() == design.vertices.size()) return design;
  rest.displacement = design.displacement(Eigen::all, moves);
  rest.positions = design.positions(Eigen::all, moves);
  rest.cost = design.cost;
  measure(rest);
  return is_within(rest.worst, kept) ? rest : design;
}

Eigen::Matrix3Xd displacement_on(const Patch& patch, const ExactDesign& design) {
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, patch.free_count);
  for (int k = 0; k < patch.free_count; ++k) {
    const auto found =
        std::lower_bound(design.vertices.begin(), design.vertices.end(), patch.vertices[at(k)]);
    if (found == design.vertices.end() || *found != patch.vertices[at(k)]) continue;
    result.col(k) = design.displacement.col(found - design.vertices.begin());
  }
  return result;
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
