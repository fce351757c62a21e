// SPDX-License-Identifier: MIT
#include "edit/edit_model.hpp"

#include <algorithm>
#include <utility>

#include "edit/edit_reach.hpp"
#include "edit/switching/guided_points.hpp"
#include "edit/switching/kept_bends.hpp"
#include "edit/switching/parting_planes.hpp"
#include "edit/switching/resting_points.hpp"
#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/numeric/index.hpp"
#include "planish/numeric/stopwatch.hpp"

namespace planish {

namespace {

/// Zero where the design does not move `vertex`; solver units.
Eigen::Vector3d displacement_of(const ExactDesign& design, int vertex) {
  const auto found = std::lower_bound(design.vertices.begin(), design.vertices.end(), vertex);
  if (found == design.vertices.end() || *found != vertex) return Eigen::Vector3d::Zero();
  return design.displacement.col(found - design.vertices.begin());
}

}  // namespace

EditModel::EditModel(const Mesh& mesh, const HandleEditOptions& options)
    : options_(options), kept_(kept_kinds(options)) {
  const Stopwatch watch;
  model_ = std::make_unique<MeshModel>(mesh, options.fairness, kept_);
  base_ = std::make_unique<BaseViolations>(*model_);
  make_tools();
  rebuild();
  setup_seconds_ = watch.seconds();
}

EditModel::~EditModel() = default;

bool EditModel::set_options(const HandleEditOptions& options) {
  const KeptKinds kept = kept_kinds(options);
  const bool same_kinds = kept.same_kinds(kept_);
  const bool same_model = same_kinds && options.fairness == options_.fairness;
  options_ = options;
  kept_ = kept;
  if (!same_model) {
    const Mesh mesh = std::move(model_->mesh);
    model_ = std::make_unique<MeshModel>(mesh, options.fairness, kept_);
    make_tools();
  }
  if (!same_kinds) base_ = std::make_unique<BaseViolations>(*model_);
  rebuild();
  return !same_model;
}

/// What depends on the mesh's model alone, with marks for each of its vertices and rows.
void EditModel::make_tools() {
  finish_ = std::make_unique<ExactFinish>(*model_);
  cutter_ = std::make_unique<PatchCutter>(*model_);
  terms_ = std::make_unique<EditTerms>(*model_);
  limits_.reset();
}

/// What depends on the options: the terms and the limits.
void EditModel::rebuild() {
  std::vector<VertexTerm> terms = std::move(problem_.terms);
  problem_ = {};
  problem_.model = model_.get();
  problem_.terms = std::move(terms);
  terms_->fill(options_, problem_);
  state_limits();
  ++revision_;
}

LimitBase EditModel::limit_base() const {
  return {model_->mesh, model_->adjacency, model_->points, model_->unit()};
}

/// The rows of the stated limits and the keep-outs, and a verdict that knows them. Rows of limits
/// alone never change: those that were stated last wait until they are stated again, since the end
/// of a drag is solved without and with the limit that its frames had.
void EditModel::state_limits() {
  const bool has_keep_outs = !options_.keep_outs.empty();
  const bool has_limits = has_keep_outs || !options_.bounds.empty();
  const bool waits = limits_ && !limits_->keep_outs() && bounds_ == options_.bounds;
  if (has_limits && !waits) {
    limits_ = std::make_unique<MeshLimits>(limit_base(), options_.bounds);
    bounds_ = options_.bounds;
  }
  problem_.limits = has_limits ? limits_.get() : nullptr;
  if (has_keep_outs) return keep_out();
  make_slides();
  make_verdict();
}

void EditModel::keep_out() { keep_out(free_space(options_.keep_outs, options_.clearance)); }

void EditModel::keep_out(const FreeSpace& free) {
  limits_->keep_out(limit_base(), free);
  make_slides();
  make_verdict();
}

/// Costs what the supports hold, and nothing from one frame to the next.
void EditModel::set_supports(const std::vector<PointSupport>& supports) {
  if (supports == supports_) return;
  supports_ = supports;
  make_slides();
  make_verdict();
  ++revision_;
}

/// What the supports and the keep-outs leave the points that are on them.
void EditModel::make_slides() {
  slides_.reset();
  const auto make = [&] {
    slides_ = std::make_unique<VertexSlides>(model_->mesh, supports_, model_->unit());
  };
  if (!std::all_of(supports_.begin(), supports_.end(), is_spring)) make();
  if (!options_.keep_outs.empty()) {
    std::vector<RestingPoint> resting = limits_->keep_outs()->resting_points();
    if (!resting.empty() && slides_ == nullptr) make();
    if (!resting.empty()) slides_->rest(std::move(resting));
  }
  problem_.slides = slides_.get();
  list_switching();
}

void EditModel::list_switching() {
  active_set_.clear();
  parted_panels_.reset();
  if (options_.keep_bends) active_set_.add(std::make_unique<KeptBends>(*model_));
  const bool has_keep_outs = !options_.keep_outs.empty();
  if (has_keep_outs) {
    MeshKeepOuts& keep_outs = *limits_->keep_outs();
    const PlacesOf places_of = [this](const ExactDesign& design) {
      return verdict_->places(design);
    };
    active_set_.add(std::make_unique<PartingPlanes>(keep_outs, places_of));
    parted_panels_ = std::make_unique<PartedPanels>(keep_outs, places_of);
  }
  if (slides_ == nullptr) return;
  if (has_keep_outs) active_set_.add(std::make_unique<RestingPoints>(*slides_));
  active_set_.add(std::make_unique<GuidedPoints>(*slides_));
}

void EditModel::make_verdict() {
  verdict_ = std::make_unique<EditVerdict>(
      *model_, *base_, kept_,
      EditBounds{
          .keep_shape = options_.keep_shape, .limits = problem_.limits, .slides = slides_.get()});
}

void EditModel::set_targets(const EditTargets& targets) {
  std::vector<int> pins = targets.pins;
  std::sort(pins.begin(), pins.end());
  targets_ = targets;
  set_supports(targets.supports);
  pose(targets, options_);
  const bool limited = options_.keep_boundary || has_reach(options_);
  std::vector<int> limited_to = limited ? problem_.handles : std::vector<int>();
  if (pins == pins_ && limited_to == limited_to_) return;
  pins_ = std::move(pins);
  limited_to_ = std::move(limited_to);
  ++revision_;
}

void EditModel::pose(const EditTargets& targets, const HandleEditOptions& options) {
  terms_->assign(targets, options, problem_);
}

bool EditModel::is_beside_keep_outs() const {
  const MeshKeepOuts* const keep_outs = has_limits() ? limits_->keep_outs() : nullptr;
  return keep_outs != nullptr && keep_outs->has_rows();
}

bool EditModel::nothing_to_do() const {
  return std::all_of(problem_.handles.begin(), problem_.handles.end(),
                     [&](int v) { return problem_.terms[at(v)].target.isZero(0.0); });
}

ExactDesign EditModel::finish(std::span<const int> support, const DisplacementField& field) {
  return finish_->finish(problem_, support, field, kept_);
}

ExactDesign EditModel::placed(const std::vector<int>& vertices, const Positions& shape) {
  Positions positions = shape(Eigen::all, vertices);
  ExactDesign design = finish_->measured(vertices, std::move(positions));
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const VertexTerm& term = problem_.terms[at(vertices[k])];
    if (term.fixed) design.displacement.col(static_cast<Eigen::Index>(k)) = term.target;
  }
  return design;
}

