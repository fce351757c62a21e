// SPDX-License-Identifier: MIT
/// What `explore` does around an edit: a family, one variation of it, and their report.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "edit_run.hpp"
#include "planish/design/design.hpp"
#include "planish/design/design_steps.hpp"
#include "planish/projection/projection.hpp"
#include "planish/variations/subspace.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] std::vector<OptionRow> family_option_rows();

/// What a family is asked for.
struct FamilyRequest {
  SubspaceOptions options;
  std::vector<int> close;       ///< Ψ: empty, the handles
  double exact_fairness = 0.0;  ///< α_f of the exact projection
};

/// Throws UsageError.
/// @param edit around which it is
[[nodiscard]] FamilyRequest family_request(const Request& request, const HandleEditOptions& edit);

/// Slider values, all 0 without --coefficients.
[[nodiscard]] Eigen::VectorXd coefficients(const Request& request, int dimension);

/// The variations around one edit.
struct Family {
  FamilyRequest asked;
  VariationFamily found;  ///< around run.edited
};

/// Throws UsageError where there is no such vertex.
[[nodiscard]] Family find_family(const EditRun& run, FamilyRequest asked, const Progress& progress);

/// One member of a family.
struct Variation {
  Eigen::VectorXd values;                 ///< of the sliders, options.dimension of them
  Positions positions;                    ///< 3 × n, as they show it until it is made exact
  std::optional<ProjectionResult> exact;  ///< set once it was made exact
};

/// The exact mesh next to `shown`, unmoved vertices of the base staying where they are.
[[nodiscard]] Variation make_exact(const EditRun& run, const Family& family, Variation shown,
                                   const Progress& progress);

[[nodiscard]] Design variation_design(const EditRun& run, const Family& family,
                                      const Variation& variation);

/// The report of `explore`.
[[nodiscard]] Json exploration_json(const EditRun& run, const Family& family,
                                    const Variation& variation);

/// What is said of the edit and of the variation. @param report of exploration_json()
[[nodiscard]] std::vector<std::string> exploration_messages(const EditRun& run,
                                                            const Variation& variation,
                                                            const Json& report);

}  // namespace planish::workflow
