// SPDX-License-Identifier: MIT
#include "projected_mesh.hpp"

#include <utility>

#include "cut_run.hpp"
#include "lengths.hpp"
#include "projection_run.hpp"
#include "repetition_run.hpp"

namespace planish::workflow {
namespace {

constexpr std::string_view kSplit = "--split";

/// "40", or "10%" of all panels.
HybridOptions parse_hybrid(const std::string& text, const Mesh& mesh) {
  HybridOptions options;
  if (text.ends_with('%')) {
    const double share = parse_share(text, kSplit);
    if (!(share > 0.0 && share <= 1.0)) {
      throw UsageError("--split: \"" + text + "\" is not more than 0% to 100%");
    }
    options.most_panels = static_cast<int>(share * mesh.face_count());
  } else {
    options.most_panels = parse_whole(text, kSplit);
  }
  if (options.most_panels < 1) {
    throw UsageError("--split: \"" + text + "\" is less than one panel");
  }
  return options;
}

}  // namespace

OptionRow hybrid_option_row() {
  return {"--split", "N|P%",
          "where no flat mesh is near: at most so many panels are split along\n"
          "lines between corners, the fewest that make it flat and sound"};
}

ProjectedMesh make_flat(const Mesh& mesh, const Request& request, const ProjectionOptions& options,
                        const Mesh* reference, const Progress& progress) {
  if (asks_for_fewer_types(request)) {
    FewerTypes fewer =
        run_fewer_types(mesh, request, options, projection_pins(mesh, request, options), progress);
    ProjectionResult result = projection_of(mesh, fewer);
    return {mesh, std::move(result), std::nullopt, std::move(fewer)};
  }
  const auto split = request.value(kSplit);
  if (!split) {
    return {mesh, run_projection(mesh, request, options, reference, progress), std::nullopt,
            std::nullopt};
  }
  if (reference != nullptr) throw UsageError("--split: it knows no --reference");
  if (const auto problem = find_problem(options.engine, Beyond::kSplits)) {
    throw UsageError(*problem);
  }
  const HybridOptions hybrid = parse_hybrid(*split, mesh);
  const std::vector<int> pins = projection_pins(mesh, request, options);
  HybridMesh found = split_until_flat(mesh, options, pins, hybrid, progress);
  ProjectedMesh projected{found.cut.mesh, std::move(found.result), std::nullopt, std::nullopt};
  found.result = {};
  projected.hybrid = std::move(found);
  return projected;
}

namespace {

/// Types with --move, parts with --split; else nothing.
void add_projected(Json& json, const ProjectedMesh& projected) {
  if (projected.fewer) json["types"] = fewer_types_json(projected.mesh, *projected.fewer);
  if (!projected.hybrid) return;
  Json curve = Json::array();
  for (const HybridStanding& standing : projected.hybrid->curve) {
    curve.push_back({{"panels", standing.panels},
                     {"failing_faces", standing.failing_faces},
                     {"rms_move", standing.rms_move},
                     {"max_move", standing.max_move}});
  }
  json["split"] = {{"panels", projected.hybrid->panels},
                   {"reached", projected.hybrid->reached},
                   {"tried", projected.hybrid->projections},
                   {"curve", std::move(curve)}};
  add_cuts(json, projected.hybrid->cut);
}

/// How many types are left; or how many panels are split, and whether the mesh is flat so.
std::optional<std::string> projected_sentence(const ProjectedMesh& projected) {
  if (projected.fewer) return fewer_types_sentence(projected.mesh, *projected.fewer);
  if (!projected.hybrid || (projected.hybrid->panels == 0 && projected.hybrid->reached)) {
    return std::nullopt;
  }
  if (projected.hybrid->panels == 0)
    return "--split: so few panels split do not make the mesh flat";
  const int count = projected.hybrid->panels;
  return "--split: " + std::to_string(count) + (count == 1 ? " panel is" : " panels are") +
         " split, and the mesh is " + (projected.hybrid->reached ? "flat" : "not flat with that");
}

}  // namespace

Json projected_json(const ProjectedMesh& projected, const Mesh* reference,
                    const ProjectionOptions& options) {
  Json json = projection_json(projected.mesh, reference != nullptr ? *reference : projected.mesh,
                              projected.result, options);
  add_projected(json, projected);
  return json;
}

std::vector<std::string> projected_messages(const ProjectedMesh& projected, const Json& report,
                                            const ProjectionOptions& options,
                                            const Request& request) {
  const ProjectionResult& result = projected.result;
  const std::optional<std::string> lost =
      projected.fewer ? std::nullopt : lost_height_sentence(projected.mesh, result);
  return said({damage_sentence(report["spoilt_faces"]), not_flat_sentence(result, options, request),
               projected_sentence(projected),
               lost ? lost : moved_far_sentence(projected.mesh, result, request),
               confined_sentence(result), outcome_sentence(result.report)});
}

}  // namespace planish::workflow
