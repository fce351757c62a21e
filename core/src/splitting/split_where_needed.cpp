// SPDX-License-Identifier: MIT
#include "planish/splitting/split_where_needed.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <variant>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/measures/folds.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "splitting/line_moment.hpp"
#include "splitting/split_lines.hpp"

namespace planish {
namespace {

/// Sets of cuts of one size that are gone on from.
constexpr std::size_t kBeam = 3;
/// Lines that are tried beside others, at most.
constexpr std::size_t kMostLines = 16;
/// Lines are tried that let go of this share at least of what the one that holds most would, and
/// where the result is certified, of what handles off their targets cost, per radian.
constexpr double kLeastMoment = 1e-2, kLeastGain = 1e-3;
/// Panels near no handle, held by a limit, that are looked at, at most.
constexpr std::size_t kMostHeld = 6;

/// Lines by their numbers, ascending.
using LineSet = std::vector<int>;

/// What a set of lines gives.
struct Tried {
  LineSet lines;
  std::vector<Cut> cuts;
  Mesh mesh;
  HandleEditResult result;
  std::vector<CornerForce> forces;  ///< of the result

  [[nodiscard]] double error() const { return result.report.handle_error; }
};

class SplitSearch {
 public:
  SplitSearch(const Mesh& mesh, const EditTargets& targets, const HandleEditOptions& edit,
              const SplitOptions& options, const MeshSymmetry* symmetry, const Progress& progress)
      : mesh_(mesh),
        targets_(targets),
        edit_(edit),
        options_(options),
        symmetry_(symmetry),
        progress_(progress) {
    for (const Handle& handle : targets.handles) handles_.push_back(handle.vertex);
    std::sort(handles_.begin(), handles_.end());
    near_ = options.within_handle * farthest_handle(targets.handles, mesh.positions);
  }

  SplitEdit run() {
    Tried uncut = solve({}, {}, mesh_);
    tell(uncut);
    keep(uncut);
    lines_ = lines_for(uncut.result.report);
    std::vector<Tried> beam;
    beam.push_back(std::move(uncut));
    for (int cuts = 1; cuts <= options_.most_cuts && may_go_on(); ++cuts) {
      beam = with_one_more(beam, cuts);
      if (beam.empty()) break;
      if (is_better(beam.front())) keep(beam.front());
      if (beam.size() > kBeam) beam.erase(at_beam(beam, kBeam), beam.end());
    }
    best_.reached = arrives(best_.result);
    return std::move(best_);
  }

 private:
  using Place = std::vector<Tried>::iterator;
  static Place at_beam(std::vector<Tried>& beam, std::size_t k) {
    return std::next(beam.begin(), static_cast<std::ptrdiff_t>(k));
  }

  Tried solve(LineSet lines, std::vector<Cut> cuts, Mesh mesh) {
    ++best_.solves;
    HandleEditSolver solver(mesh, edit_);
    HandleEditResult result = symmetry_ != nullptr
                                  ? solver.solve_symmetric(targets_, *symmetry_, progress_)
                                  : solver.solve(targets_, progress_);
    stopped_ = stopped_ || result.report.status == SolveStatus::kCancelled;
    best_.cost += result.report.cost;
    return {std::move(lines), std::move(cuts), std::move(mesh), std::move(result),
            solver.corner_forces()};
  }

  [[nodiscard]] static bool is_sound(const HandleEditResult& result) {
    return result.report.usable() && result.report.status != SolveStatus::kCancelled;
  }

  [[nodiscard]] bool arrives(const HandleEditResult& result) const {
    return is_sound(result) && result.report.handle_error <= near_;
  }

  [[nodiscard]] bool may_go_on() const {
    return !stopped_ && best_.solves < options_.most_solves && !arrives(best_.result);
  }

  [[nodiscard]] bool is_better(const Tried& tried) const {
    return best_.curve.empty() || tried.error() < best_.curve.back().handle_error;
  }

  /// Whether `a` is better: of two that arrive what the edit itself prefers, else what comes
  /// nearer.
  [[nodiscard]] bool comes_before(const Tried& a, const Tried& b) const {
    const bool arrives_a = arrives(a.result), arrives_b = arrives(b.result);
    if (arrives_a != arrives_b) return arrives_a;
    if (!arrives_a) return a.error() < b.error();
    return a.result.report.objective.total() < b.result.report.objective.total();
  }

