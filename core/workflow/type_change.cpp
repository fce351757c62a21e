// SPDX-License-Identifier: MIT
#include "type_change.hpp"

#include <string_view>

#include "lengths.hpp"
#include "planish/fabrication/flat_panel.hpp"
#include "planish/fabrication/joints.hpp"
#include "planish/fabrication/panel_types.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/text/number.hpp"

namespace planish::workflow {
namespace {

std::size_t count_types(const Mesh& mesh, double within, bool mirrored) {
  std::vector<FlatPanel> panels;
  for (int f = 0; f < mesh.face_count(); ++f) {
    panels.push_back(flatten_panel(mesh.positions, mesh.face(f), 0));
  }
  TypeOptions options;
  options.within = within;
  options.mirrored = mirrored;
  return find_panel_types(panels, joint_table(mesh), options).types.size();
}

std::string types_words(const Json& count) {
  return count.dump() + (count == 1 ? " type" : " types");
}

}  // namespace

std::vector<OptionRow> type_counting_rows() {
  return {{"--count-types", "D|P%",
           "how many types of panels there are before and after, in the report and in\n"
           "a line: panels are of one type whose corners are within D (units of the\n"
           "mesh) of its template's, or within a share of the mean edge"},
          {"--mirrored", "", "for --count-types: a panel may be its template turned over"}};
}

std::optional<TypeCounting> type_counting(const Request& request) {
  const Json* within = request.last("--count-types");
  if (within == nullptr) {
    if (request.has("--mirrored")) {
      throw UsageError("--mirrored is for --count-types: there is none");
    }
    return std::nullopt;
  }
  const std::string text = text_of(*within);
  TypeCounting counting;
  counting.is_share = text.ends_with('%');
  counting.within =
      counting.is_share
          ? 0.01 * parse_finite(std::string_view(text).substr(0, text.size() - 1), "--count-types")
          : parse_length(*within, "--count-types", model_unit(request));
  if (!(counting.within > 0.0)) throw UsageError("--count-types must be greater than 0");
  counting.mirrored = request.has("--mirrored");
  return counting;
}

Json type_change_json(const TypeCounting& counting, const Mesh& mesh, const Positions& after) {
  // One length for both, so that they count alike.
  const double within = counting.within * (counting.is_share ? mean_edge_length(mesh) : 1.0);
  Mesh edited = mesh;
  edited.positions = after;
  return {{"panels", mesh.face_count()},
          {"within", within},
          {"mirrored", counting.mirrored},
          {"before", count_types(mesh, within, counting.mirrored)},
          {"after", count_types(edited, within, counting.mirrored)}};
}

std::string type_change_sentence(const Json& change) {
  return "panels are of " + types_words(change["after"]) + ", " + change["before"].dump() +
         " before: alike within " + three_digits(change["within"].get<double>()) +
         " (units of the mesh)";
}

}  // namespace planish::workflow
