// SPDX-License-Identifier: MIT
#include "types_run.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "lengths.hpp"
#include "mesh_files.hpp"
#include "planish/fabrication/type_table.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/numeric/index.hpp"
#include "planish/text/number.hpp"

namespace planish::workflow {
namespace {

/// Where nothing is asked for: a thousandth of the mean edge, 1.5 mm on a panel of 1.5 m.
constexpr double kDefaultShare = 0.001;

/// "MIN:MAX", or [MIN, MAX].
JointRange parsed_joint(const Json& stated, const std::string& unit) {
  if (stated.is_array() && stated.size() == 2) {
    return {parse_length(stated[0], "--joint", unit), parse_length(stated[1], "--joint", unit)};
  }
  const std::string text = text_of(stated);
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) throw UsageError("--joint: \"" + text + "\" is not MIN:MAX");
  return {parse_length(text.substr(0, colon), "--joint", unit),
          parse_length(text.substr(colon + 1), "--joint", unit)};
}

Json sizes_json(const std::vector<PanelType>& types) {
  Json sizes = Json::array();
  for (const PanelType& type : types) sizes.push_back(type.panels.size());
  return sizes;
}

Json panels_json(const PanelTypes& types) {
  double worst = 0.0;
  for (const PanelType& type : types.types) worst = std::max(worst, type.worst);
  Json json = {{"panels", types.panels.size()},
               {"types", types.types.size()},
               {"within", types.within},
               {"mirrored", types.options.mirrored},
               {"worst_fit", worst},
               {"sizes", sizes_json(types.types)}};
  const bool any = !types.seams.empty();
  json["joint"] = any ? Json{{"min", types.widths.min}, {"max", types.widths.max}} : Json();
  return json;
}

Json template_json(const PanelType& type, int number) {
  return {{"type", type_name(number)},
          {"count", type.panels.size()},
          {"worst_fit", type.worst},
          {"outline",
           std::vector<double>(type.outline.data(), type.outline.data() + type.outline.size())},
          {"panels", type.panels}};
}

Json seam_json(const CuttingPlan& plan, const SeamWidth& seam) {
  const Joint& joint = plan.joints.joints[at(seam.joint)];
  return {{"edge", edge_name(seam.joint)},
          {"panels", plan.options.names.of(std::vector{joint.first.panel, joint.second.panel})},
          {"joint_min", seam.min},
          {"joint_max", seam.max}};
}

}  // namespace

void read_shop_options(const Request& request, ShopInput& input) {
  if (request.has("--model-unit")) input.model_unit = model_unit(request);
  request.read("--tolerance", input.tolerance);
}

std::vector<OptionRow> types_option_rows() {
  return {
      {"--joint", "MIN:MAX",
       "between which widths joints may vary when one template a type is\n"
       "cut; decides what panels may have one"},
      {"--within", "D|P%",
       "how far a corner may be from the template's, or a share of the\n"
       "mean edge; default 0.1%"},
      {"--mirrored", "", "a panel may be its template turned over"},
      {"--angle", "DEG", "how far angles at nodes and bars of a type may differ; default 0.5"},
      {"--unit", "UNIT", "of all lengths here: mm (default), cm, m, km, in or ft"},
      {"--model-unit", "UNIT", "of the coordinates; default the design's, or m"},
      {"--tolerance", "MM_PER_M", "up to which a panel is flat; default the design's, or 1e-6"}};
}

TypeOptions type_options(const Request& request, const Mesh& mesh, const std::string& model_unit,
                         const std::string& unit) {
  const double scale = metres_in(model_unit).value() / metres_in(unit).value();
  const double mean_edge = scale * mean_edge_length(mesh);
  TypeOptions options;
  options.within = kDefaultShare * mean_edge;
  options.mirrored = request.has("--mirrored");
  const Json* joint = request.last("--joint");
  const Json* within = request.last("--within");
  if (joint != nullptr && within != nullptr) {
    throw UsageError("--joint and --within: give one, either says the other");
  }
  if (joint != nullptr) options.joint = parsed_joint(*joint, unit);
  if (within != nullptr) options.within = parse_length(*within, "--within", unit, mean_edge);
  request.read("--angle", options.degrees);
  if (const auto problem = find_problem(options)) throw UsageError(*problem);
  return options;
}

void check_types_name(const std::string& name) {
  if (name != "-" && extension_of(name) != "csv") {
    throw UsageError(name + ": types are written as a table, .csv");
  }
}

CuttingPlan plan_types(const Request& request, const ShopInput& input) {
  CuttingOptions cutting;
  cutting.name = input.name;
  cutting.model_unit = input.model_unit;
  cutting.names = input.names;
  if (const auto unit = request.value("--unit")) cutting.unit = *unit;
  if (const auto problem = find_problem(cutting, input.mesh, false)) throw UsageError(*problem);
  cutting.types = type_options(request, input.mesh, cutting.model_unit, cutting.unit);
  return make_cutting_plan(input.mesh, nullptr, cutting);
}

Json types_json(const CuttingPlan& plan) {
  const StructureTypes& types = plan.types.value();
  const PanelTypes& panels = types.panels;
  const PlanaritySummary planarity = planarity_summary(plan.mesh);
  Json json = {{"status", "done"}, {"unit", plan.options.unit}};
  json["planarity_mm_per_m"] = {{"max", planarity.max}, {"mean", planarity.mean}};
  json["types"] = panels_json(panels);
  json["nodes"] = {{"nodes", plan.vertex_of_node.size()},
                   {"types", types.nodes.sizes.size()},
                   {"within_degrees", panels.options.degrees},
                   {"sizes", types.nodes.sizes},
                   {"of_vertex", types.nodes.of_vertex}};
  json["bars"] = {{"bars", types.bars.of_joint.size()},
                  {"types", types.bars.sizes.size()},
                  {"within", panels.within},
                  {"within_degrees", panels.options.degrees},
                  {"sizes", types.bars.sizes},
                  {"of_edge", types.bars.of_joint}};
  json["templates"] = Json::array();
  for (std::size_t k = 0; k < panels.types.size(); ++k) {
    json["templates"].push_back(template_json(panels.types[k], static_cast<int>(k)));
  }
  json["seams"] = Json::array();
  for (const SeamWidth& seam : panels.seams) json["seams"].push_back(seam_json(plan, seam));
  json["mesh"] = mesh_json(plan.mesh);
  return json;
}

std::string types_bytes(const std::string& name, const CuttingPlan& plan) {
  check_types_name(name);
  return type_table(plan).csv;
}

std::string type_count_sentence(const CuttingPlan& plan) {
  const StructureTypes& types = plan.types.value();
  const auto among = [](std::size_t kinds, std::size_t all, const char* what) {
    return std::to_string(kinds) + " types of " + std::to_string(all) + what;
  };
  return among(types.panels.types.size(), types.panels.panels.size(), " panels, ") +
         among(types.nodes.sizes.size(), plan.vertex_of_node.size(), " nodes, ") +
         among(types.bars.sizes.size(), types.bars.of_joint.size(), " bars");
}

std::vector<std::string> types_sentences(const CuttingPlan& plan, double tolerance) {
  std::vector<std::string> sentences;
  const PlanaritySummary planarity = planarity_summary(plan.mesh);
  if (planarity.max_excess > tolerance) {
    sentences.push_back("not flat: a panel is out of its plane by " + three_digits(planarity.max) +
                        " mm/m; its outline is not exact: use planish project first");
  }
  return sentences;
}

}  // namespace planish::workflow
