// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "files.hpp"
#include "planish/metrics.hpp"
#include "report.hpp"

namespace planish::cli {
namespace {

ExitCode run_info(const Arguments& arguments) {
  const MeshFile file = load_mesh(arguments.only_positional("MESH"));
  const PlanaritySummary planarity = planarity_summary(file.mesh);
  Json json = {{"status", "done"}, {"mesh", mesh_json(file.mesh)}};
  json["planarity_mm_per_m"] = {{"max", planarity.max},
                                {"mean", planarity.mean},
                                {"max_gap", planarity.max_gap},
                                {"worst_face", planarity.worst_face},
                                {"worst_gap", planarity.worst_gap}};
  json["warnings"] = file.warnings;
  save_bytes(arguments.value("--report").value_or("-"), json.dump(2) + "\n");
  return kDone;
}

}  // namespace

Command info_command() {
  return {"info", "MESH [--report R.json]", "figures of a mesh, as JSON", {kReportRow}, run_info};
}

}  // namespace planish::cli
