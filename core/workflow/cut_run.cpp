// SPDX-License-Identifier: MIT
#include "cut_run.hpp"

#include <utility>
#include <variant>

#include "lengths.hpp"
#include "planish/fabrication/cutting_plan.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "planish/numeric/index.hpp"

namespace planish::workflow {
namespace {

constexpr std::string_view kCollar = "--collar";

Cut parsed_cut(const std::string& text, const std::string& unit) {
  auto cut = parse_cut(text.starts_with("trim=") ? plain_lengths(text, unit) : text);
  if (const auto* problem = std::get_if<std::string>(&cut)) throw UsageError(*problem);
  return std::get<Cut>(std::move(cut));
}

void add_collar(std::vector<Cut>& cuts) {
  auto* refine = cuts.empty() ? nullptr : std::get_if<RefineCut>(&cuts.back());
  if (refine == nullptr) throw UsageError("--collar goes behind a --refine");
  refine->collar = true;
}

Json place_json(const AddedPoint& point) {
  if (point.panel >= 0) return {{"point", point.vertex}, {"panel", point.panel}};
  return {{"point", point.vertex}, {"side", {point.from, point.to}}};
}

}  // namespace

std::vector<OptionRow> cut_option_rows() {
  return {{"--split", "F:A,B",
           "panel F along a line from A to B: corners, or V-W@T, a share T\n"
           "of the way along the side from V to W"},
          {"--strip", "V-W[@T]",
           "a line of points through the quads beside the side from V to W\n"
           "(at 0.5), both ways, until the boundary or a panel that is no quad"},
          {"--corner", "F:V[@T]",
           "a triangle off panel F at its corner V, to a share T of the\n"
           "sides there (1: to the next corners)"},
          {"--refine", "F,F,...", "as many quads as a panel has corners, about its middle"},
          {kCollar, "", "behind --refine: panels beside it are split to it"},
          {"--trim", "a,b,c,d", "what is beyond a plane goes: where ax + by + cz > d"}};
}

std::vector<Cut> asked_cuts(const Request& request) {
  const std::string unit = model_unit(request);
  std::vector<Cut> cuts;
  for (const auto& [option, value] : request.options()) {
    if (option == kCollar) {
      add_collar(cuts);
      continue;
    }
    for (const OptionRow& row : cut_option_rows()) {
      if (row.name != option) continue;
      cuts.push_back(parsed_cut(option.substr(2) + "=" + text_of(value), unit));
    }
  }
  if (cuts.empty()) throw UsageError("a cut is missing: there are " + std::string(known_cuts()));
  return cuts;
}

std::vector<Cut> cuts_before_edit(const Request& request) {
  const std::string unit = model_unit(request);
  std::vector<Cut> cuts;
  for (const std::string& text : request.texts("--cut")) cuts.push_back(parsed_cut(text, unit));
  return cuts;
}

void add_cuts(Json& json, const CutMesh& result) {
  json["cuts"] = Json::array();
  for (const CutRecord& record : result.records) {
    json["cuts"].push_back({{"op", cut_text(record.cut)},
                            {"panels", record.panels},
                            {"points", record.points},
                            {"straight_corners", record.straight}});
  }
  const PanelNames names(result.parents);
  json["panel_parents"] = Json::array();
  for (int f = 0; f < result.mesh.face_count(); ++f) {
    if (names.is_own_parent(f)) continue;
    json["panel_parents"].push_back(
        {{"panel", f}, {"parent", result.parents[at(f)]}, {"name", names.of(f)}});
  }
  json["added_points"] = Json::array();
  for (const AddedPoint& point : result.added) json["added_points"].push_back(place_json(point));
}

std::optional<std::string> loose_points_sentence(const Mesh& before, const Mesh& after) {
  const int loose = summarize(after).isolated_vertices - summarize(before).isolated_vertices;
  if (loose <= 0) return std::nullopt;
  return (loose == 1 ? "1 point belongs" : std::to_string(loose) + " points belong") +
         " to no panel any more and stay, so that numbers do";
}

}  // namespace planish::workflow
