// SPDX-License-Identifier: MIT
#include "mobility_values.hpp"

#include <string>

namespace planish {
namespace {

using emscripten::val;

val row_value(const MobilityRow& row) {
  val direction = val::array();
  for (const double part : row.direction) direction.call<void>("push", part);
  val value = val::object();
  value.set("vertex", row.vertex);
  value.set("direction", direction);
  value.set("distance", row.distance);
  value.set("limit", std::string(row.limit));
  value.set("remake", row.remake);
  value.set("sharpestFold", row.sharpest_fold);
  return value;
}

}  // namespace

val to_value(const std::vector<MobilityRow>& rows) {
  val list = val::array();
  for (const MobilityRow& row : rows) list.call<void>("push", row_value(row));
  return list;
}

}  // namespace planish
