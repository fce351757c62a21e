// SPDX-License-Identifier: MIT
#include "edit/edit_terms.hpp"

#include <algorithm>
#include <utility>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// What every vertex has that may move and is no handle.
VertexTerm free_term(const HandleEditOptions& options, const EditWeights& weights) {
  VertexTerm term;
  if (options.sparsity == Sparsity::kL21) term.norm_weight = weights.locality;
  if (options.sparsity == Sparsity::kL2) term.square_weight = weights.locality;
  return term;
}

VertexTerm fixed_term() {
  VertexTerm term;
  term.fixed = true;
  return term;
}

/// What a vertex has before any handle or pin is known.
VertexTerm default_term(int vertex, const VertexTerm& rest, const HandleEditOptions& options,
                        const MeshModel& model) {
  const bool kept = options.keep_boundary && model.adjacency.boundary[at(vertex)] != 0;
  return kept || has_reach(options) ? fixed_term() : rest;
}

}  // namespace

void EditTerms::fill(const HandleEditOptions& options, EditProblem& problem) {
  rest_ = free_term(options, edit_weights(options, 0.0, problem.model->unit()));
  problem.seeks_support = rest_.norm_weight > 0.0;
  problem.shape_weight = options.keep_shape ? kShapeWeight : 0.0;
  problem.limits_straight_corners = options.keep_shape;
  const bool were_fixed = std::exchange(all_fixed_, has_reach(options));
  if (were_fixed && all_fixed_) return;
  const int count = problem.model->vertex_count();
  problem.terms.resize(at(count));
  for (int v = 0; v < count; ++v) {
    problem.terms[at(v)] = default_term(v, rest_, options, *problem.model);
  }
  overridden_.clear();
}

void EditTerms::override_term(int vertex, const VertexTerm& term, EditProblem& problem) {
  problem.terms[at(vertex)] = term;
  overridden_.push_back(vertex);
}

/// Frees what is within the reach and not kept.
void EditTerms::open_reach(const EditTargets& targets, const HandleEditOptions& options,
                           EditProblem& problem) {
  problem.region.clear();
  if (!has_reach(options)) return;
  rest_ = free_term(options, edit_weights(options, 0.0, problem.model->unit()));
  problem.region = reach_.within(targets.handles, options);
  std::sort(problem.region.begin(), problem.region.end());
  const std::vector<char>& boundary = problem.model->adjacency.boundary;
  for (const int v : problem.region) {
    if (!options.keep_boundary || !boundary[at(v)]) override_term(v, rest_, problem);
  }
}

/// Once for the same supports: the boundary's points cost O(n).
void EditTerms::list_springs(const std::vector<PointSupport>& supports, const Mesh& mesh) {
  if (supports == supports_) return;
  supports_ = supports;
  springs_.clear();
  for (const PointSupport& support : supports) {
    if (!is_spring(support)) continue;
    for (const int v : points_of(support, mesh)) springs_.emplace_back(v, support.numbers.front());
  }
}

/// A stiff spring holds by the square of the way: a larger norm weight would stretch the unit that
/// residuals are measured in. A soft one makes the first step cheaper. [SUP-5]
void EditTerms::add_springs(const EditWeights& weights, EditProblem& problem) {
  const double unit = weights.locality + weights.smoothness;
  for (const auto& [v, stiffness] : springs_) {
    VertexTerm term = problem.terms[at(v)];
    if (term.fixed) continue;
    term.norm_weight *= std::min(stiffness, 1.0);
    term.square_weight += std::max(stiffness - 1.0, 0.0) * unit;
    override_term(v, term, problem);
  }
}

void EditTerms::add_handles(const EditTargets& targets, const EditWeights& weights, bool hard,
                            EditProblem& problem) {
  const MeshModel& model = *problem.model;
  problem.fairness_weight = weights.smoothness;
  problem.handles.clear();
  for (const Handle& handle : targets.handles) {
    VertexTerm term;
    term.square_weight = weights.attraction;
    term.target = (handle.target - model.mesh.positions.col(handle.vertex)) / model.unit();
    term.handle = true;
    term.fixed = hard;
    override_term(handle.vertex, term, problem);
    problem.handles.push_back(handle.vertex);
  }
  std::sort(problem.handles.begin(), problem.handles.end());
}

void EditTerms::assign(const EditTargets& targets, const HandleEditOptions& options,
                       EditProblem& problem) {
  for (const int v : overridden_) {
    problem.terms[at(v)] = default_term(v, rest_, options, *problem.model);
  }
  overridden_.clear();
  open_reach(targets, options, problem);
  const MeshModel& model = *problem.model;
  const double farthest = farthest_handle(targets.handles, model.mesh.positions) / model.unit();
  const EditWeights weights = edit_weights(options, farthest, model.unit());
  list_springs(targets.supports, model.mesh);
  add_springs(weights, problem);
  add_handles(targets, weights, options.hard_handles, problem);
  for (const int v : targets.pins) override_term(v, fixed_term(), problem);
}

}  // namespace planish
