// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "io/base64.hpp"
#include "io/json_depth.hpp"
#include "planish/design/design_text.hpp"
#include "planish/edit/design_words.hpp"
#include "planish/edit/edit_option_table.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

using JsonValue = nlohmann::json;

constexpr std::size_t kLongestText = std::size_t{256} << 20;
constexpr int kDeepest = 8;
constexpr std::size_t kMostHandles = 100'000, kMostPins = 10'000'000, kMostVariations = 32,
                      kMostCoefficients = 64, kMostProbes = 64, kMostConstraints = 16,
                      kMostSupports = 1000, kMostElements = 16, kMostCuts = 10'000,
                      kLongestName = 400, kLongestSupport = 10'000'000, kLongestCut = 10'000'000;

/// Ends the reading; caught in read_design().
struct Refused {
  std::string sentence;
};

/// A JSON value and the way to it, for messages: "handles[2]".
class Field {
 public:
  Field(const JsonValue& value, std::string path) : value_(&value), path_(std::move(path)) {}

  [[noreturn]] void refuse(const std::string& rule) const {
    throw Refused{(path_.empty() ? "the design" : path_) + " must be " + rule};
  }

  /// Holds an object to its fields.
  void only(std::initializer_list<std::string_view> known) const {
    only(std::vector<std::string_view>(known));
  }
  void only(const std::vector<std::string_view>& known) const {
    if (!value_->is_object()) refuse("an object");
    for (const auto& [key, ignored] : value_->items()) {
      bool found = false;
      for (const std::string_view name : known) found = found || name == key;
      if (!found) throw Refused{path_of(key) + " is not a field of a design"};
    }
  }

  [[nodiscard]] bool has(const char* key) const { return value_->contains(key); }
  [[nodiscard]] Field at(const char* key) const {
    if (!has(key)) throw Refused{path_of(key) + " is missing"};
    return {(*value_)[key], path_of(key)};
  }

  [[nodiscard]] std::size_t size(std::size_t most) const {
    if (!value_->is_array()) refuse("a list");
    if (value_->size() > most) refuse("a list of at most " + std::to_string(most));
    return value_->size();
  }
  [[nodiscard]] Field operator[](std::size_t k) const {
    return {(*value_)[k], path_ + "[" + std::to_string(k) + "]"};
  }

  [[nodiscard]] bool is_object() const { return value_->is_object(); }
  [[nodiscard]] bool boolean() const {
    if (!value_->is_boolean()) refuse("true or false");
    return value_->get<bool>();
  }
  [[nodiscard]] double number() const {
    if (!value_->is_number() || !std::isfinite(value_->get<double>())) refuse("a number");
    return value_->get<double>();
  }
  [[nodiscard]] int whole(int least) const {
    constexpr double kLimit = std::numeric_limits<int>::max();
    const double value = value_->is_number() ? value_->get<double>() : -1.0;
    if (!(value >= least && value <= kLimit) || std::floor(value) != value) {
      refuse("a whole number of at least " + std::to_string(least));
    }
    return static_cast<int>(value);
  }
  [[nodiscard]] const std::string& text(std::size_t longest) const {
    if (!value_->is_string()) refuse("a text");
    const auto& text = value_->get_ref<const std::string&>();
    if (text.size() > longest) refuse("a text of at most " + std::to_string(longest) + " bytes");
    return text;
  }
  template <class Value, std::size_t kCount>
  [[nodiscard]] Value word(const Words<Value, kCount>& words) const {
    const auto value =
        value_->is_string() ? value_of(value_->get_ref<const std::string&>(), words) : std::nullopt;
    if (value) return *value;
    std::string known;
    for (const auto& entry : words) {
      known += (known.empty() ? "" : " or ") + std::string(entry.first);
    }
    refuse(known);
  }
  [[nodiscard]] std::uint32_t hash() const {
    const bool right = value_->is_string() && value_->get_ref<const std::string&>().size() == 8;
    if (!right) refuse("8 hexadecimal digits");
    std::uint32_t hash = 0;
    for (const char c : value_->get_ref<const std::string&>()) {
      const bool digit = c >= '0' && c <= '9';
      if (!digit && (c < 'a' || c > 'f')) refuse("8 hexadecimal digits");
      hash = 16 * hash + static_cast<std::uint32_t>(digit ? c - '0' : c - 'a' + 10);
    }
    return hash;
  }
  /// [vertex, x, y, z].
  [[nodiscard]] DesignProbe point() const {
    if (!value_->is_array() || value_->size() != 4) refuse("[point, x, y, z]");
    return {(*this)[0].whole(0), {(*this)[1].number(), (*this)[2].number(), (*this)[3].number()}};
  }

 private:
  [[nodiscard]] std::string path_of(std::string_view key) const {
    const bool plain = key.size() <= 40 && std::all_of(key.begin(), key.end(), [](char c) {
                         return c == '_' || (c >= 'a' && c <= 'z');
                       });
    const std::string name = plain ? std::string(key) : quoted(key);
    return path_.empty() ? name : path_ + "." + name;
  }

