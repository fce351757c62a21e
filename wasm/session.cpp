// SPDX-License-Identifier: MIT
#include "session.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "planish/io/face_groups.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "planish/problem/mesh_standing.hpp"
#include "planish/shapes/shapes.hpp"
#include "refused_outcome.hpp"

namespace planish {
namespace {

/// Display coordinates span about this much, whatever the unit of the model.
constexpr double kDisplaySize = 10.0;

/// The formats of this module; GLB is another's.
const MeshFormatRow* plain_format(std::string_view name) {
  const auto row =
      std::find_if(kPlainFormats.begin(), kPlainFormats.end(),
                   [&](const MeshFormatRow& format) { return format.extension == name; });
  return row == kPlainFormats.end() ? nullptr : row;
}

}  // namespace

Refusal Session::open_sample(const std::string& name, int size) {
  std::optional<Mesh> mesh = make_sample(name, size);
  if (!mesh) return "There is no sample \"" + name + "\" of size " + std::to_string(size) + ".";
  adopt(std::move(*mesh), {});
  return std::nullopt;
}

Refusal Session::open_file(std::string_view bytes, const std::string& format) {
  const MeshFormatRow* row = plain_format(format);
  if (!row) return "Files of type ." + format + " cannot be read. Use " + all_extensions() + ".";
  ReadResult result = row->read(bytes);
  if (const auto* error = std::get_if<ReadError>(&result)) return error->message;
  auto& file = std::get<MeshFile>(result);
  adopt(std::move(file.mesh), std::move(file.warnings));
  return std::nullopt;
}

void Session::adopt(Mesh mesh, std::vector<std::string> warnings) {
  solver_.reset();  // it may refer to the old base
  symmetry_.reset();
  family_.reset();
  cut_.reset();
  kept_.reset();
  supports_ = stated_supports_;
  base_ = std::move(mesh);
  before_planarising_.resize(3, 0);
  warnings_ = std::move(warnings);
  adjacency_ = build_adjacency(base_);
  const PlanaritySummary planarity = planarity_summary(base_);
  base_worst_ = worst_of(planarity);
  const Eigen::Vector3d low = base_.positions.rowwise().minCoeff();
  const Eigen::Vector3d high = base_.positions.rowwise().maxCoeff();
  centre_ = 0.5 * (low + high);
  const double extent = (high - low).norm();
  scale_ = extent > 0.0 ? kDisplaySize / extent : 1.0;
  current_ = base_.positions;
  moved_.clear();
  dirty_.clear();
  targets_ = {};
  supports_fit_ = supports_.empty();
  constraints_fit_ = options_.constraints.empty();
  lower_at_once_ = false;
  report_unsolved(0.0);
}

Refusal Session::require_flat_base() const {
  if (base_.vertex_count() == 0) return "Open a mesh first.";
  if (is_base_flat()) return std::nullopt;
  return "This mesh has panels that are not flat. Planarise it first.";
}

Refusal Session::begin_edit(EditTargets& targets) {
  if (Refusal refusal = require_flat_base()) return refusal;
  if (Refusal refusal = take_targets(targets)) return refusal;
  return require_kept_constraints();
}

Refusal Session::edit(EditMode mode, EditTargets targets, double budget_seconds) {
  if (const Refusal refusal = begin_edit(targets)) return refusal;
  if (const Refusal refusal = require_engine(targets)) return refusal;
  const Stopwatch watch;
  if (!solver_) solver_.emplace(base_, options_);
  lower_at_once_ = false;
  const DesignSteps steps = steps_of(targets);
  if (Refusal refusal = find_image_problem(steps)) return refusal;
  const HandleEditResult result = solve(mode, steps, targets, budget_seconds);
  if (const Refusal refusal = unusable(result.report, "The edit")) return refusal;
  family_.reset();
  targets_ = std::move(targets);
  show(result.moved, result.moved_positions);
  follows_path_ = mode == EditMode::kDrag;
  renew_report(result.report, watch.seconds());
  return std::nullopt;
}

/// A release under a symmetry is what the targets alone give: of a path that a drag took there are
/// no images.
HandleEditResult Session::solve(EditMode mode, const DesignSteps& steps, EditTargets& targets,
                                double budget_seconds) {
  if (mode == EditMode::kDrag) return solver_->drag(steps.images(), budget_seconds);
  if (mode == EditMode::kRelease && !symmetry_) return release(targets);
  return steps.edit(*solver_, progress_);
}

Refusal Session::restore(EditTargets targets, const std::vector<int>& moved,
                         const Positions& positions, bool keep_variations) {
  if (const Refusal refusal = take_targets(targets)) return refusal;
  const bool in_range = std::all_of(moved.begin(), moved.end(),
                                    [&](int v) { return v >= 0 && v < base_.vertex_count(); });
  const bool ascending =
      std::adjacent_find(moved.begin(), moved.end(), std::greater_equal<>()) == moved.end();
  if (!in_range || !ascending || static_cast<Eigen::Index>(moved.size()) != positions.cols() ||
      !positions.allFinite()) {
    return "This design does not belong to the mesh that is open.";
  }
  if (!keep_variations) family_.reset();
  targets_ = std::move(targets);
  show(moved, positions);
  report_unsolved(0.0);
  return std::nullopt;
}

Refusal Session::explore(const SubspaceOptions& options) {
  if (const Refusal refusal = require_flat_base()) return refusal;
  if (const auto problem = find_problem(options)) return *problem;
  const DesignSteps steps = steps_of(targets_);
  if (const auto why = steps.find_no_variations(current_)) {
    return *why == NoVariations::kBentPanels
               ? "Variations make panels flat: there are none of bent panels."
               : "Move a point first: variations are found around an edit.";
  }
  const Stopwatch watch;
  if (!measure_standing(shown_mesh(), adjacency_, kept_kinds(options_)).failing.empty())
    return "Make the design exact first.";
  VariationFamily found = steps.explore(current_, options, {}, progress_);
  const Subspace& subspace = found.subspace;
  if (subspace.dimension() == 0) return "No variation was found around this edit.";
  variations_report_ = {subspace.report, subspace.dimension(), watch.seconds()};
  family_ = std::move(found);
  return std::nullopt;
}

Refusal Session::check_coefficients(const Eigen::VectorXd& coefficients) const {
  if (!family_) return "Find variations first.";
  const int dimension = family_->subspace.dimension();
  if (coefficients.size() != dimension || !coefficients.allFinite()) {
    return "This edit has " + std::to_string(dimension) + " variations.";
  }
  return std::nullopt;
}

Refusal Session::vary(const Eigen::VectorXd& coefficients) {
  if (const Refusal refusal = check_coefficients(coefficients)) return refusal;
  const Stopwatch watch;
  const SparseShape shape = family_->slide(coefficients);
  show(shape.moved, shape.positions);
  report_unsolved(watch.seconds());
  return std::nullopt;
}

Refusal Session::project_variation(const Eigen::VectorXd& coefficients) {
  if (const Refusal refusal = check_coefficients(coefficients)) return refusal;
  const Stopwatch watch;
  Positions positions = family_->shape_at(coefficients);
  SolveReport report;
  if (const Refusal refusal = project(positions, report)) return refusal;
  projected_ = difference(base_, positions);
  projected_report_ = report_of(positions, projected_.moved, report, watch.seconds());
  return std::nullopt;
}

Refusal Session::project(Positions& positions, SolveReport& report) const {
  const VariationFamily* family = family_ ? &*family_ : nullptr;
  ProjectionResult result = steps_of(targets_).make_exact(family, positions, 0.0, progress_);
  report = std::move(result.report);
  if (const Refusal refusal = unusable(report, "The projection")) return refusal;
  positions(Eigen::all, result.moved) = result.moved_positions;
  return std::nullopt;
}

Refusal Session::make_exact() {
  const Stopwatch watch;
  Positions positions = current_;
  SolveReport report;
  if (const Refusal refusal = project(positions, report)) return refusal;
  const SparseShape exact = difference(base_, positions);
  show(exact.moved, exact.positions);
  renew_report(report, watch.seconds());
  return std::nullopt;
}

void Session::show(const std::vector<int>& moved, const Positions& positions) {
  for (const int v : moved_) current_.col(v) = base_.positions.col(v);
  dirty_.insert(dirty_.end(), moved_.begin(), moved_.end());
  moved_.clear();
  follows_path_ = false;
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const int v = moved[k];
    const auto column = static_cast<Eigen::Index>(k);
    if (positions.col(column) == base_.positions.col(v)) continue;  // −0 stays −0
    current_.col(v) = positions.col(column);
    moved_.push_back(v);
  }
  dirty_.insert(dirty_.end(), moved_.begin(), moved_.end());
}

