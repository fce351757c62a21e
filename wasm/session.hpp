// SPDX-License-Identifier: MIT
/// What one browser worker owns: a base mesh, the edit on it, the variations around the edit.
/// Plain C++, tested natively; bindings.cpp only lists it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/design/design.hpp"
#include "planish/design/design_steps.hpp"
#include "planish/edit/fair_limits.hpp"
#include "planish/edit/fewest.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/edit/pull_hold.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/projection/planarising.hpp"
#include "planish/projection/projection.hpp"
#include "planish/splitting/split_until_flat.hpp"
#include "planish/splitting/split_where_needed.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "planish/text/refusal.hpp"
#include "session_report.hpp"

namespace planish {

/// How an edit is to be computed.
enum class EditMode {
  kDrag,  ///< within a time budget, may follow the path of the pointer
  /// The end of a drag, and what depends on the targets alone: of the solves at once and by
  /// continuation the first that ends as the drag does; the one at once where none does.
  kRelease,
  kSolve,  ///< for typed targets and links: depends on the targets alone
};

/// What one more cut would leave.
struct CutTrial {
  std::string problem;       ///< why it cannot be made; "" where it can
  std::string cuts;          ///< it, and under a symmetry its images; one a line
  std::vector<float> lines;  ///< both ends of every new side, where the design shown has them
};

/// What doing a design again gave, beside the shape that is shown.
struct Replayed {
  std::vector<int> directions;  ///< of each variation
  SparseShape centre;           ///< what the last one was found around; empty without any
  double deviation = 0.0;       ///< from the recorded result, see deviation()
};

/// How handles are pulled.
enum class PullWay {
  kFollow,  ///< a frame of a drag, which may take the time of several to catch up
  /// Such a frame, kept where it suffices with the panels that may follow; else what is shown is
  /// the edit kept before.
  kNear,
  kHold,      ///< such a frame, which limits may hold back, see PullHold::take()
  kRelease,   ///< as far as handles get, see furthest(), the end of the way by EditMode::kRelease
  kFurthest,  ///< as kRelease, by EditMode::kSolve
};

struct Pulled {
  bool suffices = false;                     ///< of kNear
  std::optional<std::vector<Handle>> taken;  ///< to where handles were taken back, if they were
};

/// Where the edit that is shown stands with its handles, see the functions of these names.
struct PullStanding {
  bool is_stuck = false;
  bool is_bound = false;
  bool arrives = false;
  bool lags = false;
};

/// As --constraint says it. What cannot be read breaks a rule of find_problem().
[[nodiscard]] KeptConstraint read_constraint(std::string_view text);

class Session {
 public:
  /// Called between solver steps with the step number and the constraint residual; returning
  /// kStop cancels. Applies to every operation that runs longer than a drag frame.
  void set_progress(Progress progress) { progress_ = std::move(progress); }

  // Opening. A refused mesh leaves the session as it was.
  [[nodiscard]] Refusal open_sample(const std::string& name, int size);
  [[nodiscard]] Refusal open_file(std::string_view bytes, const std::string& format);
  /// Replaces the base by a flat mesh, made from what was opened, whatever it was made before; an
  /// edit must be redone after it. Where the panels' shape
  /// does not allow that, the base becomes as flat as it does: see is_base_flat().
  [[nodiscard]] Refusal planarise(const Planarising& how = {});
  /// Replaces the base by the flat mesh that another session found.
  /// @param found 3 × n, model units
  [[nodiscard]] Refusal take_planarised(Positions found);

