// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "commands.hpp"
#include "files.hpp"
#include "planish/mesh/orientation.hpp"
#include "planish/mesh/point_joining.hpp"
#include "planish/mesh/triangle_pairs.hpp"

namespace planish::cli {
namespace {

/// `mesh` with the points joined that its panels have of their own; says how many.
Mesh with_points_joined(const Mesh& mesh, const std::string& within) {
  std::optional<double> distance;
  if (!within.empty()) distance = parse_finite(within, "--join-points");
  ReadResult result = join_points(mesh, distance);
  if (const auto* error = std::get_if<ReadError>(&result)) {
    throw CommandError(kInvalidMesh, "--join-points: " + error->message);
  }
  auto& file = std::get<MeshFile>(result);
  for (const std::string& warning : file.warnings) print_message(warning);
  return std::move(file.mesh);
}

/// `mesh` with neighbours turned to agree; says how many panels were turned.
Mesh with_panels_turned(Mesh mesh) {
  Oriented result = oriented(std::move(mesh));
  print_message(std::to_string(result.turned) +
                (result.turned == 1 ? " panel was turned over" : " panels were turned over"));
  return std::move(result.mesh);
}

ExitCode run_convert(const Arguments& arguments) {
  const std::string input = arguments.only_positional("IN");
  const auto output = arguments.value("-o");
  if (!output) throw CommandError(kWrongUsage, "-o OUT is missing");
  check_output_name(*output);
  Mesh mesh = load_mesh(input).mesh;
  if (const auto within = arguments.value("--join-points")) {
    mesh = with_points_joined(mesh, *within);
  }
  if (arguments.has("--orient")) mesh = with_panels_turned(std::move(mesh));
  save_mesh(*output, arguments.has("--join-triangles") ? join_triangles(mesh) : mesh);
  return kDone;
}

}  // namespace

Command convert_command() {
  return {"convert",
          "IN -o OUT",
          "another format, the same bits",
          {kOutputRow,
           {"--join-points", "[WITHIN]", "that panels have of their own, at one place or so near"},
           {"--orient", "", "turns panels until neighbours agree, the outside out or up"},
           {"--join-triangles", "", "two by two into the quads that a program split"}},
          run_convert};
}

}  // namespace planish::cli
