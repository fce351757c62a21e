// SPDX-License-Identifier: MIT
/// Lengths as they are asked for: numbers in the unit of the coordinates, or with a unit behind
/// them.
#pragma once

#include <string>
#include <string_view>

#include "request.hpp"

namespace planish::workflow {

inline constexpr OptionRow kModelUnitRow = {
    "--model-unit", "UNIT", "of the coordinates: mm, cm, m, km, in or ft; default m"};

/// The unit of the coordinates, m unless --model-unit says otherwise. Throws UsageError for another
/// word.
[[nodiscard]] std::string model_unit(const Request& request);

/// "5%" as 0.05. Throws UsageError where there is no such sign.
[[nodiscard]] double parse_share(std::string_view text, std::string_view what);

/// A number, or one with mm, cm, m, km, in or ft behind it ("50mm"), in `unit`. Throws UsageError
/// naming `what`.
[[nodiscard]] double parse_length(const Json& value, std::string_view what,
                                  const std::string& unit);

/// A length as above, or a share of `whole` with % behind it.
[[nodiscard]] double parse_length(const Json& value, std::string_view what, const std::string& unit,
                                  double whole);

/// Sets `length` where `option` is given. Throws UsageError.
void read_length(const Request& request, std::string_view option, const std::string& unit,
                 double& length);

/// `text` with every length that has a unit ("edge=500mm:2m", "plane=0,0,1,35in") as a number in
/// `unit`; whatever else is between '=', ':', ',' and 'x' stays as it is.
[[nodiscard]] std::string plain_lengths(std::string_view text, const std::string& unit);

/// `text` with every area that has a unit ("area=2.5m2") as a number in `unit`, squared.
[[nodiscard]] std::string plain_areas(std::string_view text, const std::string& unit);

}  // namespace planish::workflow
