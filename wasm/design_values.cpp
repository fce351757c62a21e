// SPDX-License-Identifier: MIT
#include "design_values.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "analysis.hpp"
#include "arrays.hpp"
#include "planish/constraints/registry.hpp"
#include "planish/design/link_dictionary.hpp"
#include "planish/edit/edit_option_table.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/measures/panel_health.hpp"
#include "session.hpp"

namespace planish {
namespace {

using emscripten::val;

/// "circular:1e-9", the number as JavaScript writes it, so that a link keeps its letters.
std::string constraint_text(const KeptConstraint& one) {
  return one.kind + ":" + val(one.tolerance).call<std::string>("toString");
}

/// @param read what a text says
template <class Item>
std::vector<Item> items_of(const val& texts, Item (*read)(std::string_view)) {
  std::vector<Item> items;
  for (const val& text : emscripten::vecFromJSArray<val>(texts)) {
    items.push_back(read(text.as<std::string>()));
  }
  return items;
}

val option_value(double number) { return val(number); }
val option_value(int number) { return val(number); }
val option_value(bool flag) { return val(flag); }
val option_value(const std::vector<KeptConstraint>& list) { return list_of(list, constraint_text); }
template <class Item>
val option_value(const std::vector<Item>& list) {
  return list_of(list, &TextItem<Item>::text);
}
template <class Value>
val option_value(Value word) {
  return val(std::string(word_of(word, words_for(word))));
}

void take(const val& given, double& value) { value = given.as<double>(); }
/// A link may say anything: what is no whole number becomes -1, which breaks the option's rule.
void take(const val& given, int& value) {
  constexpr double kLargest = 1e9;
  const auto number = given.as<double>();
  const bool is_whole = number >= 0.0 && number <= kLargest && std::floor(number) == number;
  value = is_whole ? static_cast<int>(number) : -1;
}
void take(const val& given, bool& value) { value = given.as<bool>(); }
void take(const val& given, std::vector<KeptConstraint>& value) {
  value = items_of(given, &read_constraint);
}
template <class Item>
void take(const val& given, std::vector<Item>& value) {
  value = items_of(given, &read_item<Item>);
}
template <class Value>
void take(const val& given, Value& value) {
  value = value_of(given.as<std::string>(), words_for(value)).value_or(value);
}

/// The words of an option that is one of a few; null for any other.
template <class Value>
val words_value(Value) {
  return val::null();
}
template <class Value>
requires requires(Value value) { words_for(value); }
val words_value(Value value) {
  return list_of(words_for(value), [](const auto& entry) { return std::string(entry.first); });
}

val source_value(const DesignSource& source) {
  val value = val::object();
  if (const auto* sample = std::get_if<SampleSource>(&source)) {
    value.set("sample", sample->name);
    value.set("size", sample->size);
    return value;
  }
  const auto& file = std::get<FileSource>(source);
  value.set("file", file.name);
  value.set("hash", file.hash ? val(*file.hash) : val::null());
  value.set("format", file.format);
  value.set("bytes", copy(file.bytes));
  return value;
}

DesignSource to_source(const val& value) {
  if (value["sample"].isString()) {
    return SampleSource{value["sample"].as<std::string>(), value["size"].as<int>()};
  }
  return FileSource{.name = value["file"].as<std::string>(),
                    .hash = to_hash(value["hash"]),
                    .format = value["format"].as<std::string>(),
                    .bytes = to_bytes(value["bytes"])};
}

val planarising_value(const Planarising& how) {
  val value = val::object();
  value.set("smooth", how.fairness_weight);
  value.set("keepBoundary", how.keep_boundary);
  value.set("keepShape", how.keep_shape);
  value.set("constraints", list_of(how.constraints, constraint_text));
  value.set("within", how.within);
  value.set("flat", how.flat_within);
  return value;
}

/// Whether the page could have made it.
bool is_plain(const DesignVariation& variation) {
  return variation.exact && variation.exact_fairness == 0.0 && variation.close.empty();
}

/// Calls visit(key, member) for each weight of variations.
template <class Visit>
void for_each_weight(const Visit& visit) {
  visit("fairness", &SubspaceOptions::fairness_weight);
  visit("sparsity", &SubspaceOptions::sparsity_weight);
  visit("closeness", &SubspaceOptions::closeness_weight);
  visit("correlation", &SubspaceOptions::correlation);
  visit("spread", &SubspaceOptions::reach);
  visit("family", &SubspaceOptions::family);
}

val weights_value(const SubspaceOptions& options) {
  val value = val::object();
  for_each_weight([&](const char* key, auto member) { value.set(key, options.*member); });
  return value;
}

bool has_usual_weights(const SubspaceOptions& given) {
  const SubspaceOptions usual;
  bool same = true;
  for_each_weight([&](const char*, auto member) { same = same && given.*member == usual.*member; });
  return same;
}

val variation_value(const DesignVariation& variation) {
  val value = val::object();
  value.set("asked", variation.options.dimension);
  value.set("eigenbasis", variation.options.eigenbasis);
  if (!has_usual_weights(variation.options)) {
    value.set("weights", weights_value(variation.options));
  }
  value.set("coefficients", val::array(variation.coefficients));
  value.set("plain", is_plain(variation));
  return value;
}

std::vector<double> numbers_of(const val& list) {
  return emscripten::convertJSArrayToNumberVector<double>(list);
}

/// Rows of vertex, x, y, z.
template <class Row>
void take_rows(const val& list, std::vector<Row>& rows) {
  const std::vector<double> flat = numbers_of(list);
  for (std::size_t k = 0; k + 3 < flat.size(); k += 4) {
    rows.push_back({static_cast<int>(flat[k]), {flat[k + 1], flat[k + 2], flat[k + 3]}});
  }
}

template <class Row, class Place>
val rows_value(const std::vector<Row>& rows, Place Row::*place) {
  std::vector<double> flat;
  for (const Row& row : rows) {
    const Eigen::Vector3d& p = row.*place;
    flat.insert(flat.end(), {static_cast<double>(row.vertex), p.x(), p.y(), p.z()});
  }
  return val::array(flat);
}

val option_rows() {
  const HandleEditOptions usual;
  val rows = val::array();
  std::size_t k = 0;
  for_each_edit_option([&](const auto& option) {
    val row = val::object();
    row.set("name", std::string(option.name));
    row.set("key", std::string(option.key));
    row.set("usual", option_value(usual.*option.member));
    row.set("words", words_value(usual.*option.member));
    rows.set(k++, row);
  });
  return rows;
}

/// Degrees, by name.
val kind_tolerances() {
  val tolerances = val::object();
  ConstraintKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kName == PlanarPolygon::kName) return;
    tolerances.set(std::string(Kind::kName), Kind::kTolerance);
  });
  return tolerances;
}

