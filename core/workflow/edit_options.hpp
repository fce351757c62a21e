// SPDX-License-Identifier: MIT
/// The options and targets that `edit`, `explore` and `project` have in common.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/design/design.hpp"
#include "planish/edit/design_words.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "request.hpp"

namespace planish::workflow {

/// Rows of the option table for handles, pins, weights, fairness and solver.
[[nodiscard]] std::vector<OptionRow> edit_option_rows();

/// edit_option_rows() and what `edit` and `explore` know: --cut and --symmetry.
[[nodiscard]] std::vector<OptionRow> edit_command_rows();

/// The share that --within-handle asks for, as it was without. Throws UsageError.
void set_within_handle(const Request& request, double& share);

[[nodiscard]] HandleEditOptions edit_options(const Request& request);

/// The kinds kept beside planarity, each with its own tolerance where none is given: "circular" or
/// "circular:1e-6".
/// @param planar mm/m; set by "planar:TOL"
[[nodiscard]] std::vector<KeptConstraint> parse_constraints(const Request& request, double& planar);

inline constexpr OptionRow kConstraintRow = {
    "--constraint", "KIND[:TOL]",
    "beside planar, which is always on: circular (opposite angles of a panel\n"
    "add up to 180°) or conical (ω1 + ω3 = ω2 + ω4 around a point), to TOL\n"
    "degrees, default 1e-9; repeatable"};

[[nodiscard]] OptionRow support_row();

/// What --support asks for, in the order given; rules are find_problem()'s. Throws RequestError for
/// a text that is no support.
[[nodiscard]] std::vector<PointSupport> parse_supports(const Request& request);

/// One of a few words, each with its meaning. Throws UsageError.
template <class Value, std::size_t kCount>
Value parse_word(std::string_view text, std::string_view what, const Words<Value, kCount>& words) {
  std::string known;
  for (const auto& [word, value] : words) {
    if (word == text) return value;
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  throw UsageError(std::string(what) + ": \"" + std::string(text) + "\" is none of " + known);
}

/// Sets `value` where `option` is given. Throws UsageError.
template <class Value>
void read_word(const Request& request, std::string_view option, Value& value) {
  if (const auto text = request.value(option)) value = parse_word(*text, option, words_for(value));
}

/// All of "V,V,...", in every place that the option is given. Throws UsageError.
[[nodiscard]] std::vector<int> parse_vertices(const Request& request, std::string_view option);
/// Throws UsageError that names `option` unless `mesh` has all of `vertices`.
void check_vertices(const std::vector<int>& vertices, std::string_view option, const Mesh& mesh);

/// What --bound asks for.
struct Bounds {
  bool keep_shape = true;  ///< the last of shape=on|off; on without any
  std::vector<StatedLimit> limits;
  std::optional<double> flat;  ///< mm/m, > 0: flat=H, which project alone knows
};

/// Throws RequestError for a text that is no bound.
[[nodiscard]] Bounds parse_bounds(const Request& request);

}  // namespace planish::workflow
