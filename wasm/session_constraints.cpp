// SPDX-License-Identifier: MIT
/// What holds the points of a session's mesh: kinds beside planarity, stated limits, supports; and
/// how an opened mesh comes to keep them.
#include <algorithm>
#include <string_view>
#include <utility>

#include "planish/text/number.hpp"
#include "session.hpp"

namespace planish {
namespace {

/// No stream: it would bring the library's locales along, a tenth of the module.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

std::vector<KeptConstraint> read_constraints(std::string_view lines) {
  std::vector<KeptConstraint> constraints;
  for (const std::string_view line : lines_of(lines)) {
    const std::size_t colon = line.find(':');
    const std::string_view kind = line.substr(0, colon);
    const bool own = colon == std::string_view::npos;
    const std::optional<double> tolerance =
        own ? own_tolerance(kind).value_or(1.0) : parse_number(line.substr(colon + 1));
    constraints.push_back({std::string(kind), tolerance.value_or(0.0)});
  }
  return constraints;
}

std::vector<StatedLimit> read_limits(std::string_view lines) {
  std::vector<StatedLimit> limits;
  for (const std::string_view line : lines_of(lines)) {
    limits.push_back(parse_stated_limit(line).value_or(StatedLimit{.name = std::string(line)}));
  }
  return limits;
}

Refusal Session::planarise(const Planarising& how) {
  if (const auto problem = find_problem(how)) return *problem;
  Mesh opened = as_opened();
  const ProjectionResult result = planish::planarise(opened, how, progress_);
  if (!is_flattened(result, how)) {
    return std::to_string(result.failing_faces.size()) +
           (how.constraints.empty() ? " panels cannot be made flat" : " panels cannot be made so") +
           "; the mesh is as it was.";
  }
  Positions flat = std::move(opened.positions);
  flat(Eigen::all, result.moved) = result.moved_positions;
  return adopt_planarised(std::move(flat));
}

Refusal Session::take_planarised(Positions found) {
  if (found.cols() != uncut().positions.cols() || !found.allFinite()) {
    return "This flat mesh does not belong to the mesh that is open.";
  }
  return adopt_planarised(std::move(found));
}

/// Before its cuts, too.
Mesh Session::as_opened() const {
  Mesh mesh = uncut();
  const Eigen::Index count = mesh.positions.cols();
  if (before_planarising_.cols() > 0) mesh.positions = before_planarising_.leftCols(count);
  return mesh;
}

Refusal Session::adopt_planarised(Positions flat) {
  Mesh mesh = as_opened();
  Positions opened = std::move(mesh.positions);
  mesh.positions = std::move(flat);
  const std::optional<BaseCuts> cut = std::exchange(cut_, std::nullopt);
  adopt(std::move(mesh), warnings_);
  before_planarising_ = std::move(opened);
  return cut ? make_cuts(cut->cuts, cut->tolerance) : std::nullopt;
}

void Session::renew_solver() {
  if (solver_) solver_->set_options(options_);
}

Refusal Session::set_options(HandleEditOptions options) {
  if (const auto problem = find_problem(options)) return *problem;
  const bool same = options.constraints == options_.constraints;
  constraints_fit_ = same ? constraints_fit_ : options.constraints.empty();
  options_ = std::move(options);
  renew_solver();
  return std::nullopt;
}

/// Looked at once for a base, as the supports are.
Refusal Session::require_kept_constraints() {
  if (constraints_fit_) return std::nullopt;
  if (const auto broken = find_broken_constraint(base_, options_)) return *broken;
  constraints_fit_ = true;
  return std::nullopt;
}

Refusal Session::set_supports(const std::string& lines) {
  std::vector<PointSupport> supports;
  for (const std::string_view line : lines_of(lines)) {
    auto support = parse_point_support(line);
    if (!support) return "A support must be one of " + std::string(known_supports());
    supports.push_back(std::move(*support));
  }
  if (const auto problem = find_problem(supports)) return *problem;
  stated_supports_ = std::move(supports);
  supports_ = with_added_points(stated_supports_);
  supports_fit_ = supports_.empty();
  return std::nullopt;
}

/// The supports are looked at once for a base, not in every frame: that costs O(n).
Refusal Session::take_targets(EditTargets& targets) {
  if (const auto problem = find_problem(targets, base_)) return *problem;
  if (!supports_fit_) {
    if (const auto problem = find_problem(supports_, base_)) return *problem;
  }
  supports_fit_ = true;
  targets.supports = supports_;
  return std::nullopt;
}

}  // namespace planish