EditTargets to_targets(const val& design) {
  EditTargets targets;
  take_rows(design["handles"], targets.handles);
  targets.pins = to_indices(design["pins"]);
  for (const val& text : emscripten::vecFromJSArray<val>(design["supports"])) {
    auto support = parse_point_support(text.as<std::string>());
    if (!support) throw std::invalid_argument("no support");
    targets.supports.push_back(std::move(*support));
  }
  targets.continuation = design["continuation"].as<int>();
  return targets;
}

DesignMark to_mark(const val& value) {
  DesignMark mark{
      .hash = value["hash"].as<std::uint32_t>(), .moved = value["moved"].as<int>(), .probes = {}};
  take_rows(value["probes"], mark.probes);
  return mark;
}

}  // namespace

val to_value(const HandleEditOptions& options) {
  val value = val::object();
  for_each_edit_option([&](const auto& option) {
    value.set(std::string(option.key), option_value(options.*option.member));
  });
  return value;
}

std::optional<std::uint32_t> to_hash(const val& hash) {
  if (hash.isNull()) return std::nullopt;
  return hash.as<std::uint32_t>();
}

HandleEditOptions to_options(const val& settings) {
  HandleEditOptions options;
  for_each_edit_option(
      [&](const auto& option) { take(settings[std::string(option.key)], options.*option.member); });
  return options;
}

