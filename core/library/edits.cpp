// SPDX-License-Identifier: MIT
#include "edits.hpp"

#include <string_view>
#include <utility>
#include <variant>

#include "base_sentences.hpp"
#include "conversion_run.hpp"
#include "design_output.hpp"
#include "edit_options.hpp"
#include "edit_sentences.hpp"
#include "lengths.hpp"
#include "mesh_files.hpp"
#include "offset_run.hpp"
#include "planish/design/design_text.hpp"
#include "projected_mesh.hpp"
#include "projection_run.hpp"
#include "replay_run.hpp"
#include "report.hpp"
#include "types_run.hpp"

namespace planish::library {

namespace {

bool is_json(const std::string& path) { return path.ends_with(".json"); }

/// Messages about the base, then about what was made of it.
std::vector<std::string> all_messages(const EditRun& run, const std::vector<std::string>& made) {
  std::vector<std::string> messages = base_messages(run);
  messages.insert(messages.end(), made.begin(), made.end());
  return messages;
}

}  // namespace

Edit make_edit(std::shared_ptr<const OpenMesh> mesh, const std::string& asked,
               const Progress& progress) {
  const Request request(asked, edit_command_rows());
  Edit edit{mesh, {}};  // the rest not in its braces, see edit_request()
  edit.run = run_edit(edit_request(request), {mesh->mesh, mesh->source, {}}, mesh->name, progress);
  return edit;
}

Shape shape_of(const Edit& edit) {
  const Json report = edit_json(edit.run, edit.run.edited);
  return {edit.run.base.mesh, edit.run.edited, report.dump(2),
          all_messages(edit.run, edit_messages(edit.run, report))};
}

Design design_of(const Edit& edit) {
  return complete(make_design(edit.run, {}, edit.run.edited), *edit.given);
}

std::string bytes_of(const Edit& edit, const std::string& name) {
  if (is_json(name)) return bytes_of(design_of(edit), name);
  return edit_bytes(name, edit.run, edit.run.edited, design_of(edit));
}

EditFamily make_family(std::shared_ptr<const Edit> edit, const std::string& asked,
                       const Progress& progress) {
  const Request request(asked, family_option_rows());
  FamilyRequest family = family_request(request, edit->run.asked.options);
  if (edit->run.symmetry) throw UsageError("symmetry: variations do not keep it");
  return {edit, find_family(edit->run, std::move(family), progress)};
}

EditVariation make_variation(std::shared_ptr<const EditFamily> family, const std::string& asked) {
  const Request request(asked, family_option_rows());
  const Eigen::VectorXd values = coefficients(request, family->family.asked.options.dimension);
  Variation shown{values, family->family.found.shape_at(values), {}};
  return {std::move(family), std::move(shown)};
}

EditVariation make_exact(const EditVariation& variation, const Progress& progress) {
  const workflow::Family& family = variation.of->family;
  const EditRun& run = variation.of->edit->run;
  // Exact already: the same sliders give the same mesh.
  if (variation.variation.exact) return variation;
  return {variation.of, make_exact(run, family, variation.variation, progress)};
}

Shape shape_of(const EditVariation& variation) {
  const EditRun& run = variation.of->edit->run;
  const workflow::Family& family = variation.of->family;
  const Json report = exploration_json(run, family, variation.variation);
  return {run.base.mesh, variation.variation.positions, report.dump(2),
          all_messages(run, exploration_messages(run, variation.variation, report))};
}

Design design_of(const EditVariation& variation) {
  const Edit& edit = *variation.of->edit;
  return complete(variation_design(edit.run, variation.of->family, variation.variation),
                  *edit.given);
}

std::string bytes_of(const EditVariation& variation, const std::string& name) {
  if (is_json(name)) return bytes_of(design_of(variation), name);
  const EditRun& run = variation.of->edit->run;
  const workflow::Family& family = variation.of->family;
  return edit_bytes(name, run, variation.variation.positions, design_of(variation),
                    variations_of(family.found.subspace));
}

Shape make_projection(const OpenMesh& mesh, const std::string& asked, const OpenMesh* reference,
                      const Progress& progress) {
  const Request request(asked, projection_option_rows());
  const ProjectionOptions options = projection_options(request);
  const Mesh* const base = reference != nullptr ? &reference->mesh : nullptr;
  const ProjectedMesh made = make_flat(mesh.mesh, request, options, base, progress);
  const Json report = projected_json(made, base, options);
  return {made.mesh, projected(made.mesh, made.result), report.dump(2),
          projected_messages(made, report, options, request)};
}

std::string bytes_of(const Shape& shape, const std::string& name) {
  return moved_mesh_bytes(name, shape.base, shape.positions);
}

Shape make_offset(const OpenMesh& mesh, const std::string& asked) {
  const Request request(asked, offset_option_rows());
  const OffsetOptions options = offset_options(request);
  auto result = offset_mesh(mesh.mesh, options);
  if (const auto* why = std::get_if<std::string>(&result)) refuse_file(mesh.name, *why);
  auto& offset = std::get<MeshOffset>(result);
  const Json report = offset_json(mesh.mesh, offset, options.distance);
  std::vector<std::string> messages = offset_sentences(mesh.mesh, offset);
  return {mesh.mesh, std::move(offset.positions), report.dump(2), std::move(messages)};
}

MobilityRun make_mobility(const OpenMesh& mesh, const std::string& asked) {
  const Request request(asked, mobility_option_rows());
  return {mesh.mesh, request, mesh.name, {}};
}

MeshTypes make_types(const OpenMesh& mesh, const std::string& asked) {
  const Request request(asked, types_option_rows());
  ShopInput input{mesh.mesh, std::nullopt, model_unit(request)};
  input.name = mesh.name;
  read_shop_options(request, input);
  CuttingPlan plan = plan_types(request, input);
  const Json report = types_json(plan);
  std::vector<std::string> messages = types_sentences(plan, input.tolerance);
  return {std::move(plan), report.dump(2), std::move(messages)};
}

std::string bytes_of(const MeshTypes& types, const std::string& name) {
  return types_bytes(name, types.plan);
}

OpenedDesign design_of_text(const std::string& text) {
  auto design = read_design(text);
  if (const auto* sentence = std::get_if<std::string>(&design)) throw MeshError(*sentence);
  return {std::get<Design>(std::move(design)), std::nullopt};
}

Replayed make_replay(const OpenedDesign& opened, const OpenMesh* base, const Progress& progress) {
  const Mesh* given = base ? &base->mesh : opened.base ? &*opened.base : nullptr;
  auto result = replay(opened.design, given, progress);
  if (const auto* sentence = std::get_if<std::string>(&result)) throw MeshError(*sentence);
  Replayed replayed{opened.design, std::get<Replay>(std::move(result)), {}};
  const Replay& done = replayed.replay;
  replayed.shape = {done.base, done.shape, replay_json(opened.design, done).dump(2),
                    said({outcome_sentence(done.report), deviation_sentence(opened.design, done)})};
  replayed.design.result = done.mark;
  return replayed;
}

std::string bytes_of(const Replayed& replayed, const std::string& name) {
  if (is_json(name)) return bytes_of(replayed.design, name);
  return shape_bytes(name, replayed.design, replayed.replay);
}

std::string bytes_of(const Design& design, const std::string& name) {
  if (!is_json(name)) throw UsageError(name + ": the extension of a design must be .json");
  return write_design(design) + "\n";
}

std::vector<OptionRow> option_rows(const std::string& command) {
  if (command == "edit") return edit_command_rows();
  if (command == "explore") return family_option_rows();
  if (command == "project") return projection_option_rows();
  if (command == "offset") return offset_option_rows();
  if (command == "mobility") return mobility_option_rows();
  if (command == "convert") return conversion_option_rows();
  if (command == "types") return types_option_rows();
  throw UsageError(
      "there is no command \"" + command +
      "\" with options; use edit, explore, project, offset, mobility, convert or types");
}

}  // namespace planish::library
