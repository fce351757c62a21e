// SPDX-License-Identifier: MIT
#include "fabrication/table_writer.hpp"

#include <utility>

#include "fabrication/json_object.hpp"
#include "planish/text/number.hpp"

namespace planish {
namespace {

/// RFC 4180: quoted only where it must be.
std::string csv_quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

TableWriter& TableWriter::row() {
  if (rows_ > 0) {
    csv_ += "\r\n";
    json_ += "},\n";
  }
  ++rows_;
  json_ += "{";
  first_ = true;
  return *this;
}

void TableWriter::begin(std::string_view field) {
  if (!first_) {
    csv_ += ',';
    json_ += ',';
    if (rows_ == 1) header_ += ',';
  }
  first_ = false;
  if (rows_ == 1) header_ += field;
  json_ += json_quoted(field);
  json_ += ':';
}

TableWriter& TableWriter::add(std::string_view field, std::string_view text) {
  begin(field);
  csv_ += csv_quoted(text);
  json_ += json_quoted(text);
  return *this;
}

TableWriter& TableWriter::add(std::string_view field, int number) {
  begin(field);
  append_integer(csv_, number);
  append_integer(json_, number);
  return *this;
}

TableWriter& TableWriter::add(std::string_view field, double number) {
  begin(field);
  const std::size_t start = csv_.size();
  append_exact(csv_, number);
  json_.append(csv_, start);
  return *this;
}

TableWriter& TableWriter::add(std::string_view field, std::span<const double> numbers) {
  begin(field);
  json_ += '[';
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k > 0) csv_ += ' ';
    if (k > 0) json_ += ',';
    const std::size_t start = csv_.size();
    append_exact(csv_, numbers[k]);
    json_.append(csv_, start);
  }
  json_ += ']';
  return *this;
}

TableWriter& TableWriter::add(std::string_view field, const std::vector<std::string>& texts) {
  begin(field);
  json_ += '[';
  for (std::size_t k = 0; k < texts.size(); ++k) {
    if (k > 0) csv_ += ' ';
    if (k > 0) json_ += ',';
    csv_ += texts[k];
    json_ += json_quoted(texts[k]);
  }
  json_ += ']';
  return *this;
}

TableText TableWriter::take() {
  TableText text;
  text.csv.append(header_).append("\r\n").append(csv_).append(rows_ > 0 ? "\r\n" : "");
  text.json.append("[").append(json_).append(rows_ > 0 ? "}" : "").append("]");
  *this = TableWriter();
  return text;
}

}  // namespace planish
