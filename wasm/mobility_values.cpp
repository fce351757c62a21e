// SPDX-License-Identifier: MIT
#include "mobility_values.hpp"

#include <string>

#include "arrays.hpp"

namespace planish {
namespace {

using emscripten::val;

val row_value(const MobilityRow& row) {
  val value = val::object();
  value.set("vertex", row.vertex);
  value.set("direction", val::array(row.direction.begin(), row.direction.end()));
  value.set("distance", row.distance);
  value.set("limit", std::string(row.limit));
  value.set("remake", row.remake);
  value.set("sharpestFold", row.sharpest_fold);
  return value;
}

}  // namespace

val to_value(const std::vector<MobilityRow>& rows) { return list_of(rows, row_value); }

}  // namespace planish
