// SPDX-License-Identifier: MIT
#include "split_run.hpp"

#include <utility>

#include "edit_options.hpp"
#include "planish/text/number.hpp"

namespace planish::workflow {

OptionRow split_option_row() {
  return {kSplitOption, "N",
          "where handles stop short: at most N panels are parted along lines\n"
          "between corners, as few as let them arrive; they are cuts of the design"};
}

std::optional<SplitOptions> split_options(const Request& request) {
  if (!request.has(kSplitOption)) return std::nullopt;
  const std::string option(kSplitOption);
  if (request.has("--fewest")) throw UsageError(option + ": it knows no --fewest");
  SplitOptions options;
  request.read(kSplitOption, options.most_cuts);
  if (options.most_cuts < 1) throw UsageError(option + " must be at least 1");
  set_within_handle(request, options.within_handle);
  return options;
}

SplitSolve solve_split(const Mesh& base, const EditTargets& targets, const HandleEditOptions& edit,
                       const SplitOptions& options, const MeshSymmetry* symmetry,
                       const Progress& progress) {
  if (const auto problem = find_problem(options, edit, targets)) {
    throw UsageError(*problem);
  }
  SplitEdit found = split_where_needed(base, targets, edit, options, symmetry, progress);
  return {{std::move(found.cuts), std::move(found.curve), found.solves, found.cost, found.reached},
          std::move(found.result)};
}

Json splits_json(const SplitRun& run) {
  Json curve = Json::array();
  for (const SplitStanding& standing : run.curve) {
    curve.push_back({{"cuts", standing.lines},
                     {"handle_error", standing.handle_error},
                     {"moved_vertices", standing.moved_vertices},
                     {"remade_panels", standing.remade_panels},
                     {"sharpest_fold", standing.sharpest_fold}});
  }
  return {{"tried", run.tried},
          {"factorizations", run.cost.factorizations},
          {"reached", run.reached},
          {"curve", std::move(curve)}};
}

std::string standing_sentence(const SplitStanding& standing) {
  const std::string lines = standing.lines == 0 ? "no panel split"
                                                : std::to_string(standing.lines) +
                                                      (standing.lines == 1 ? " line" : " lines");
  return lines + ": " + three_digits(standing.handle_error) + " short, " +
         std::to_string(standing.remade_panels) + " panels changed, sharpest fold " +
         three_digits(standing.sharpest_fold) + "°";
}

std::optional<std::string> splits_sentence(const SplitRun& run, const SolveReport& report) {
  const std::size_t count = run.cuts.size();
  const std::string parted =
      std::to_string(count) + (count == 1 ? " line parts a panel" : " lines part panels");
  if (run.reached && count == 0) return std::nullopt;
  const std::string option = std::string(kSplitOption) + ": ";
  if (run.reached) return option + parted + ", and the handles arrive";
  if (count == 0) return option + "none that was tried lets a handle come nearer";
  return option + parted + ", and a handle still stops " + three_digits(report.handle_error) +
         " short of its target (units of the mesh)";
}

}  // namespace planish::workflow
