// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

ExitCode run_info(const Arguments& arguments) {
  const Json json = info_json(load_mesh(arguments.only_positional("MESH")));
  save_bytes(arguments.value("--report").value_or("-"), json.dump(2) + "\n");
  return kDone;
}

}  // namespace

Command info_command() {
  return {"info", "MESH [--report R.json]", "figures of a mesh, as JSON", {kReportRow}, run_info};
}

}  // namespace planish::cli