/// {"obj": "model/obj", ...}: in the order of all_extensions().
val format_media() {
  val formats = val::object();
  for (const MeshFormatRow& row : kPlainFormats) {
    formats.set(std::string(row.extension), std::string(row.media));
  }
  formats.set(std::string(kGlbName), std::string(kGlbMedia));
  return formats;
}

val defaults_value() {
  val value = val::object();
  value.set("options", option_rows());
  value.set("fairFlat", planarising_value(Planarising{}));
  value.set("nearestFlat", planarising_value(kNearestFlat));
  value.set("kinds", kind_tolerances());
  value.set("variationWeights", weights_value(SubspaceOptions{}));
  value.set("sliverAngle", kSliverAngle);
  value.set("newSliver", static_cast<int>(kNewSliver));
  value.set("buildableCorners", std::string(kBuildableCorners));
  value.set("formats", format_media());
  value.set("metShare", kMet);
  value.set("noticeableShare", kNoticeable);
  value.set("fairFolds", list_of(kFairFolds, [](double degrees) { return degrees; }));
  value.set("linkDictionary", std::string(kLinkDictionary));
  return value;
}

SubspaceOptions to_subspace_options(const val& family) {
  SubspaceOptions options{.dimension = family["asked"].as<int>(),
                          .eigenbasis = family["eigenbasis"].as<bool>()};
  if (const val weights = family["weights"]; !weights.isUndefined()) {
    for_each_weight([&](const char* key, auto member) {
      auto& weight = options.*member;
      weight = weights[key].as<std::decay_t<decltype(weight)>>();
    });
  }
  return options;
}

Planarising to_planarising(const val& how) {
  return {how["smooth"].as<double>(),  how["keepBoundary"].as<bool>(),
          how["keepShape"].as<bool>(), items_of(how["constraints"], &read_constraint),
          how["within"].as<double>(),  how["flat"].as<double>()};
}

val to_value(const DesignMark& mark) {
  val value = val::object();
  value.set("hash", mark.hash);
  value.set("moved", mark.moved);
  value.set("probes", rows_value(mark.probes, &DesignProbe::position));
  return value;
}

val to_value(const Design& design) {
  val value = val::object();
  value.set("source", source_value(design.source));
  value.set("planarised", design.planarised ? planarising_value(*design.planarised) : val::null());
  value.set("unit", design.unit);
  value.set("handles", rows_value(design.targets.handles, &Handle::target));
  value.set("pins", val::array(design.targets.pins));
  value.set("supports", list_of(design.targets.supports, point_support_text));
  value.set("continuation", design.targets.continuation);
  value.set("symmetry", list_of(design.symmetry, symmetry_text));
  value.set("cuts", list_of(design.cuts, cut_text));
  value.set("options", to_value(design.options));
  value.set("variations", list_of(design.variations, variation_value));
  value.set("result", design.result ? to_value(*design.result) : val::null());
  return value;
}

Design to_design(const val& value) {
  Design design = to_recipe(value);
  design.source = to_source(value["source"]);
  if (const val how = value["planarised"]; !how.isNull()) design.planarised = to_planarising(how);
  return design;
}

Design to_recipe(const val& value) {
  Design design;
  design.unit = value["unit"].as<std::string>();
  design.targets = to_targets(value);
  design.options = to_options(value["options"]);
  for (const val& text : emscripten::vecFromJSArray<val>(value["symmetry"])) {
    const auto stated = parse_symmetry(text.as<std::string>());
    if (!stated) throw std::invalid_argument("no symmetry");
    design.symmetry.insert(design.symmetry.end(), stated->elements.begin(), stated->elements.end());
  }
  for (const val& text : emscripten::vecFromJSArray<val>(value["cuts"])) {
    auto cut = parse_cut(text.as<std::string>());
    if (!std::holds_alternative<Cut>(cut)) throw std::invalid_argument("no cut");
    design.cuts.push_back(std::get<Cut>(std::move(cut)));
  }
  for (const val& one : emscripten::vecFromJSArray<val>(value["variations"])) {
    design.variations.push_back({.options = to_subspace_options(one),
                                 .coefficients = numbers_of(one["coefficients"]),
                                 .exact = true});
  }
  if (const val mark = value["result"]; !mark.isNull()) design.result = to_mark(mark);
  return design;
}

}  // namespace planish