ExactDesign EditModel::unmoved() {
  ExactDesign design;
  design.displacement.resize(3, 0);
  design.positions.resize(3, 0);
  return design;
}

bool EditModel::is_acceptable(const ExactDesign& design) const {
  const bool met = std::all_of(problem_.handles.begin(), problem_.handles.end(), [&](int v) {
    return !problem_.terms[at(v)].fixed ||
           displacement_of(design, v) == problem_.terms[at(v)].target;
  });
  return met && verdict_->is_acceptable(design);
}

double EditModel::handle_distance(const ExactDesign& design) const {
  double largest = 0.0;
  for (const int v : problem_.handles) {
    const Eigen::Vector3d left = displacement_of(design, v) - problem_.terms[at(v)].target;
    largest = std::max(largest, left.norm());
  }
  return largest;
}

ObjectiveTerms EditModel::objective(const ExactDesign& design) {
  return design_objective(problem_, design, *cutter_);
}

HandleEditResult EditModel::result_of(const ExactDesign& design, SolveReport report) {
  HandleEditResult result;
  const Positions& base = model_->mesh.positions;
  std::vector<Eigen::Index> columns;
  for (std::size_t k = 0; k < design.vertices.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (design.positions.col(column) != base.col(design.vertices[k])) columns.push_back(column);
  }
  result.moved_positions.resize(3, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const int v = design.vertices[static_cast<std::size_t>(columns[k])];
    result.moved.push_back(v);
    result.moved_positions.col(static_cast<Eigen::Index>(k)) = design.positions.col(columns[k]);
    report.max_displacement =
        std::max(report.max_displacement, (design.positions.col(columns[k]) - base.col(v)).norm());
  }
  report.moved_vertices = static_cast<int>(result.moved.size());
  if (report.usable()) report.status = verdict_->downgrade_if_base_violates(report.status, design);
  report.objective = objective(design);
  verdict_->add_to(report, design);
  report.handle_error = model_->unit() * handle_distance(design);
  report.cost += design.cost;
  report.setup_seconds = setup_seconds_;
  result.report = std::move(report);
  return result;
}

}  // namespace planish