  // Editing. A refused operation leaves the design as it was.
  /// For all edits from here on. An edit needs a base that keeps the constraints.
  [[nodiscard]] Refusal set_options(HandleEditOptions options);
  /// Sets a symmetry for all edits of this base, as --symmetry says it: each edits its images, too.
  /// Looked for in what was opened; the base, which must be flat, is evened out where it needs
  /// that, as by planarise(). @param tolerance mm/m
  [[nodiscard]] Refusal set_symmetry(const std::string& text, double tolerance);
  /// Makes cuts before the edits of this base, one a line as --cut says it; "" for none. The base
  /// becomes what they leave, its symmetry that of it; edits must be redone. Whoever makes the mesh
  /// flat makes that of before the cuts flat, which are then made again.
  /// @param tolerance mm/m
  [[nodiscard]] Refusal set_cuts(const std::string& lines, double tolerance);
  /// Tries one more cut, which is not made; a new side may be listed once for each of its panels.
  [[nodiscard]] CutTrial try_cut(const std::string& text, double tolerance) const;
  /// What lines through panels more let the handles of an edit do; the design stays as it is. A
  /// sentence where that cannot be looked for. `targets` as those of edit().
  [[nodiscard]] std::variant<SplitEdit, std::string> split_where_needed(
      EditTargets targets, const SplitOptions& options);
  /// As planarise(), with so many panels parted at most, and as few as let all become flat: the
  /// base, which must have no cuts, becomes the parted mesh. All numbers but of parted panels stay.
  [[nodiscard]] Refusal split_until_flat(const Planarising& how, int most_panels);
  /// What the last split_until_flat() gave: how many panels it parted, and what that left bent.
  [[nodiscard]] const HybridStanding& hybrid() const { return hybrid_; }
  /// Null without one.
  [[nodiscard]] const MeshSymmetry* symmetry() const { return symmetry_.get(); }
  /// Sets supports for all edits from here on, each as --support says it.
  [[nodiscard]] Refusal set_supports(const std::vector<std::string>& texts);
  /// `targets` without supports: those that were set. kRelease chooses the continuation itself; the
  /// report says it, and whether a solve at once ends lower.
  [[nodiscard]] Refusal edit(EditMode mode, EditTargets targets, double budget_seconds);
  /// edit() with the limits that cost its handles nothing, see find_fair_limits(): from here on
  /// those of all edits, beside those that were set.
  [[nodiscard]] Refusal edit_fairly(EditMode mode, const EditTargets& targets,
                                    double budget_seconds, const FairSearch& search);
  /// What the last edit_fairly() found.
  [[nodiscard]] const std::vector<StatedLimit>& fair_found() const { return fair_found_; }
  /// The edit that makes few panels again, see find_buildable_fewest(). From here on what it holds
  /// are pins of the targets, its limits those of all edits.
  [[nodiscard]] Refusal fewest(EditTargets targets, const FewestOptions& asked);
  /// What the last fewest() found.
  [[nodiscard]] const BuildableFewest& fewest_found() const { return fewest_found_; }
  /// Edits under the limit of a drag, as pulled() tells.
  [[nodiscard]] Refusal pull(PullWay way, const EditTargets& targets, double budget_seconds,
                             const PullLimit& limit);
  /// What the last pull() gave.
  [[nodiscard]] const Pulled& pulled() const { return pulled_; }
  /// What holds back the drag that goes on.
  [[nodiscard]] const PullHold& pull_hold() const { return pull_hold_; }
  /// No drag goes on.
  void forget_drag() { pull_hold_ = {}; }
  /// Of the edit that is shown, which was asked to get to `handles`.
  [[nodiscard]] PullStanding pull_standing(const PullLimit& limit,
                                           const std::vector<Handle>& handles) const;
  /// Of the edit that is shown; without slivers.
  [[nodiscard]] EditStanding standing() const;
  /// Keeps the edit that is shown, and where a drag stands.
  void keep_edit();
  /// The next frame of the drag follows the one kept; what is shown stays.
  void go_back();
  /// Shows the edit kept again, with its report; nothing where none was kept on this base.
  void show_kept();
  /// Shows a design that was computed before: `moved` ascending, everything else at the base.
  /// @param keep_variations the design is one of the family found last, or its centre
  [[nodiscard]] Refusal restore(EditTargets targets, const std::vector<int>& moved,
                                const Positions& positions, bool keep_variations = false);

  /// Does `design` again on the base that is open, wherever that is from, by the core's
  /// replay_on(); its options and supports are set with it.
  /// @param base_hash that of the base, before its cuts; nullopt where it is not known
  [[nodiscard]] Refusal replay(Design design,
                               std::optional<std::uint32_t> base_hash = std::nullopt);
  /// What the last replay() gave.
  [[nodiscard]] const Replayed& replayed() const { return replayed_; }

