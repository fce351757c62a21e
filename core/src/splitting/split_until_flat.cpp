// SPDX-License-Identifier: MIT
#include "planish/splitting/split_until_flat.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>

#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "splitting/panel_parting.hpp"

namespace planish {
namespace {

/// Panels that stayed bent are parted first where they are this part of all at most: where most
/// are bent it says nothing.
constexpr double kFewBent = 0.25;
/// The most parted panels each of which is tried without its cut.
constexpr std::size_t kFewParted = 12;

/// Whether a reader of the curve wants it behind `before`, which parts fewer panels.
bool improves(const HybridStanding& after, const HybridStanding& before) {
  if (after.failing_faces != before.failing_faces) {
    return after.failing_faces < before.failing_faces;
  }
  return after.failing_faces == 0 && after.rms_move < before.rms_move;
}

/// What was tried, by the number of panels, each better than the one before it.
std::vector<HybridStanding> curve_of(std::vector<HybridStanding> tried) {
  std::stable_sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) {
    return a.panels != b.panels ? a.panels < b.panels : improves(a, b);
  });
  std::vector<HybridStanding> curve;
  for (const HybridStanding& standing : tried) {
    const bool is_same = !curve.empty() && curve.back().panels == standing.panels;
    if (curve.empty() || (!is_same && improves(standing, curve.back()))) curve.push_back(standing);
  }
  return curve;
}

class HybridSearch {
 public:
  HybridSearch(const Mesh& mesh, const ProjectionOptions& options, const std::vector<int>& pins,
               const HybridOptions& hybrid, const Progress& progress)
      : mesh_(mesh),
        adjacency_(build_adjacency(mesh)),
        options_(options),
        pins_(pins),
        hybrid_(hybrid),
        progress_(progress) {}

  HybridMesh run() {
    if (!part({}) && may_go_on() && part_most()) {
      halve();
      leave_out();
    }
    best_.curve = curve_of(std::move(tried_));
    return std::move(best_);
  }

 private:
  [[nodiscard]] bool may_go_on() const {
    return !stopped_ && best_.projections < hybrid_.most_projections;
  }

  /// Whether the mesh becomes flat with these parted; the best so far is kept.
  bool part(std::vector<int> panels) {
    auto made = cut_mesh(mesh_, parting_cuts(mesh_, adjacency_, panels, parting_));
    if (!std::holds_alternative<CutMesh>(made)) return false;
    auto& cut = std::get<CutMesh>(made);
    ProjectionResult result = project_to_planar(cut.mesh, options_, pins_, progress_);
    stopped_ = stopped_ || result.report.status == SolveStatus::kCancelled;
    const bool flat = !stopped_ && result.report.usable() && result.failing_faces.empty();
    const int failing = static_cast<int>(result.failing_faces.size());
    const bool is_first = best_.projections++ == 0;
    if (is_first || !stopped_) {
      tried_.push_back(
          {static_cast<int>(panels.size()), failing, result.rms_move, result.max_move});
    }
    const bool is_better =
        best_.reached ? flat && panels.size() < parted_.size()
                      : flat || failing < static_cast<int>(best_.result.failing_faces.size());
    if (is_first || (is_better && !stopped_)) {
      best_.cut = std::move(cut);
      best_.result = std::move(result);
      best_.panels = static_cast<int>(panels.size());
      best_.reached = flat;
      parted_ = std::move(panels);
    }
    return flat;
  }

  [[nodiscard]] std::vector<int> first_panels(std::size_t count) const {
    return {order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(count)};
  }

  /// Parts as many as may be: in two, and where that is not enough in triangles.
  bool part_most() {
    const std::vector<int>& failing = best_.result.failing_faces;
    const bool few = static_cast<double>(failing.size()) <= kFewBent * mesh_.face_count();
    order_ = parting_order(mesh_, adjacency_, few ? failing : std::vector<int>{});
    most_ = std::min(at(hybrid_.most_panels), order_.size());
    if (part(first_panels(most_))) return true;
    parting_ = Parting::kInTriangles;
    const bool has_large =
        std::any_of(order_.begin(), order_.end(), [&](int f) { return mesh_.face(f).size() > 4; });
    return has_large && may_go_on() && part(first_panels(most_));
  }

  /// Finds by halves how many must be parted: with `flat` the mesh is flat, with `bent` it is not.
  void halve() {
    std::size_t bent = 0, flat = most_;
    while (flat - bent > 1 && may_go_on()) {
      const std::size_t middle = bent + (flat - bent) / 2;
      (part(first_panels(middle)) ? flat : bent) = middle;
    }
  }

  /// Leaves out, where few are parted, each of them that need not be.
  void leave_out() {
    if (parted_.size() > kFewParted) return;
    for (std::size_t k = 0; k < parted_.size() && parted_.size() > 1 && may_go_on();) {
      std::vector<int> fewer = parted_;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      if (!part(std::move(fewer))) ++k;
    }
  }

  const Mesh& mesh_;
  Adjacency adjacency_;
  const ProjectionOptions& options_;
  const std::vector<int>& pins_;
  const HybridOptions& hybrid_;
  const Progress& progress_;
  Parting parting_ = Parting::kInTwo;
  std::vector<int> order_;
  std::size_t most_ = 0;
  std::vector<int> parted_;  ///< in the best so far
  std::vector<HybridStanding> tried_;
  HybridMesh best_;
  bool stopped_ = false;
};

}  // namespace

Refusal find_problem(const HybridOptions& options) {
  if (options.most_panels < 1) return "most_panels must be at least 1";
  if (options.most_projections < 1) return "most_projections must be at least 1";
  return std::nullopt;
}

HybridMesh split_until_flat(const Mesh& mesh, const ProjectionOptions& options,
                            const std::vector<int>& pins, const HybridOptions& hybrid,
                            const Progress& progress) {
  return HybridSearch(mesh, options, pins, hybrid, progress).run();
}

}  // namespace planish
