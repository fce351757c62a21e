// SPDX-License-Identifier: MIT
#include "fewer_run.hpp"

#include <numeric>
#include <string>
#include <utility>
#include <variant>

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/numeric/index.hpp"

namespace planish::workflow {
namespace {

constexpr std::string_view kMerge = "--merge";
constexpr std::string_view kCollapse = "--collapse";

/// Two whole numbers with `between` in between.
std::pair<int, int> parse_pair(const std::string& text, char between, std::string_view option,
                               const char* form) {
  const std::size_t place = text.find(between);
  if (place == std::string::npos) {
    throw UsageError(std::string(option) + ": \"" + text + "\" is not " + form);
  }
  const std::string_view view(text);
  return {parse_whole(view.substr(0, place), option), parse_whole(view.substr(place + 1), option)};
}

FewerPanels apply_option(const std::string& option, const std::string& value, const Mesh& mesh,
                         const NearbyOptions& nearby, const Progress& progress) {
  const bool merges = option == kMerge;
  const auto [first, second] =
      merges ? parse_pair(value, ',', option, "F,G") : parse_pair(value, '-', option, "V-W");
  auto made = merges ? merge_panels(mesh, first, second, nearby, progress)
                     : collapse_strip(mesh, first, second, nearby, progress);
  if (const auto* why = std::get_if<std::string>(&made)) {
    throw UsageError(option.substr(2) + "=" + value + ": " + *why);
  }
  return std::get<FewerPanels>(std::move(made));
}

void check_alone(const Request& request) {
  for (const auto& [option, value] : request.options()) {
    const bool known = option == kMerge || option == kCollapse || option == "--reach" ||
                       option == "-o" || option == "--report" || option == "--model-unit";
    if (!known) {
      throw UsageError(option +
                       ": --merge and --collapse move points, and so go "
                       "without cuts and without a design");
    }
  }
}

Json parents_json(const std::vector<int>& parents) {
  Json json = Json::array();
  for (std::size_t f = 0; f < parents.size(); ++f) {
    if (parents[f] == static_cast<int>(f)) continue;
    json.push_back({{"panel", f}, {"parent", parents[f]}, {"name", panel_name(parents[f])}});
  }
  return json;
}

}  // namespace

std::vector<OptionRow> fewer_option_rows() {
  return {{kMerge, "F,G", "panels F and G become one; points around move for it"},
          {kCollapse, "V-W", "the strip of quads across the side from V to W goes, likewise"},
          {"--reach", "R",
           "rings of panels around whose points may move for --merge and\n"
           "--collapse, 0 … 100, default 2; what is beyond keeps its bits"}};
}

bool asks_for_fewer(const Request& request) {
  return request.has(kMerge) || request.has(kCollapse);
}

FewerRun run_fewer(const Request& request, const Mesh& mesh, const Progress& progress) {
  constexpr int kMostReach = 100;
  check_alone(request);
  NearbyOptions nearby;
  request.read("--reach", nearby.reach);
  if (nearby.reach < 0 || nearby.reach > kMostReach) {
    throw UsageError("--reach must be from 0 to 100 rings of panels");
  }
  if (planarity_summary(mesh).max_excess > nearby.tolerance) {
    throw MeshError("the mesh is not flat: planish project makes it so");
  }
  FewerRun run{mesh, {{"status", "done"}}};
  Json changes = Json::array();
  std::vector<int> parents(at(mesh.face_count()));
  std::iota(parents.begin(), parents.end(), 0);
  for (const auto& [option, value] : request.options()) {
    if (option != kMerge && option != kCollapse) continue;
    const std::string text = text_of(value);
    FewerPanels fewer = apply_option(option, text, run.mesh, nearby, progress);
    changes.push_back({{"op", option.substr(2) + "=" + text},
                       {"moved_points", fewer.moved},
                       {"max_move", fewer.max_move}});
    for (int& parent : fewer.parents) parent = parents[at(parent)];
    parents = std::move(fewer.parents);
    run.mesh = std::move(fewer.mesh);
  }
  run.report["mesh"] = mesh_json(run.mesh);
  run.report["fewer"] = std::move(changes);
  run.report["panel_parents"] = parents_json(parents);
  return run;
}

}  // namespace planish::workflow