  void tell(const Tried& tried) const {
    if (options_.found && is_better(tried)) options_.found(standing_of(tried));
  }

  void keep(const Tried& tried) {
    best_.cuts = tried.cuts;
    best_.mesh = tried.mesh;
    best_.result = tried.result;
    best_.curve.push_back(standing_of(tried));
  }

  [[nodiscard]] SplitStanding standing_of(const Tried& tried) const {
    const Mesh& mesh = tried.mesh;
    const Adjacency adjacency = build_adjacency(mesh);
    std::vector<int> remade = faces_of(adjacency, tried.result.moved);
    const double fold = sharpest_fold(mesh, adjacency, apply(mesh, tried.result), remade).degrees;
    for (const int line : tried.lines) {
      for (const SplitLine& image : lines_[at(line)]) remade.push_back(image.panel);
    }
    for (int f = mesh_.face_count(); f < mesh.face_count(); ++f) remade.push_back(f);
    std::sort(remade.begin(), remade.end());
    remade.erase(std::unique(remade.begin(), remade.end()), remade.end());
    return {static_cast<int>(tried.lines.size()),
            tried.cuts,
            tried.error(),
            tried.result.report.moved_vertices,
            static_cast<int>(remade.size()),
            fold};
  }

  /// Lines of the panels at a handle, beside them, and of some that a limit holds.
  [[nodiscard]] std::vector<LineImages> lines_for(const SolveReport& report) const {
    const Adjacency adjacency = build_adjacency(mesh_);
    std::vector<int> corners;
    for (const int f : faces_of(adjacency, handles_)) {
      corners.insert(corners.end(), mesh_.face(f).begin(), mesh_.face(f).end());
    }
    std::vector<int> panels = faces_of(adjacency, corners);
    const std::size_t near = panels.size();
    for (const BoundStanding& bound : report.bounds) {
      if (bound.name == "keep-out") continue;  // which tells points
      for (const int f : bound.binding) {
        if (panels.size() < near + kMostHeld &&
            std::find(panels.begin(), panels.end(), f) == panels.end()) {
          panels.push_back(f);
        }
      }
    }
    return lines_with_images(mesh_, adjacency, split_lines(mesh_, panels, handles_), symmetry_);
  }

  /// Each of `beam` with each line that holds it, the best first; with those of other panels only
  /// where none of a panel at a handle lets the handles arrive.
  std::vector<Tried> with_one_more(const std::vector<Tried>& beam, int cuts) {
    std::vector<Tried> found;
    seen_.clear();
    for (const Tried& parent : beam) add_each(parent, true, found);
    add_freed(cuts, found);
    if (!found.empty() && arrives(found.front().result)) return found;
    for (const Tried& parent : beam) add_each(parent, false, found);
    return found;
  }

  void add_each(const Tried& parent, bool at_handles, std::vector<Tried>& found) {
    for (const int line : lines_that_hold(parent)) {
      if (stopped_ || best_.solves >= options_.most_solves) break;
      if (is_at_handle(lines_[at(line)].front()) != at_handles) continue;
      LineSet lines = parent.lines;
      lines.insert(std::lower_bound(lines.begin(), lines.end(), line), line);
      if (!seen_.insert(lines).second) continue;
      std::vector<Cut> cuts = parent.cuts;
      Mesh mesh = parent.mesh;
      if (!cut_along(lines_[at(line)], mesh, cuts)) continue;
      add(solve(std::move(lines), std::move(cuts), std::move(mesh)), found);
    }
  }

  /// The lines, beside those tried, across which panels would bend, most first; all where forces
  /// are unknown.
  [[nodiscard]] LineSet lines_that_hold(const Tried& tried) const {
    const Positions shape = apply(tried.mesh, tried.result);
    std::vector<std::pair<double, int>> by_moment;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const int line = static_cast<int>(k);
      if (std::binary_search(tried.lines.begin(), tried.lines.end(), line)) continue;
      double moment = 0.0;
      for (const SplitLine& image : lines_[k]) {
        const SplitCut cut = split_along(tried.mesh, image, mesh_.face_count());
        if (cut.panel < 0) continue;
        moment = std::max(moment, moment_across(tried.mesh, shape, tried.forces, cut));
      }
      by_moment.emplace_back(-moment, line);
    }
    std::sort(by_moment.begin(), by_moment.end());
    LineSet lines;
    const SolveReport& report = tried.result.report;
    const bool certified = report.optimality && report.optimality->met();
    const double least = certified ? kLeastGain * report.objective.handle : 0.0;
    for (const auto& [moment, line] : by_moment) {
      if (moment > kLeastMoment * by_moment.front().first) break;
      if (-moment < least && !tried.forces.empty()) break;
      if (tried.lines.empty() || lines.size() < kMostLines) lines.push_back(line);
    }
    return lines;
  }

