// SPDX-License-Identifier: MIT
#include "edits.hpp"

#include <string_view>
#include <utility>
#include <variant>

#include "conversion_run.hpp"
#include "design_output.hpp"
#include "edit_options.hpp"
#include "files.hpp"
#include "hybrid_run.hpp"
#include "offset_run.hpp"
#include "planish/design/design_text.hpp"
#include "projection_run.hpp"
#include "replay_run.hpp"
#include "report.hpp"
#include "types_run.hpp"

namespace planish::library {

using cli::CommandError;

namespace {

cli::Arguments arguments_of(const Words& words, const std::vector<cli::OptionRow>& rows) {
  const std::vector<std::string_view> views(words.begin(), words.end());
  return {views, rows};
}

void add(std::vector<std::string>& messages, const std::optional<std::string>& sentence) {
  if (sentence) messages.push_back(*sentence);
}

bool is_json(const std::string& path) { return path.ends_with(".json"); }

std::vector<std::string> edit_messages(const cli::EditRun& run, const cli::Json& report) {
  std::vector<std::string> messages;
  add(messages, cli::planarised_sentence(run.base));
  add(messages, cli::moved_support_sentence(run));
  add(messages, cli::evened_sentence(run));
  add(messages, cli::damage_sentence(report["spoilt_faces"]));
  add(messages, cli::outcome_sentence(run.report));
  add(messages, cli::fewest_sentence(run));
  if (run.splits) add(messages, cli::splits_sentence(*run.splits, run.report));
  add(messages, cli::shortfall_sentence(run));
  return messages;
}

/// A run whose design holds the base, also where that came as arrays.
cli::EditRun with_source(const Edit& edit) {
  cli::EditRun run = edit.run;
  run.source = complete_source(*edit.given);
  return run;
}

}  // namespace

Edit make_edit(std::shared_ptr<const OpenMesh> mesh, const Words& words, const Progress& progress) {
  const cli::Arguments arguments = arguments_of(words, cli::edit_command_rows());
  // Not in the braces of `edit`: g++ 12 destroys its members twice where an initializer throws.
  const HandleEditOptions options = cli::edit_options(arguments);
  Edit edit{mesh, {}, options};
  edit.run =
      cli::run_edit(arguments, edit.options, {mesh->mesh, mesh->source, {}}, mesh->name, progress);
  return edit;
}

Shape shape_of(const Edit& edit) {
  const cli::Json report = cli::edit_json(edit.run, edit.run.edited, edit.options.engine);
  return {edit.run.base.mesh, edit.run.edited, report.dump(2), edit_messages(edit.run, report)};
}

Design design_of(const Edit& edit) {
  return cli::make_design(with_source(edit), edit.options, {}, edit.run.edited);
}

std::string bytes_of(const Edit& edit, const std::string& name) {
  if (is_json(name)) return bytes_of(design_of(edit), name);
  return cli::edit_bytes(name, edit.run, edit.run.edited, design_of(edit));
}

EditFamily make_family(std::shared_ptr<const Edit> edit, const Words& words,
                       const Progress& progress) {
  const cli::Arguments arguments = arguments_of(words, cli::family_option_rows());
  const SubspaceOptions options = cli::subspace_options(arguments, edit->options);
  if (edit->run.symmetry) {
    throw CommandError(cli::kWrongUsage, "symmetry: variations do not keep it");
  }
  return {edit, cli::find_family(edit->run, edit->options, options, arguments, progress)};
}

EditVariation make_variation(std::shared_ptr<const EditFamily> family, const Words& words) {
  const cli::Arguments arguments = arguments_of(words, cli::family_option_rows());
  const Eigen::VectorXd values = cli::coefficients(arguments, family->family.options.dimension);
  cli::Variation shown = cli::with_sliders(family->edit->run, family->family, values);
  return {std::move(family), std::move(shown)};
}

EditVariation make_exact(const EditVariation& variation, const Progress& progress) {
  const cli::Family& family = variation.of->family;
  const cli::EditRun& run = variation.of->edit->run;
  // Exact already: the same sliders give the same mesh.
  if (variation.variation.exact) return variation;
  return {variation.of, cli::make_exact(run, family, variation.variation, progress)};
}

Shape shape_of(const EditVariation& variation) {
  const cli::EditRun& run = variation.of->edit->run;
  const cli::Family& family = variation.of->family;
  const cli::Json report = cli::exploration_json(run, family, variation.variation);
  Shape shape{run.base.mesh, variation.variation.positions, report.dump(2),
              edit_messages(run, report)};
  add(shape.messages, cli::not_exact_sentence(run, family, variation.variation));
  add(shape.messages, cli::exact_outcome_sentence(variation.variation));
  return shape;
}

Design design_of(const EditVariation& variation) {
  return cli::variation_design(with_source(*variation.of->edit), variation.of->family,
                               variation.variation);
}

std::string bytes_of(const EditVariation& variation, const std::string& name) {
  if (is_json(name)) return bytes_of(design_of(variation), name);
  const cli::EditRun& run = variation.of->edit->run;
  const cli::Family& family = variation.of->family;
  return cli::edit_bytes(name, run, variation.variation.positions, design_of(variation),
                         variations_of(family.subspace));
}

Shape make_projection(const OpenMesh& mesh, const Words& words, const OpenMesh* reference,
                      const Progress& progress) {
  const cli::Arguments arguments = arguments_of(words, cli::projection_option_rows());
  const ProjectionOptions options = cli::projection_options(arguments);
  const cli::ProjectedMesh made = cli::make_flat(mesh.mesh, arguments, options,
                                                 reference ? &reference->mesh : nullptr, progress);
  const ProjectionResult& result = made.result;
  cli::Json report = cli::projection_json(
      made.mesh, reference != nullptr ? reference->mesh : made.mesh, result, options);
  cli::add_hybrid(report, made);
  Shape shape{made.mesh, cli::projected(made.mesh, result), report.dump(2), {}};
  add(shape.messages, cli::damage_sentence(report["spoilt_faces"]));
  add(shape.messages, cli::not_flat_sentence(result, options));
  add(shape.messages, cli::hybrid_sentence(made));
  add(shape.messages, cli::lost_height_sentence(made.mesh, result));
  add(shape.messages, cli::confined_sentence(result));
  add(shape.messages, cli::outcome_sentence(result.report));
  return shape;
}

std::string bytes_of(const Shape& shape, const std::string& name) {
  Mesh mesh = shape.base;
  mesh.positions = shape.positions;
  GlbContent content;
  content.base = shape.base.positions;
  return cli::mesh_bytes(name, mesh, content);
}

Shape make_offset(const OpenMesh& mesh, const Words& words) {
  const cli::Arguments arguments = arguments_of(words, cli::offset_option_rows());
  const OffsetOptions options = cli::offset_options(arguments);
  auto result = offset_mesh(mesh.mesh, options);
  if (const auto* why = std::get_if<std::string>(&result)) cli::refuse_file(mesh.name, *why);
  auto& offset = std::get<MeshOffset>(result);
  const cli::Json report = cli::offset_json(mesh.mesh, offset, options.distance);
  std::vector<std::string> messages = cli::offset_sentences(mesh.mesh, offset);
  return {mesh.mesh, std::move(offset.positions), report.dump(2), std::move(messages)};
}

cli::MobilityRun make_mobility(const OpenMesh& mesh, const Words& words) {
  const cli::Arguments arguments = arguments_of(words, cli::mobility_option_rows());
  return {mesh.mesh, arguments, mesh.name, {}};
}

MeshTypes make_types(const OpenMesh& mesh, const Words& words) {
  const cli::Arguments arguments = arguments_of(words, cli::types_option_rows());
  cli::ShopInput input{mesh.mesh, std::nullopt, cli::model_unit(arguments)};
  input.name = mesh.name;
  cli::read_shop_options(arguments, input);
  CuttingPlan plan = cli::plan_types(arguments, input);
  const cli::Json report = cli::types_json(plan);
  std::vector<std::string> messages = cli::types_sentences(plan, input.tolerance);
  return {std::move(plan), report.dump(2), std::move(messages)};
}

std::string bytes_of(const MeshTypes& types, const std::string& name) {
  return cli::types_bytes(name, types.plan);
}

cli::OpenedDesign design_of_text(const std::string& text) {
  auto design = read_design(text);
  if (const auto* sentence = std::get_if<std::string>(&design)) {
    throw CommandError(cli::kInvalidMesh, *sentence);
  }
  return {std::get<Design>(std::move(design)), std::nullopt};
}

Replayed make_replay(const cli::OpenedDesign& opened, const OpenMesh* base,
                     const Progress& progress) {
  const Mesh* given = base ? &base->mesh : opened.base ? &*opened.base : nullptr;
  auto result = replay(opened.design, given, progress);
  if (const auto* sentence = std::get_if<std::string>(&result)) {
    throw CommandError(cli::kInvalidMesh, *sentence);
  }
  Replayed replayed{opened.design, std::get<Replay>(std::move(result)), {}};
  const Replay& done = replayed.replay;
  replayed.shape = {done.base, done.shape, cli::replay_json(opened.design, done).dump(2), {}};
  add(replayed.shape.messages, cli::outcome_sentence(done.report));
  add(replayed.shape.messages, cli::deviation_sentence(opened.design, done));
  replayed.design.result = done.mark;
  return replayed;
}

std::string bytes_of(const Replayed& replayed, const std::string& name) {
  if (is_json(name)) return bytes_of(replayed.design, name);
  return cli::shape_bytes(name, replayed.design, replayed.replay);
}

std::string bytes_of(const Design& design, const std::string& name) {
  if (!is_json(name)) {
    throw CommandError(cli::kWrongUsage, name + ": the extension of a design must be .json");
  }
  return write_design(design) + "\n";
}

std::vector<cli::OptionRow> option_rows(const std::string& command) {
  if (command == "edit") return cli::edit_command_rows();
  if (command == "explore") return cli::family_option_rows();
  if (command == "project") return cli::projection_option_rows();
  if (command == "offset") return cli::offset_option_rows();
  if (command == "mobility") return cli::mobility_option_rows();
  if (command == "convert") return cli::conversion_option_rows();
  if (command == "types") return cli::types_option_rows();
  throw CommandError(
      cli::kWrongUsage,
      "there is no command \"" + command +
          "\" with options; use edit, explore, project, offset, mobility, convert or types");
}

}  // namespace planish::library