  // Exploring: variations around the design shown.
  /// Fairness and engine are those of the edit.
  [[nodiscard]] Refusal explore(const SubspaceOptions& options);
  [[nodiscard]] Refusal vary(const Eigen::VectorXd& coefficients);
  /// The exact shape of a variation, kept in projected(); the design shown stays as it is. The same
  /// bits as vary() and make_exact().
  [[nodiscard]] Refusal project_variation(const Eigen::VectorXd& coefficients);
  /// The nearest flat design to what is shown, within the limits; see planish::make_exact().
  [[nodiscard]] Refusal make_exact();

  // What is there.
  [[nodiscard]] const Mesh& base() const { return base_; }
  /// The base before its cuts.
  [[nodiscard]] const Mesh& uncut() const { return cut_ ? cut_->before : base_; }
  /// For every panel of the base which one of uncut(); empty without cuts.
  [[nodiscard]] std::vector<int> panel_parents() const {
    return cut_ ? cut_->made.parents : std::vector<int>();
  }
  /// 3 × n, the base as it was opened; 3 × 0 unless it was planarised since.
  [[nodiscard]] const Positions& before_planarising() const { return before_planarising_; }
  [[nodiscard]] const Positions& current() const { return current_; }
  [[nodiscard]] const std::vector<int>& moved() const { return moved_; }
  /// 3 × |moved|, model units.
  [[nodiscard]] Positions moved_positions() const;
  /// What project_variation() found.
  [[nodiscard]] const SparseShape& projected() const { return projected_; }
  /// shape_report() as it would be after showing it.
  [[nodiscard]] const ShapeReport& projected_report() const { return projected_report_; }
  [[nodiscard]] MeshReport mesh_report() const;
  /// The report of the design shown.
  [[nodiscard]] const ShapeReport& shape_report() const { return shape_report_; }
  /// The report of the last explore().
  [[nodiscard]] const VariationsReport& variations_report() const { return variations_report_; }
  /// Vertex, x, y, z of every vertex that changed since the last call, in display coordinates:
  /// (p − centre) · scale, so that float32 keeps its digits wherever the model lies.
  [[nodiscard]] std::vector<float> take_changes();
  /// All base vertices in display coordinates.
  [[nodiscard]] std::vector<float> display_base() const;
  /// The design shown as a file: obj, off or ply. nullopt for any other format; a GLB is put
  /// together by assemble_glb() from the OBJ, the base and the variations.
  [[nodiscard]] std::optional<std::string> write(const std::string& format) const;
  /// The named runs of faces of the base, as face_groups_text() writes them.
  [[nodiscard]] std::string groups() const;
  /// Sets other groups in their place, for write(): of the same text. The base itself stays.
  [[nodiscard]] Refusal set_groups(const std::string& lines);
  /// What each slider does at value 1; nothing without variations.
  [[nodiscard]] GlbVariations variations() const;

 private:
  /// How the base was cut.
  struct BaseCuts {
    Mesh before;
    std::shared_ptr<const MeshSymmetry> symmetry;  ///< of it
    std::vector<Cut> cuts;
    CutMesh made;
    double tolerance = 0.0;  ///< mm/m
  };

  /// An edit that was shown.
  struct KeptEdit {
    EditTargets targets;
    SparseShape shape;
    ShapeReport report;
    bool follows_path = false;
  };

