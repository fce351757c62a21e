// SPDX-License-Identifier: MIT
#include "planish/design/design_steps.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <variant>

#include "planish/edit/symmetric_edit.hpp"
#include "planish/variations/exact_variation.hpp"

namespace planish {

SparseShape difference(const Mesh& base, const Positions& shape) {
  SparseShape difference;
  for (int v = 0; v < base.vertex_count(); ++v) {
    if (shape.col(v) != base.positions.col(v)) difference.moved.push_back(v);
  }
  difference.positions = shape(Eigen::all, difference.moved);
  return difference;
}

Eigen::VectorXd VariationFamily::sliders(const Eigen::Ref<const Eigen::VectorXd>& given) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(subspace.dimension());
  const Eigen::Index count = std::min(given.size(), values.size());
  values.head(count) = given.head(count);
  return values;
}

SparseShape VariationFamily::slide(const Eigen::Ref<const Eigen::VectorXd>& given) const {
  Positions rows;
  evaluate(subspace, sliders(given), rows);
  SparseShape shape{moved, centre(Eigen::all, moved)};
  auto place = moved.begin();
  for (Eigen::Index k = 0; k < rows.cols(); ++k) {
    place = std::lower_bound(place, moved.end(), subspace.support[static_cast<std::size_t>(k)]);
    shape.positions.col(place - moved.begin()) = rows.col(k);
  }
  return shape;
}

Positions VariationFamily::shape_at(const Eigen::Ref<const Eigen::VectorXd>& given) const {
  Positions shape = centre;
  shape(Eigen::all, moved) = slide(given).positions;
  return shape;
}

DesignSteps::DesignSteps(const Mesh& base, const HandleEditOptions& options,
                         const EditTargets& targets, std::shared_ptr<const MeshSymmetry> symmetry)
    : base_(base),
      options_(options),
      symmetry_(std::move(symmetry)),
      handles_(handle_vertices(targets)),
      images_(targets) {
  if (!symmetry_) return;
  auto all = with_images(targets, base, *symmetry_);
  if (auto* images = std::get_if<EditTargets>(&all)) images_ = std::move(*images);
  if (auto* problem = std::get_if<std::string>(&all)) image_problem_ = std::move(*problem);
}

HandleEditResult DesignSteps::edit(const Progress& progress) const {
  HandleEditSolver solver(base_, options_);
  return edit(solver, progress);
}

HandleEditResult DesignSteps::edit(HandleEditSolver& solver, const Progress& progress) const {
  if (symmetry_) return solver.solve_symmetric(images_, *symmetry_, progress);
  return solver.solve(images_, progress);
}

std::optional<NoVariations> DesignSteps::find_no_variations(const Positions& shape) const {
  if (find_variation_problem(options_)) return NoVariations::kBentPanels;
  if (shape == base_.positions) return NoVariations::kNoEdit;
  return std::nullopt;
}

VariationFamily DesignSteps::explore(Positions shape, SubspaceOptions options,
                                     const std::vector<int>& close,
                                     const Progress& progress) const {
  options.fairness = options_.fairness;
  options.engine = options_.engine;
  VariationFamily family;
  family.subspace = compute_subspace(base_, shape, close.empty() ? handles_ : close, options,
                                     kept(), progress, options_.executor.get());
  const std::vector<int> edited = difference(base_, shape).moved;
  const std::vector<int>& support = family.subspace.support;
  std::set_union(edited.begin(), edited.end(), support.begin(), support.end(),
                 std::back_inserter(family.moved));
  family.centre = std::move(shape);
  return family;
}

ProjectionResult DesignSteps::make_exact(const VariationFamily* family, const Positions& shown,
                                         double fairness_weight, const Progress& progress) const {
  const Positions& centre = family != nullptr ? family->centre : base_.positions;
  return planish::make_exact({base_, centre, shown}, options_, fairness_weight, kept(), progress);
}

KeptByVariations DesignSteps::kept() const {
  return kept_by_variations(base_, images_, options_, symmetry_);
}

}  // namespace planish
