// SPDX-License-Identifier: MIT
/// What holds the points of a session's mesh: kinds beside planarity, stated limits, supports; and
/// how an opened mesh comes to keep them.
#include <algorithm>
#include <string_view>
#include <utility>

#include "planish/text/number.hpp"
#include "session.hpp"

namespace planish {

KeptConstraint read_constraint(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  const bool own = colon == std::string_view::npos;
  const std::optional<double> tolerance =
      own ? own_tolerance(kind).value_or(1.0) : parse_number(text.substr(colon + 1));
  return {std::string(kind), tolerance.value_or(0.0)};
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

/// The mesh before it was made flat and cut.
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

Refusal Session::set_supports(const std::vector<std::string>& texts) {
  std::vector<PointSupport> supports;
  for (const std::string& text : texts) {
    auto support = parse_point_support(text);
    if (!support) return "A support must be one of " + std::string(known_supports());
    supports.push_back(std::move(*support));
  }
  if (const auto problem = find_problem(supports)) return *problem;
  stated_supports_ = std::move(supports);
  supports_ = with_added_points(stated_supports_);
  supports_fit_ = supports_.empty();
  return std::nullopt;
}

/// The core's refusals in the words of the page: what the paper's engine knows none of, and what to
/// do about it.
constexpr std::pair<Beyond, std::string_view> kAdvice[] = {
    {Beyond::kSymmetry, "symmetry: switch it off"},
    {Beyond::kSupports, "supports: let the boundary move freely"},
    {Beyond::kKeepOuts, "keep-outs: remove them"},
    {Beyond::kBends, "panels that stay bent: planarise the mesh"}};

Refusal Session::require_engine(EditTargets& targets) const {
  if (find_problem(options_.engine, Beyond::kContinuation)) targets.continuation = 0;
  const Refusal refusal = find_engine_problem(options_, targets, symmetry_ != nullptr);
  for (const auto& [beyond, advice] : kAdvice) {
    if (!refusal || refusal != find_problem(options_.engine, beyond)) continue;
    return "The paper's engine knows no " + std::string(advice) + ", or choose Newton.";
  }
  return refusal;
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