  const JsonValue* value_;
  std::string path_;
};

void read_if(const Field& object, const char* key, double& value) {
  if (object.has(key)) value = object.at(key).number();
}

void read_if(const Field& object, const char* key, bool& value) {
  if (object.has(key)) value = object.at(key).boolean();
}

DesignSource read_source(const Field& source) {
  if (source.has("sample")) {
    source.only({"sample", "size"});
    return SampleSource{source.at("sample").text(kLongestName), source.at("size").whole(1)};
  }
  source.only({"file", "hash", "format", "bytes", "text"});
  FileSource file;
  file.name = source.at("file").text(kLongestName);
  if (source.has("hash")) file.hash = source.at("hash").hash();
  const bool plain = source.has("text");
  if (!plain && !source.has("bytes")) return file;
  if (plain && source.has("bytes")) source.at("text").refuse("left out where there are bytes");
  file.format = source.at("format").text(kLongestName);
  if (plain) {
    file.bytes = source.at("text").text(kLongestText);
    if (file.bytes.empty()) source.at("text").refuse("the mesh's file");
    return file;
  }
  auto bytes = decode_base64(source.at("bytes").text(kLongestText));
  if (!bytes || bytes->empty()) source.at("bytes").refuse("base64");
  file.bytes = std::move(*bytes);
  return file;
}

std::vector<KeptConstraint> read_constraints(const Field& field) {
  std::vector<KeptConstraint> constraints;
  for (std::size_t k = 0; k < field.size(kMostConstraints); ++k) {
    const Field one = field[k];
    one.only({"kind", "tolerance"});
    constraints.push_back({one.at("kind").text(kLongestName), one.at("tolerance").number()});
  }
  return constraints;
}

template <class Item>
std::vector<Item> read_value(const Field& field, const std::vector<Item>&) {
  std::vector<Item> items;
  for (std::size_t k = 0; k < field.size(TextItem<Item>::kMost); ++k) {
    auto item = TextItem<Item>::parse(field[k].text(TextItem<Item>::kLongest));
    if (!item) field[k].refuse("one of " + TextItem<Item>::known());
    items.push_back(std::move(*item));
  }
  return items;
}

double read_value(const Field& field, double) { return field.number(); }
bool read_value(const Field& field, bool) { return field.boolean(); }
int read_value(const Field& field, int) { return field.whole(0); }
std::vector<KeptConstraint> read_value(const Field& field, const std::vector<KeptConstraint>&) {
  return read_constraints(field);
}
template <class Value>
Value read_value(const Field& field, Value usual) {
  return field.word(words_for(usual));
}

HandleEditOptions read_options(const Field& field) {
  std::vector<std::string_view> names;
  for_each_edit_option([&](const auto& option) { names.push_back(option.name); });
  field.only(names);
  HandleEditOptions options = options_when_absent();
  for_each_edit_option([&](const auto& option) {
    const std::string name(option.name);
    auto& value = options.*option.member;
    if (field.has(name.c_str())) value = read_value(field.at(name.c_str()), value);
  });
  return options;
}

DesignVariation read_variation(const Field& field) {
  field.only({"dimension", "eigen", "fairness_weight", "sparsity_weight", "closeness_weight",
              "correlation", "reach", "coefficients", "exact", "family", "close", "smooth"});
  DesignVariation variation;
  SubspaceOptions& options = variation.options;
  options.dimension = field.at("dimension").whole(1);
  read_if(field, "eigen", options.eigenbasis);
  read_if(field, "fairness_weight", options.fairness_weight);
  read_if(field, "sparsity_weight", options.sparsity_weight);
  read_if(field, "closeness_weight", options.closeness_weight);
  read_if(field, "correlation", options.correlation);
  if (field.has("reach")) options.reach = field.at("reach").whole(0);
  const Field values = field.at("coefficients");
  for (std::size_t k = 0; k < values.size(kMostCoefficients); ++k) {
    variation.coefficients.push_back(values[k].number());
  }
  read_if(field, "exact", variation.exact);
  if (field.has("family")) options.family = field.at("family").whole(0);
  if (field.has("close")) {
    const Field close = field.at("close");
    for (std::size_t k = 0; k < close.size(kMostPins); ++k) {
      variation.close.push_back(close[k].whole(0));
    }
  }
  read_if(field, "smooth", variation.exact_fairness);
  return variation;
}

DesignMark read_mark(const Field& field) {
  field.only({"hash", "moved", "probes"});
  DesignMark mark{
      .hash = field.at("hash").hash(), .moved = field.at("moved").whole(0), .probes = {}};
  const Field probes = field.at("probes");
  for (std::size_t k = 0; k < probes.size(kMostProbes); ++k) {
    mark.probes.push_back(probes[k].point());
  }
  return mark;
}

