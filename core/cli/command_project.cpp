// SPDX-License-Identifier: MIT
#include <optional>

#include "commands.hpp"
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
  const ProjectionResult result =
      run_projection(mesh, arguments, options, reference ? &*reference : nullptr, progress_line());
  clear_progress_line();
  if (output) {
    Mesh flat = mesh;
    flat.positions = projected(mesh, result);
    GlbContent content;
    content.base = mesh.positions;
    save_mesh(*output, flat, content);
  }
  const Json json = projection_json(mesh, reference ? *reference : mesh, result, options);
  print_sentence(damage_sentence(json["spoilt_faces"]));
  print_sentence(not_flat_sentence(result, options));
  print_sentence(lost_height_sentence(mesh, result));
  print_sentence(confined_sentence(result));
  print_sentence(outcome_sentence(result.report));
  save_report(arguments, json);
  return exit_code(result.report);
}

}  // namespace

Command project_command() {
  std::vector<OptionRow> rows = projection_option_rows();
  rows.insert(rows.end(), {kOutputRow, kReportRow});
  return {"project", "MESH [--reference BASE] [options] [-o OUT] [--report R.json]",
          "make every panel flat, close by and fair", rows, run_project};
}

}  // namespace planish::cli
