// SPDX-License-Identifier: MIT
#include <string>
#include <variant>

#include "commands.hpp"
#include "design_input.hpp"
#include "offset_run.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

ExitCode run_offset(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  const OffsetOptions options = offset_options(arguments);
  const std::string path = arguments.only_positional("MESH");
  const Mesh mesh = load_mesh(path).mesh;
  auto result = offset_mesh(mesh, options);
  if (const auto* why = std::get_if<std::string>(&result)) refuse_file(path, *why);
  const auto& offset = std::get<MeshOffset>(result);
  Mesh moved = mesh;
  moved.positions = offset.positions;
  if (output) save_mesh(*output, moved);
  print_messages(offset_sentences(mesh, offset));
  save_report(arguments, offset_json(mesh, offset, options.distance));
  return is_flat(mesh, offset) ? kDone : kToleranceNotMet;
}

}  // namespace

Command offset_command() {
  std::vector<OptionRow> rows = offset_option_rows();
  rows.insert(rows.end(), {output_row(), kReportRow});
  return {"offset", "MESH --distance D [--kind KIND] [-o OUT] [--report R.json]",
          "the mesh at a distance, every edge parallel to its own", rows, run_offset};
}

}  // namespace planish::cli
