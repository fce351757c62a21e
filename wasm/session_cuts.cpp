// SPDX-License-Identifier: MIT
/// The cuts of a session's base: made before its edits, on the mesh that is flat, and symmetric.
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "planish/design/cut_base.hpp"
#include "session.hpp"

namespace planish {

Refusal Session::set_cuts(const std::string& lines, double tolerance) {
  std::vector<Cut> cuts;
  for (std::string_view left = lines; !left.empty();) {
    const std::size_t end = std::min(left.find('\n'), left.size());
    auto cut = parse_cut(left.substr(0, end));
    if (const auto* problem = std::get_if<std::string>(&cut)) return "Cuts: " + *problem + ".";
    cuts.push_back(std::get<Cut>(std::move(cut)));
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  if (base_.vertex_count() == 0) return "Open a mesh first.";
  take_cuts_back();
  return cuts.empty() ? std::nullopt : make_cuts(std::move(cuts), tolerance);
}

void Session::take_cuts_back() {
  if (!cut_) return;
  BaseCuts cut = std::move(*cut_);
  const Eigen::Index count = cut.before.positions.cols();
  const bool is_planarised = before_planarising_.cols() > 0;
  Positions opened(3, 0);
  if (is_planarised) opened = before_planarising_.leftCols(count);
  adopt(std::move(cut.before), warnings_);
  before_planarising_ = std::move(opened);
  symmetry_ = std::move(cut.symmetry);
}

Refusal Session::make_cuts(std::vector<Cut> cuts, double tolerance) {
  std::optional<MeshSymmetry> symmetry;
  if (symmetry_) symmetry = *symmetry_;
  auto made = cut_base(base_, cuts, symmetry, tolerance);
  if (auto* why = std::get_if<std::string>(&made)) return "Cuts: " + *why + ".";
  BaseCuts cut{base_, symmetry_, std::move(cuts), std::get<CutMesh>(std::move(made)), tolerance};
  Positions opened = std::move(before_planarising_);
  adopt(cut.made.mesh, warnings_);
  before_planarising_.resize(3, 0);
  if (opened.cols() > 0) {
    before_planarising_ = base_.positions;
    before_planarising_.leftCols(opened.cols()) = opened;
  }
  if (symmetry) symmetry_ = std::make_shared<const MeshSymmetry>(std::move(*symmetry));
  cut_ = std::move(cut);
  supports_ = with_added_points(stated_supports_);
  return std::nullopt;
}

std::vector<PointSupport> Session::with_added_points(
    const std::vector<PointSupport>& supports) const {
  return cut_ ? supports_after_cuts(supports, cut_->made) : supports;
}

}  // namespace planish
