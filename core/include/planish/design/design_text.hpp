// SPDX-License-Identifier: MIT
/// A design as text: JSON, the same in files, in GLBs, in links and on the command line.
/// docs/formats.md describes it field by field.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "planish/design/design.hpp"

namespace planish {

/// How the mesh's file stands in the text of a design that carries it.
enum class FileText {
  kBase64,  ///< "bytes": any file, and what every version reads
  kPlain    ///< "text", where the file is UTF-8: what repeats in it stays compressible
};

/// One line of JSON with every option spelled out, so that it means the same when defaults change.
/// Strings are UTF-8: anything else is replaced.
[[nodiscard]] std::string write_design(const Design& design, FileText file = FileText::kBase64);

/// Total: a design, or one sentence that names the field. Fields may stand in any order; options
/// left out have their defaults; unknown fields are refused, so that a slip of the pen is found.
/// @param text at most 256 MiB, nested at most 8 deep
[[nodiscard]] std::variant<Design, std::string> read_design(std::string_view text);

}  // namespace planish
