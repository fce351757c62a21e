// SPDX-License-Identifier: MIT
#include <optional>

#include "commands.hpp"
#include "projected_mesh.hpp"
#include "projection_run.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

ExitCode run_project(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  const ProjectionOptions options = projection_options(arguments);
  const Mesh mesh = load_mesh(arguments.only_positional("MESH")).mesh;
  std::optional<Mesh> reference;
  if (const auto path = arguments.value("--reference")) reference = load_mesh(*path).mesh;
  const Mesh* const base = reference ? &*reference : nullptr;
  const ProjectedMesh made = make_flat(mesh, arguments, options, base, progress_line());
  clear_progress_line();
  if (output) {
    save_bytes(*output, moved_mesh_bytes(*output, made.mesh, projected(made.mesh, made.result)));
  }
  const Json json = projected_json(made, base, options);
  print_messages(projected_messages(made, json, options, arguments));
  save_report(arguments, json);
  return exit_code(made.result.report);
}

}  // namespace

Command project_command() {
  std::vector<OptionRow> rows = projection_option_rows();
  rows.insert(rows.end(), {output_row(), kReportRow});
  return {"project", "MESH [--reference BASE] [options] [-o OUT] [--report R.json]",
          "make every panel flat, close by and fair", rows, run_project};
}

}  // namespace planish::cli
