// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <variant>

#include "commands.hpp"
#include "cut_run.hpp"
#include "files.hpp"
#include "shop_input.hpp"

namespace planish::cli {
namespace {

ExitCode run_cut(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  const std::vector<Cut> cuts = asked_cuts(arguments);
  const Mesh mesh = load_shop_input(arguments).mesh;
  auto made = cut_mesh(mesh, cuts);
  if (const auto* why = std::get_if<std::string>(&made)) throw CommandError(kWrongUsage, *why);
  const auto& result = std::get<CutMesh>(made);
  if (output) save_mesh(*output, result.mesh);
  print_sentence(loose_points_sentence(mesh, result.mesh));
  Json json = {{"status", "done"}, {"mesh", mesh_json(result.mesh)}};
  add_cuts(json, result);
  save_report(arguments, json);
  return kDone;
}

}  // namespace

Command cut_command() {
  std::vector<OptionRow> rows = cut_option_rows();
  rows.insert(rows.end(), {kOutputRow, kReportRow});
  return {"cut", "MESH|DESIGN --split F:A,B ... [-o OUT] [--report R.json]",
          "part panels, in the order given; no point moves", rows, run_cut};
}

}  // namespace planish::cli