WorstPanel Session::worst_panel(const Positions& positions, const std::vector<int>& moved) const {
  WorstPanel worst = base_worst_;
  if (!is_base_flat() && !moved.empty()) {
    return worst_of(planarity_summary(base_, positions));
  }
  for (const int v : moved) {
    for (const int f : adjacency_.faces[v]) {
      const FacePlanarity face = face_planarity(positions, base_.face(f));
      if (face.mm_per_m > worst.mm_per_m) {
        worst.gap = face.gap;
        worst.mm_per_m = face.mm_per_m;
      }
      worst.excess = std::max(worst.excess, face.excess);
    }
  }
  return worst;
}

WorstPanel Session::worst_of(const PlanaritySummary& planarity) {
  return {.gap = planarity.worst_gap, .mm_per_m = planarity.max, .excess = planarity.max_excess};
}

double Session::largest_move(const Positions& positions, const std::vector<int>& moved) const {
  double largest = 0.0;
  for (const int v : moved) {
    largest = std::max(largest, (positions.col(v) - base_.positions.col(v)).norm());
  }
  return largest;
}

Positions Session::moved_positions() const { return current_(Eigen::all, moved_); }

Mesh Session::shown_mesh() const {
  Mesh mesh = base_;
  mesh.positions = current_;
  return mesh;
}

