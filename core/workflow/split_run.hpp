// SPDX-License-Identifier: MIT
/// What `--split-where-needed` of an edit takes and tells.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/splitting/split_where_needed.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

inline constexpr std::string_view kSplitOption = "--split-where-needed";

[[nodiscard]] OptionRow split_option_row();

/// What --split-where-needed and --within-handle ask for; nullopt without. Throws UsageError,
/// also where another option does not go with it.
[[nodiscard]] std::optional<SplitOptions> split_options(const Request& request);

/// What came of it.
struct SplitRun {
  std::vector<Cut> cuts;  ///< behind those that were asked for
  std::vector<SplitStanding> curve;
  int tried = 0;
  SolveCost cost;  ///< of all that were tried
  bool reached = false;
};

struct SplitSolve {
  SplitRun run;
  HandleEditResult result;  ///< of the mesh after these cuts
};

/// @param base after the cuts that were asked for
/// @param targets with the supports of points that these added, and with their images
/// @param symmetry that the base has; null for none
/// Throws UsageError.
[[nodiscard]] SplitSolve solve_split(const Mesh& base, const EditTargets& targets,
                                     const HandleEditOptions& edit, const SplitOptions& options,
                                     const MeshSymmetry* symmetry, const Progress& progress);

[[nodiscard]] Json splits_json(const SplitRun& run);

/// What so many lines give, of a search that goes on.
[[nodiscard]] std::string standing_sentence(const SplitStanding& standing);

/// How many panels were parted, and whether the handles arrive with that; nullopt where none was
/// needed.
[[nodiscard]] std::optional<std::string> splits_sentence(const SplitRun& run,
                                                         const SolveReport& report);

}  // namespace planish::workflow
