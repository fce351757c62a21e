// SPDX-License-Identifier: MIT
#include "edit_terms.hpp"

#include <algorithm>

#include "planish/index.hpp"

namespace planish {
namespace {

/// t of [SHP-3]: what the barrier costs where a corner has lost half of its size is then far below
/// the price of a moved vertex.
constexpr double kShapeWeight = 1e-2;

/// What every vertex has that is neither a handle nor a pin.
VertexTerm default_term(const HandleEditOptions& options) {
  VertexTerm term;
  if (options.sparsity == Sparsity::kL21) term.norm_weight = options.locality;
  if (options.sparsity == Sparsity::kL2) term.square_weight = options.locality;
  return term;
}

}  // namespace

void EditTerms::fill(const HandleEditOptions& options, EditProblem& problem) {
  const VertexTerm term = default_term(options);
  problem.sparse = term.norm_weight > 0.0;
  problem.shape_weight = options.keep_shape ? kShapeWeight : 0.0;
  problem.terms.assign(at(problem.model->vertex_count()), term);
  overridden_.clear();
}

void EditTerms::assign(const EditTargets& targets, const HandleEditOptions& options,
                       EditProblem& problem) {
  const VertexTerm rest = default_term(options);
  for (const int v : overridden_) problem.terms[at(v)] = rest;
  overridden_.clear();
  problem.handles.clear();
  const MeshModel& model = *problem.model;
  for (const Handle& handle : targets.handles) {
    VertexTerm term;
    term.square_weight = options.attraction;
    term.target = (handle.target - model.mesh.positions.col(handle.vertex)) / model.unit();
    term.handle = true;
    term.fixed = options.hard_handles;
    problem.terms[at(handle.vertex)] = term;
    overridden_.push_back(handle.vertex);
    problem.handles.push_back(handle.vertex);
  }
  std::sort(problem.handles.begin(), problem.handles.end());
  for (const int v : targets.pins) {
    VertexTerm term;
    term.fixed = true;
    problem.terms[at(v)] = term;
    overridden_.push_back(v);
  }
}

}  // namespace planish
