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
  const ProjectedMesh made =
      make_flat(mesh, arguments, options, reference ? &*reference : nullptr, progress_line());
  const ProjectionResult& result = made.result;
  clear_progress_line();
  if (output) {
    Mesh flat = made.mesh;
    flat.positions = projected(made.mesh, result);
    GlbContent content;
    content.base = made.mesh.positions;
    save_mesh(*output, flat, content);
  }
  Json json = projection_json(made.mesh, reference ? *reference : made.mesh, result, options);
  add_projected(json, made);
  print_sentence(damage_sentence(json["spoilt_faces"]));
  print_sentence(not_flat_sentence(result, options));
  print_sentence(projected_sentence(made));
  print_sentence(lost_height_sentence(made.mesh, result));
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
