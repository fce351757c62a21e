// SPDX-License-Identifier: MIT
/// What `types` takes and tells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/fabrication/cutting_plan.hpp"
#include "planish/mesh/mesh.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

/// What is cut, and what it is compared with.
struct ShopInput {
  Mesh mesh;
  std::optional<Mesh> base;
  std::string model_unit;
  double tolerance = PlanarPolygon::kTolerance;  ///< mm/m, up to which a panel is flat
  /// The name of its file, without folder and extension. Given a value since gcc asks for one in
  /// aggregates.
  std::string name = "";  // NOLINT(readability-redundant-string-init)
  PanelNames names = PanelNames();

  [[nodiscard]] const Mesh* base_or_null() const { return base ? &*base : nullptr; }
};

/// What --model-unit and --tolerance say of `input`, where they are given. Throws RequestError.
void read_shop_options(const Request& request, ShopInput& input);

[[nodiscard]] std::vector<OptionRow> types_option_rows();

/// What options ask for, lengths in `unit`. Throws RequestError.
[[nodiscard]] TypeOptions type_options(const Request& request, const Mesh& mesh,
                                       const std::string& model_unit, const std::string& unit);

/// Throws RequestError where `name` is not that of a table.
void check_types_name(const std::string& name);

/// A plan with types. Throws RequestError.
[[nodiscard]] CuttingPlan plan_types(const Request& request, const ShopInput& input);

[[nodiscard]] Json types_json(const CuttingPlan& plan);

/// The table of types as the file `name`. Throws RequestError.
/// @param plan with types
[[nodiscard]] std::string types_bytes(const std::string& name, const CuttingPlan& plan);

/// How many types of panels, nodes and bars there are. @param plan with types
[[nodiscard]] std::string type_count_sentence(const CuttingPlan& plan);

/// What whoever cuts by these types should know; one sentence each.
[[nodiscard]] std::vector<std::string> types_sentences(const CuttingPlan& plan, double tolerance);

}  // namespace planish::workflow
