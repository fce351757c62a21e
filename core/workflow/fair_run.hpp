// SPDX-License-Identifier: MIT
/// What `--fair` of an edit takes and tells.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/constraints/stated_limit.hpp"
#include "planish/design/design_steps.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

inline constexpr std::string_view kFairOption = "--fair";

[[nodiscard]] OptionRow fair_option_row();

/// Whether --fair is given. Throws UsageError where another option does not go with it.
[[nodiscard]] bool asks_for_fair(const Request& request);

/// The mesh of an edit, and what it is told of.
struct FairTask {
  const Mesh& base;
  const Positions& given;              ///< slivers are told of it
  const std::vector<Handle>& handles;  ///< as stated
};

/// The limits that cost the handles nothing, beside those of the options.
struct FairSolve {
  std::vector<StatedLimit> found;
  HandleEditResult result;
};

/// The edit of `steps` with the limits that cost its handles nothing, of those that nobody stated.
/// @param options of the steps: what was found is added
[[nodiscard]] FairSolve solve_fairly(const FairTask& task, const DesignSteps& steps,
                                     HandleEditOptions& options, const Progress& progress);

[[nodiscard]] Json fair_json(const std::vector<StatedLimit>& found);

/// The limits that were found; nullopt where there are none.
[[nodiscard]] std::optional<std::string> fair_sentence(const std::vector<StatedLimit>& found);

}  // namespace planish::workflow
