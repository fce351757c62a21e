// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "files.hpp"
#include "planish/mesh/triangle_pairs.hpp"

namespace planish::cli {
namespace {

ExitCode run_convert(const Arguments& arguments) {
  const std::string input = arguments.only_positional("IN");
  const auto output = arguments.value("-o");
  if (!output) throw CommandError(kWrongUsage, "-o OUT is missing");
  check_output_name(*output);
  const Mesh mesh = load_mesh(input).mesh;
  save_mesh(*output, arguments.has("--join-triangles") ? join_triangles(mesh) : mesh);
  return kDone;
}

}  // namespace

Command convert_command() {
  return {"convert",
          "IN -o OUT",
          "another format, the same bits",
          {kOutputRow, {"--join-triangles", "", "two by two into the quads that a program split"}},
          run_convert};
}

}  // namespace planish::cli
