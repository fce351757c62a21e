// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/base64.hpp"
#include "planish/design/design_text.hpp"
#include "planish/edit/design_words.hpp"
#include "planish/edit/edit_option_table.hpp"
#include "planish/text/utf8.hpp"

namespace planish {
namespace {

using Json = nlohmann::ordered_json;

std::string hash_text(std::uint32_t hash) {
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08x", static_cast<unsigned>(hash));
  return text.data();
}

Json point_json(int vertex, const Eigen::Vector3d& p) { return {vertex, p.x(), p.y(), p.z()}; }

Json source_json(const DesignSource& source, FileText as) {
  if (const auto* sample = std::get_if<SampleSource>(&source)) {
    return {{"sample", sample->name}, {"size", sample->size}};
  }
  const auto& file = std::get<FileSource>(source);
  Json json = {{"file", file.name}};
  if (file.hash) json["hash"] = hash_text(*file.hash);
  if (!file.bytes.empty()) {
    json["format"] = file.format;
    const bool plain = as == FileText::kPlain && as_utf8(file.bytes) == file.bytes;
    json[plain ? "text" : "bytes"] = plain ? file.bytes : encode_base64(file.bytes);
  }
  return json;
}

Json value_json(double value) { return value; }
Json value_json(bool value) { return value; }
Json value_json(int value) { return value; }
Json value_json(const std::vector<KeptConstraint>& constraints) {
  Json json = Json::array();
  for (const KeptConstraint& one : constraints) {
    json.push_back({{"kind", one.kind}, {"tolerance", one.tolerance}});
  }
  return json;
}
template <class Item>
Json value_json(const std::vector<Item>& items) {
  Json json = Json::array();
  for (const Item& item : items) json.push_back(TextItem<Item>::text(item));
  return json;
}
template <class Value>
Json value_json(Value value) {
  return word_of(value, words_for(value));
}

/// What was added to the format later is written only where it is on, so that older readers go on
/// reading what they know.
Json options_json(const HandleEditOptions& options) {
  const HandleEditOptions absent = options_when_absent();
  Json json = Json::object();
  for_each_edit_option([&](const auto& option) {
    Json value = value_json(options.*option.member);
    const bool off = value == value_json(absent.*option.member);
    if (option.when_absent == WhenAbsent::kOff && off) return;
    json[std::string(option.name)] = std::move(value);
  });
  return json;
}

Json variation_json(const DesignVariation& variation) {
  const SubspaceOptions& options = variation.options;
  Json json = {{"dimension", options.dimension},
               {"eigen", options.eigenbasis},
               {"fairness_weight", options.fairness_weight},
               {"sparsity_weight", options.sparsity_weight},
               {"closeness_weight", options.closeness_weight},
               {"correlation", options.correlation},
               {"reach", options.reach},
               {"coefficients", variation.coefficients},
               {"exact", variation.exact}};
  if (options.family != 0) json["family"] = options.family;
  if (!variation.close.empty()) json["close"] = variation.close;
  if (variation.exact_fairness != 0.0) json["smooth"] = variation.exact_fairness;
  return json;
}

/// `true` is the nearest flat mesh, as designs of earlier versions say it.
Json planarised_json(const std::optional<Planarising>& how) {
  if (!how || *how == kNearestFlat) return how.has_value();
  Json json = {{"smooth", how->fairness_weight},
               {"keep_boundary", how->keep_boundary},
               {"shape", how->keep_shape}};
  if (!how->constraints.empty()) json["constraints"] = value_json(how->constraints);
  if (how->within > 0.0) json["within"] = how->within;
  if (how->flat_within > 0.0) json["flat"] = how->flat_within;
  return json;
}

Json mark_json(const DesignMark& mark) {
  Json probes = Json::array();
  for (const DesignProbe& probe : mark.probes) {
    probes.push_back(point_json(probe.vertex, probe.position));
  }
  return {{"hash", hash_text(mark.hash)}, {"moved", mark.moved}, {"probes", probes}};
}

}  // namespace

std::string write_design(const Design& design, FileText file) {
  Json json = {{"format", kDesignFormat}, {"version", kDesignVersion}};
  if (!design.title.empty()) json["title"] = design.title;
  json["source"] = source_json(design.source, file);
  json["planarised"] = planarised_json(design.planarised);
  json["unit"] = design.unit;
  for (const Cut& cut : design.cuts) json["cuts"].push_back(cut_text(cut));
  json["handles"] = Json::array();
  for (const Handle& handle : design.targets.handles) {
    json["handles"].push_back(point_json(handle.vertex, handle.target));
  }
  json["pins"] = design.targets.pins;
  for (const PointSupport& support : design.targets.supports) {
    json["supports"].push_back(point_support_text(support));
  }
  if (design.targets.continuation > 0) json["continuation"] = design.targets.continuation;
  for (const SymmetryElement& element : design.symmetry) {
    json["symmetry"].push_back(symmetry_text(element));
  }
  json["options"] = options_json(design.options);
  json["variations"] = Json::array();
  for (const DesignVariation& variation : design.variations) {
    json["variations"].push_back(variation_json(variation));
  }
  if (design.result) json["result"] = mark_json(*design.result);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace planish
