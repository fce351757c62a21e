// SPDX-License-Identifier: MIT
/// One table written row by row, as CSV and as JSON at once.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planish/fabrication/panel_tables.hpp"

namespace planish {

/// Every row must add the same fields in the same order.
class TableWriter {
 public:
  TableWriter& row();
  TableWriter& add(std::string_view field, std::string_view text);
  TableWriter& add(std::string_view field, const char* text) {
    return add(field, std::string_view(text));
  }
  TableWriter& add(std::string_view field, int number);
  TableWriter& add(std::string_view field, double number);
  TableWriter& add(std::string_view field, std::span<const double> numbers);
  TableWriter& add(std::string_view field, const std::vector<std::string>& texts);

  /// Ends the last row; the writer is empty afterwards.
  [[nodiscard]] TableText take();

 private:
  void begin(std::string_view field);

  std::string header_, csv_, json_;
  int rows_ = 0;
  bool first_ = true;  ///< field of the row
};

}  // namespace planish