  /// Keeps `found` in its order, the best first.
  void add(Tried tried, std::vector<Tried>& found) const {
    if (!is_sound(tried.result)) return;
    const auto place =
        std::upper_bound(found.begin(), found.end(), tried,
                         [&](const Tried& a, const Tried& b) { return comes_before(a, b); });
    if (place == found.begin()) tell(tried);
    found.insert(place, std::move(tried));
  }

  /// Whether all images of a line can be cut.
  [[nodiscard]] bool cut_along(const LineImages& line, Mesh& mesh, std::vector<Cut>& cuts) const {
    for (const SplitLine& image : line) {
      const SplitCut cut = split_along(mesh, image, mesh_.face_count());
      if (cut.panel < 0) return false;
      auto made = cut_mesh(mesh, {cut});
      if (!std::holds_alternative<CutMesh>(made)) return false;
      mesh = std::get<CutMesh>(std::move(made)).mesh;
      cuts.emplace_back(cut);
    }
    return true;
  }

  /// The set of `cuts` lines that cut off all corners at the handles, if it has so many: they are
  /// corners of triangles alone then. Each of these lines may be no help without the others.
  void add_freed(int cuts, std::vector<Tried>& found) {
    const LineSet freeing = freeing_lines();
    if (static_cast<int>(freeing.size()) != cuts || cuts < 2 || stopped_) return;
    if (!seen_.insert(freeing).second) return;
    std::vector<Cut> made;
    Mesh mesh = mesh_;
    for (const int line : freeing) {
      if (!cut_along(lines_[at(line)], mesh, made)) return;
    }
    add(solve(freeing, std::move(made), std::move(mesh)), found);
  }

  [[nodiscard]] LineSet freeing_lines() const {
    LineSet freeing;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (cuts_off_handle(lines_[k].front())) freeing.push_back(static_cast<int>(k));
    }
    return freeing;
  }

  [[nodiscard]] bool is_handle(int v) const {
    return std::binary_search(handles_.begin(), handles_.end(), v);
  }

  [[nodiscard]] bool is_at_handle(const SplitLine& line) const {
    const auto corners = mesh_.face(line.panel);
    return std::any_of(corners.begin(), corners.end(), [&](int v) { return is_handle(v); });
  }

  [[nodiscard]] bool cuts_off_handle(const SplitLine& line) const {
    const auto corners = mesh_.face(line.panel);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const int before = corners[(c + corners.size() - 1) % corners.size()];
      const int after = corners[(c + 1) % corners.size()];
      if (is_handle(corners[c]) && std::minmax(before, after) == std::minmax(line.from, line.to)) {
        return true;
      }
    }
    return false;
  }

  const Mesh& mesh_;
  const EditTargets& targets_;
  const HandleEditOptions& edit_;
  const SplitOptions& options_;
  const MeshSymmetry* symmetry_;
  const Progress& progress_;
  std::vector<int> handles_;
  double near_ = 0.0;  ///< within which handles arrive
  std::vector<LineImages> lines_;
  std::set<LineSet> seen_;  ///< those tried of one size
  SplitEdit best_;
  bool stopped_ = false;
};

}  // namespace

Refusal find_problem(const SplitOptions& options, const HandleEditOptions& edit,
                     const EditTargets& targets) {
  if (options.most_cuts < 1) return "most_cuts must be at least 1";
  if (!(options.within_handle > 0.0 && options.within_handle < 1.0)) {
    return "within_handle must be more than 0 and less than 1: then handles move";
  }
  if (options.most_solves < 1) return "most_solves must be at least 1";
  if (auto problem = find_problem(edit.engine, Beyond::kSplits)) return problem;
  if (targets.handles.empty()) return "splits need a handle";
  return std::nullopt;
}

SplitEdit split_where_needed(const Mesh& mesh, const EditTargets& targets,
                             const HandleEditOptions& edit, const SplitOptions& options,
                             const MeshSymmetry* symmetry, const Progress& progress) {
  return SplitSearch(mesh, targets, edit, options, symmetry, progress).run();
}

}  // namespace planish
