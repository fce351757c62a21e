// SPDX-License-Identifier: MIT
#include "engines/cold_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace planish {
namespace {

/// Chosen among 84 by their minima on 5 samples and 25 meshes, see docs/decisions: the lines of the
/// mesh lead to wide minima, few rings under a strong smoothing to tight ones.
constexpr std::array<StartSet, 2> kStarts{StartSet{3, 16, 0.05}, StartSet{2, 16, 0.5}};
constexpr double kCoarse = 0.0045;    ///< smoothing at which the race is judged, share
constexpr double kCoarseStop = 1e-3;  ///< relative change of the objective that ends it
constexpr int kCoarseSteps = 60;      ///< a start that takes more rarely wins
constexpr double kPromising = 1.05;   ///< coarse objective, relative to the best, to run on
constexpr double kSameState = 0.05;   ///< of the pull: states that are no farther apart ...
constexpr double kSameHeight = 1e-2;  ///< ... and of about one objective run on to one minimum

struct Contender {
  StartSet start;
  EngineOutcome outcome;
  std::vector<int> support;
  DisplacementField::Snapshot state;
};

/// A contender before it was run on.
struct CoarseState {
  double objective;
  DisplacementField::Snapshot field;
};

class ColdSearch {
 public:
  ColdSearch(const EditProblem& problem, const NewtonOptions& options, WorkingSetNewton& newton,
             DisplacementField& field, const Progress& progress)
      : problem_(problem), options_(options), newton_(newton), field_(field), progress_(progress) {}

  EngineOutcome run() {
    race();
    field_.clear();
    newton_.set_support(problem_.handles);
    if (contenders_.empty()) return total_;
    Contender& winner = problem_.seeks_support ? run_on() : contenders_.front();
    field_.restore(winner.state);
    newton_.set_support(winner.support);
    if (total_.status != SolveStatus::kCancelled) total_.status = winner.outcome.status;
    total_.objective = winner.outcome.objective;
    total_.records = std::move(winner.outcome.records);
    return std::move(total_);
  }

 private:
  /// Every start as far as the coarse smoothing, best first.
  void race() {
    NewtonOptions coarse = options_;
    if (problem_.seeks_support) {
      coarse.last_smoothing = kCoarse;
      coarse.stop = kCoarseStop;
      coarse.max_steps = std::min(options_.max_steps, kCoarseSteps);
    }
    for (const StartSet& start : kStarts) {
      field_.clear();
      Contender contender;
      contender.start = start;
      keep(newton_.run_cold(problem_, start, coarse, field_, progress_), contender);
      if (std::isfinite(contender.outcome.objective) && !contender.outcome.records.empty()) {
        const auto after =
            std::upper_bound(contenders_.begin(), contenders_.end(), contender, &lower);
        contenders_.insert(after, std::move(contender));
      }
      if (!problem_.seeks_support || total_.status == SolveStatus::kCancelled) break;
    }
  }

  /// The promising ones to the last smoothing; the best of those that got there.
  Contender& run_on() {
    NewtonOptions rest = options_;
    rest.first_smoothing = options_.smoothing_shrink * kCoarse;
    const double promising = kPromising * contenders_.front().outcome.objective;
    Contender* winner = nullptr;
    std::vector<CoarseState> run_on_from;
    for (Contender& contender : contenders_) {
      if (total_.status == SolveStatus::kCancelled) break;
      if (winner != nullptr && contender.outcome.objective > promising) break;
      CoarseState coarse{contender.outcome.objective, contender.state};
      const auto same = [&](const CoarseState& other) { return is_same(other, coarse); };
      if (std::any_of(run_on_from.begin(), run_on_from.end(), same)) continue;
      run_on_from.push_back(std::move(coarse));
      field_.restore(contender.state);
      newton_.set_support(contender.support);
      keep(newton_.run_on(problem_, contender.start, rest, field_, progress_), contender);
      const bool valid = std::isfinite(contender.outcome.objective);
      if (valid && (winner == nullptr || lower(contender, *winner))) winner = &contender;
    }
    return winner != nullptr ? *winner : contenders_.front();
  }

  /// Adds the outcome of a run that used field_.
  void keep(EngineOutcome outcome, Contender& contender) {
    total_.cost += outcome.cost;
    if (outcome.status == SolveStatus::kCancelled) total_.status = outcome.status;
    std::vector<IterationRecord> records = std::move(contender.outcome.records);
    records.insert(records.end(), outcome.records.begin(), outcome.records.end());
    contender.outcome = std::move(outcome);
    contender.outcome.records = std::move(records);
    contender.support = newton_.support();
    contender.state = field_.snapshot();
  }

  [[nodiscard]] bool is_same(const CoarseState& a, const CoarseState& b) const {
    return std::abs(a.objective - b.objective) <= kSameHeight * a.objective &&
           farthest_apart(a.field, b.field) <= kSameState * handle_scale(problem_);
  }

  static bool lower(const Contender& a, const Contender& b) {
    return a.outcome.objective < b.outcome.objective;
  }

  const EditProblem& problem_;
  const NewtonOptions& options_;
  WorkingSetNewton& newton_;
  DisplacementField& field_;
  const Progress& progress_;
  std::vector<Contender> contenders_;
  EngineOutcome total_;
};

}  // namespace

EngineOutcome find_minimum(const EditProblem& problem, const NewtonOptions& options,
                           WorkingSetNewton& newton, DisplacementField& field,
                           const Progress& progress) {
  return ColdSearch(problem, options, newton, field, progress).run();
}

}  // namespace planish