std::vector<PointSupport> read_supports(const Field& field) {
  std::vector<PointSupport> supports;
  for (std::size_t k = 0; k < field.size(kMostSupports); ++k) {
    const auto support = parse_point_support(field[k].text(kLongestSupport));
    if (!support) field[k].refuse("one of " + std::string(known_supports()));
    supports.push_back(*support);
  }
  return supports;
}

std::vector<Cut> read_cuts(const Field& field) {
  std::vector<Cut> cuts;
  for (std::size_t k = 0; k < field.size(kMostCuts); ++k) {
    auto cut = parse_cut(field[k].text(kLongestCut));
    if (const auto* problem = std::get_if<std::string>(&cut)) throw Refused{"cuts: " + *problem};
    cuts.push_back(std::get<Cut>(std::move(cut)));
  }
  return cuts;
}

std::vector<SymmetryElement> read_symmetry(const Field& field) {
  std::vector<SymmetryElement> elements;
  for (std::size_t k = 0; k < field.size(kMostElements); ++k) {
    const auto stated = parse_symmetry(field[k].text(kLongestName));
    if (!stated || stated->elements.size() != 1) field[k].refuse("x, y, z or axis:x|y|z:N");
    elements.push_back(stated->elements.front());
  }
  return elements;
}

EditTargets read_targets(const Field& root) {
  EditTargets targets;
  if (root.has("handles")) {
    const Field handles = root.at("handles");
    for (std::size_t k = 0; k < handles.size(kMostHandles); ++k) {
      const DesignProbe point = handles[k].point();
      targets.handles.push_back({point.vertex, point.position});
    }
  }
  if (root.has("pins")) {
    const Field pins = root.at("pins");
    for (std::size_t k = 0; k < pins.size(kMostPins); ++k) targets.pins.push_back(pins[k].whole(0));
  }
  if (root.has("supports")) targets.supports = read_supports(root.at("supports"));
  if (root.has("continuation")) targets.continuation = root.at("continuation").whole(0);
  return targets;
}

/// true, false, or how it was done.
std::optional<Planarising> read_planarised(const Field& root) {
  if (!root.has("planarised")) return std::nullopt;
  const Field field = root.at("planarised");
  if (!field.is_object()) return field.boolean() ? std::optional(kNearestFlat) : std::nullopt;
  field.only({"smooth", "keep_boundary", "shape", "constraints", "within", "flat"});
  Planarising how = kNearestFlat;
  read_if(field, "smooth", how.fairness_weight);
  read_if(field, "keep_boundary", how.keep_boundary);
  read_if(field, "shape", how.keep_shape);
  if (field.has("constraints")) how.constraints = read_constraints(field.at("constraints"));
  read_if(field, "within", how.within);
  read_if(field, "flat", how.flat_within);
  return how;
}

/// Refuses what is no design, before the names of its fields are looked at.
void read_format(const Field& root) {
  const std::string format(kDesignFormat);
  if (!root.is_object()) root.refuse("an object");
  if (!root.has("format")) throw Refused{"format is missing: it must be " + format};
  if (root.at("format").text(kLongestName) != format) root.at("format").refuse(format);
}

Design read_root(const Field& root) {
  read_format(root);
  // What a page keeps beside a design ("page") makes no part of it and is passed over.
  root.only({"format", "version", "title", "source", "planarised", "unit", "cuts", "handles",
             "pins", "supports", "continuation", "symmetry", "options", "variations", "result",
             "page"});
  const int version = root.at("version").whole(1);
  if (version != kDesignVersion) {
    throw Refused{"the design is of version " + std::to_string(version) + "; this reads version " +
                  std::to_string(kDesignVersion)};
  }
  Design design;
  if (root.has("title")) design.title = root.at("title").text(kLongestName);
  design.source = read_source(root.at("source"));
  design.planarised = read_planarised(root);
  if (root.has("unit")) design.unit = root.at("unit").text(kLongestName);
  if (root.has("cuts")) design.cuts = read_cuts(root.at("cuts"));
  design.targets = read_targets(root);
  if (root.has("symmetry")) design.symmetry = read_symmetry(root.at("symmetry"));
  design.options = root.has("options") ? read_options(root.at("options")) : options_when_absent();
  if (root.has("variations")) {
    const Field variations = root.at("variations");
    for (std::size_t k = 0; k < variations.size(kMostVariations); ++k) {
      design.variations.push_back(read_variation(variations[k]));
    }
  }
  if (root.has("result")) design.result = read_mark(root.at("result"));
  if (const auto problem = find_problem(design)) throw Refused{*problem};
  return design;
}

}  // namespace

std::variant<Design, std::string> read_design(std::string_view text) {
  if (text.size() > kLongestText) return "the design is larger than 256 MiB";
  if (is_json_deeper_than(text, kDeepest)) return "the design is nested too deeply";
  const JsonValue document = JsonValue::parse(text, nullptr, false);
  if (document.is_discarded()) return "the design is not JSON";
  try {
    return read_root(Field(document, ""));
  } catch (const Refused& refused) {
    return refused.sentence;
  }
}

}  // namespace planish