  void adopt(Mesh mesh, std::vector<std::string> warnings);
  [[nodiscard]] Mesh as_opened() const;
  [[nodiscard]] Refusal adopt_planarised(Positions flat);
  void take_cuts_back();
  [[nodiscard]] Refusal make_cuts(std::vector<Cut> cuts, double tolerance);
  [[nodiscard]] std::vector<float> cut_lines(const CutMesh& made) const;
  [[nodiscard]] Eigen::Vector3d shown_place(const CutMesh& made, int vertex) const;
  [[nodiscard]] std::vector<PointSupport> with_added_points(
      const std::vector<PointSupport>& supports) const;
  [[nodiscard]] int slivers() const;
  [[nodiscard]] Refusal require_flat_base() const;
  [[nodiscard]] Refusal take_targets(EditTargets& targets);
  /// take_targets() for an edit, whose base must be flat and keep its constraints.
  [[nodiscard]] Refusal begin_edit(EditTargets& targets);
  /// `targets` without the steps of an engine that knows none; a sentence where it knows more of
  /// the edit not.
  [[nodiscard]] Refusal require_engine(EditTargets& targets) const;
  [[nodiscard]] HandleEditResult solve(EditMode mode, const DesignSteps& steps,
                                       EditTargets& targets, double budget_seconds);
  [[nodiscard]] HandleEditResult release(EditTargets& targets);
  [[nodiscard]] DesignSteps steps_of(const EditTargets& targets) const {
    return {base_, options_, targets, symmetry_};
  }
  [[nodiscard]] static Refusal find_image_problem(const DesignSteps& steps);
  [[nodiscard]] Refusal require_kept_constraints();
  [[nodiscard]] Refusal follow(const EditTargets& targets, double budget_seconds,
                               const PullLimit& limit);
  [[nodiscard]] Refusal rest(EditTargets targets, double budget_seconds, const PullLimit& limit);
  [[nodiscard]] Refusal hold(const EditTargets& targets, double budget_seconds,
                             const PullLimit& limit);
  [[nodiscard]] Refusal go_furthest(EditMode first, const EditTargets& targets,
                                    double budget_seconds, const PullLimit& limit);
  void renew_solver();
  void show(const std::vector<int>& moved, const Positions& positions);
  [[nodiscard]] Refusal check_coefficients(const Eigen::VectorXd& coefficients) const;
  /// `positions` projected; a sentence if that fails, with both left as they are.
  [[nodiscard]] Refusal project(Positions& positions, SolveReport& report) const;
  [[nodiscard]] static WorstPanel worst_of(const PlanaritySummary& planarity);
  [[nodiscard]] bool is_base_flat() const { return base_worst_.excess <= options_.tolerance; }
  /// `positions` differ from the base at most at `moved`.
  [[nodiscard]] WorstPanel worst_panel(const Positions& positions,
                                       const std::vector<int>& moved) const;
  [[nodiscard]] double largest_move(const Positions& positions,
                                    const std::vector<int>& moved) const;
  [[nodiscard]] Mesh shown_mesh() const;
  [[nodiscard]] ShapeReport report_of(const Positions& positions, const std::vector<int>& moved,
                                      SolveReport solve, double seconds) const;
  void renew_report(SolveReport solve, double seconds);
  /// Reports a design that nothing had to be solved for.
  void report_unsolved(double seconds);

  Mesh base_;
  std::optional<BaseCuts> cut_;
  Positions before_planarising_;
  std::shared_ptr<const MeshSymmetry> symmetry_;  ///< of the base; null: none was asked for
  Adjacency adjacency_;
  std::vector<std::string> warnings_;
  WorstPanel base_worst_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double scale_ = 1.0;

  HandleEditOptions options_;
  std::optional<HandleEditSolver> solver_;
  std::optional<KeptEdit> kept_;
  EditTargets targets_;
  bool follows_path_ = false;   ///< a drag's frame is shown: others may belong to its targets
  bool lower_at_once_ = false;  ///< the last edit's objective is lower at once than along its path
  std::vector<PointSupport> stated_supports_;  ///< of all edits
  std::vector<PointSupport> supports_;         ///< stated_supports_ with the points that cuts added
  bool supports_fit_ = true;                   ///< they were checked on this base
  bool constraints_fit_ = true;                ///< this base keeps those of options_
  Positions current_;                          ///< 3 × n, the design shown
  std::vector<int> moved_;  ///< ascending: where current_ may differ from the base
  std::vector<int> dirty_;  ///< changed since take_changes(), unsorted
  std::optional<VariationFamily> family_;
  SparseShape projected_;
  ShapeReport projected_report_;
  ShapeReport shape_report_;
  VariationsReport variations_report_;
  Replayed replayed_;
  HybridStanding hybrid_;
  BuildableFewest fewest_found_;
  std::vector<StatedLimit> fair_found_;
  PullHold pull_hold_;
  bool shows_held_ = false;  ///< a frame that was held back shows what held last
  Pulled pulled_;
  Progress progress_;
};

}  // namespace planish
