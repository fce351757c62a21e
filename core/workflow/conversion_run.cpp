// SPDX-License-Identifier: MIT
#include "conversion_run.hpp"

#include <optional>
#include <utility>
#include <variant>

#include "planish/mesh/mesh_check.hpp"
#include "planish/mesh/orientation.hpp"
#include "planish/mesh/point_joining.hpp"
#include "planish/mesh/triangle_pairs.hpp"

namespace planish::workflow {
namespace {

void join_own_points(const std::string& within, Converted& converted) {
  std::optional<double> distance;
  if (!within.empty()) distance = parse_finite(within, "--join-points");
  ReadResult result = join_points(converted.mesh, distance);
  if (const auto* error = std::get_if<ReadError>(&result)) {
    throw MeshError("--join-points: " + error->message);
  }
  auto& file = std::get<MeshFile>(result);
  for (std::string& warning : file.warnings) converted.messages.push_back(std::move(warning));
  converted.mesh = std::move(file.mesh);
}

void turn_panels(Converted& converted) {
  const auto said = orientation_warning(converted.mesh);
  Oriented result = oriented(std::move(converted.mesh));
  // What was said of panels that do not agree is mended, but where the surface has one side only.
  if (said && !orientation_warning(result.mesh)) std::erase(converted.messages, *said);
  converted.messages.push_back(std::to_string(result.turned) + (result.turned == 1
                                                                    ? " panel was turned over"
                                                                    : " panels were turned over"));
  converted.mesh = std::move(result.mesh);
}

}  // namespace

std::vector<OptionRow> conversion_option_rows() {
  return {{"--join-points", "[WITHIN]", "that panels have of their own, at one place or so near"},
          {"--orient", "", "turns panels until neighbours agree, the outside out or up"},
          {"--join-triangles", "", "two by two into the quads that a program split"}};
}

Converted run_conversion(Mesh mesh, const Request& request) {
  Converted converted{std::move(mesh), {}};
  if (const auto within = request.value("--join-points")) join_own_points(*within, converted);
  if (request.has("--orient")) turn_panels(converted);
  if (request.has("--join-triangles")) converted.mesh = join_triangles(converted.mesh);
  return converted;
}

}  // namespace planish::workflow