std::vector<float> Session::take_changes() {
  std::sort(dirty_.begin(), dirty_.end());
  dirty_.erase(std::unique(dirty_.begin(), dirty_.end()), dirty_.end());
  std::vector<float> changes;
  changes.reserve(4 * dirty_.size());
  for (const int v : dirty_) {
    const Eigen::Vector3f p = ((current_.col(v) - centre_) * scale_).cast<float>();
    changes.insert(changes.end(), {static_cast<float>(v), p.x(), p.y(), p.z()});
  }
  dirty_.clear();
  return changes;
}

std::vector<float> Session::display_base() const {
  std::vector<float> display(static_cast<std::size_t>(base_.positions.size()));
  Eigen::Map<Eigen::Matrix3Xf>(display.data(), 3, base_.positions.cols()) =
      ((base_.positions.colwise() - centre_) * scale_).cast<float>();
  return display;
}

std::optional<std::string> Session::write(const std::string& format) const {
  const MeshFormatRow* row = plain_format(format);
  if (!row) return std::nullopt;
  return row->write(shown_mesh());
}

std::string Session::groups() const { return face_groups_text(base_.groups); }

Refusal Session::set_groups(const std::string& lines) {
  auto groups = parse_face_groups(lines, base_.face_count());
  if (!groups) return "Groups must name faces of the mesh in their order.";
  base_.groups = std::move(*groups);
  return std::nullopt;
}

GlbVariations Session::variations() const {
  return family_ ? variations_of(family_->subspace) : GlbVariations{};
}

}  // namespace planish
