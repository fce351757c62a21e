// SPDX-License-Identifier: MIT
#include "io/ply_header.hpp"

#include <utility>

#include "io/text_lines.hpp"
#include "planish/text/number.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

constexpr std::pair<std::string_view, PlyType> kTypeNames[] = {
    {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},    {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},    {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat32},  {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
    {"float64", PlyType::kFloat64}};

std::optional<PlyType> type_named(std::string_view name) {
  for (const auto& [known, type] : kTypeNames) {
    if (known == name) return type;
  }
  return std::nullopt;
}

std::string take_format(std::string_view words, PlyHeader& header) {
  const std::string_view format = take_word(words);
  if (format == "ascii") {
    header.encoding = PlyEncoding::kAscii;
  } else if (format == "binary_little_endian") {
    header.encoding = PlyEncoding::kBinaryLittleEndian;
  } else if (format == "binary_big_endian") {
    header.encoding = PlyEncoding::kBinaryBigEndian;
  } else {
    return "the format " + quoted(format) + " is not known";
  }
  return "";
}

std::string take_element(std::string_view words, int line, PlyHeader& header) {
  PlyElement element;
  element.name = std::string(take_word(words));
  element.line = line;
  const std::string_view count_word = take_word(words);
  const std::optional<long long> count = parse_integer(count_word);
  if (!count || *count < 0) return quoted(count_word) + " is not a number of elements";
  element.count = static_cast<std::uint64_t>(*count);
  header.elements.push_back(std::move(element));
  return "";
}

std::string take_property(std::string_view words, PlyHeader& header) {
  if (header.elements.empty()) return "a property stands before any element";
  PlyProperty property;
  std::string_view type_word = take_word(words);
  if (type_word == "list") {
    const std::string_view count_word = take_word(words);
    property.count_type = type_named(count_word);
    if (!property.count_type || !is_whole(*property.count_type)) {
      return quoted(count_word) + " is not a type for the length of a list";
    }
    type_word = take_word(words);
  }
  const std::optional<PlyType> type = type_named(type_word);
  if (!type) return quoted(type_word) + " is not a property type";
  property.type = *type;
  property.name = std::string(take_word(words));
  if (property.name.empty()) return "a property has no name";
  header.elements.back().properties.push_back(std::move(property));
  return "";
}

std::string take_line(std::string_view words, int line, PlyHeader& header) {
  const std::string_view keyword = take_word(words);
  if (keyword == "format") return take_format(words, header);
  if (keyword == "element") return take_element(words, line, header);
  if (keyword == "property") return take_property(words, header);
  if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return "";
  const std::string foreign = quoted(keyword) + " does not belong in a PLY header";
  if (!header.elements.empty()) return foreign;
  // A comment without its keyword, as old exporters wrote it. Further down a slip of the pen would
  // shift what the file holds.
  header.warnings.push_back(line_text(line, foreign) + "; passed over");
  return "";
}

}  // namespace

std::size_t ply_size(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      return 8;
  }
  return 0;
}

bool is_whole(PlyType type) { return type != PlyType::kFloat32 && type != PlyType::kFloat64; }

std::variant<PlyHeader, std::string> read_ply_header(std::string_view bytes) {
  TextLines line(bytes);
  if (!line.next() || line.text() != "ply") return "line 1: a PLY file starts with \"ply\"";
  PlyHeader header;
  while (line.next()) {
    if (line.text() == "end_header") {
      header.body = line.rest();
      header.body_line = line.number() + 1;
      return header;
    }
    if (const std::string problem = take_line(line.text(), line.number(), header);
        !problem.empty()) {
      return line_text(line.number(), problem);
    }
  }
  return "the header does not end: \"end_header\" is missing";
}

}  // namespace planish
