// SPDX-License-Identifier: MIT
/// The cuts of a session's base: made before its edits, on the mesh that is flat, and symmetric.
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "planish/design/cut_base.hpp"
#include "planish/design/cut_images.hpp"
#include "session.hpp"

namespace planish {
namespace {

/// Whether points of the cut mesh lie on one side of a panel of the mesh before.
class PanelSides {
 public:
  PanelSides(const Mesh& before, const CutMesh& made) : before_(before), made_(made) {}

  [[nodiscard]] bool hold(int panel, int a, int b) const {
    const auto corners = before_.face(panel);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto side = std::minmax(corners[k], corners[(k + 1) % corners.size()]);
      if (stands_on(side, a) && stands_on(side, b)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool stands_on(const std::pair<const int&, const int&>& side, int v) const {
    if (v < before_.vertex_count()) return v == side.first || v == side.second;
    const AddedPoint& point = made_.added[static_cast<std::size_t>(v - before_.vertex_count())];
    return point.from == side.first && point.to == side.second;
  }

  const Mesh& before_;
  const CutMesh& made_;
};

}  // namespace

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
  std::vector<Cut> before = cut_ ? cut_->cuts : std::vector<Cut>();
  const double before_tolerance = cut_ ? cut_->tolerance : 0.0;
  take_cuts_back();
  if (cuts.empty()) return std::nullopt;
  Refusal refusal = make_cuts(std::move(cuts), tolerance);
  if (refusal && !before.empty()) (void)make_cuts(std::move(before), before_tolerance);
  return refusal;
}

CutTrial Session::try_cut(const std::string& text, double tolerance) const {
  const auto cut = parse_cut(text);
  if (const auto* problem = std::get_if<std::string>(&cut)) return {*problem + ".", "", {}};
  if (base_.vertex_count() == 0) return {"Open a mesh first.", "", {}};
  std::optional<MeshSymmetry> symmetry;
  if (symmetry_) symmetry = *symmetry_;
  const auto all = symmetry ? cut_with_images(base_, std::get<Cut>(cut), *symmetry)
                            : std::vector<Cut>{std::get<Cut>(cut)};
  const auto made = cut_base(base_, all, symmetry, tolerance);
  if (const auto* why = std::get_if<std::string>(&made)) return {*why + ".", "", {}};
  CutTrial trial;
  for (const Cut& one : all) {
    if (!trial.cuts.empty()) trial.cuts += '\n';
    trial.cuts += cut_text(one);
  }
  trial.lines = cut_lines(std::get<CutMesh>(made));
  return trial;
}

std::vector<float> Session::cut_lines(const CutMesh& made) const {
  const PanelSides sides(base_, made);
  std::vector<float> lines;
  for (const CutRecord& record : made.records) {
    for (const int part : record.panels) {
      const auto corners = made.mesh.face(part);
      const int parent = made.parents[static_cast<std::size_t>(part)];
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const int ends[2] = {corners[k], corners[(k + 1) % corners.size()]};
        if (sides.hold(parent, ends[0], ends[1])) continue;
        for (const int v : ends) {
          const Eigen::Vector3d p = scale_ * (shown_place(made, v) - centre_);
          for (const double x : p) lines.push_back(static_cast<float>(x));
        }
      }
    }
  }
  return lines;
}

Eigen::Vector3d Session::shown_place(const CutMesh& made, int vertex) const {
  const auto old = static_cast<int>(base_.vertex_count());
  if (vertex < old) return current_.col(vertex);
  const AddedPoint& point = made.added[static_cast<std::size_t>(vertex - old)];
  Eigen::Vector3d place = made.mesh.positions.col(vertex);
  const auto move = [&](int v) -> Eigen::Vector3d {
    return current_.col(v) - base_.positions.col(v);
  };
  if (point.panel >= 0) {
    const auto corners = base_.face(point.panel);
    for (const int v : corners) place += move(v) / static_cast<double>(corners.size());
    return place;
  }
  const Eigen::Vector3d from = base_.positions.col(point.from);
  const Eigen::Vector3d side = base_.positions.col(point.to) - from;
  const double share = (place - from).dot(side) / side.squaredNorm();
  return place + (1.0 - share) * move(point.from) + share * move(point.to);
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
