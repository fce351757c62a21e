// SPDX-License-Identifier: MIT
#include "link_code.hpp"

#include <cstdint>
#include <optional>
#include <qrcodegen/qrcodegen.hpp>
#include <vector>

namespace planish::cli {
namespace {

using qrcodegen::QrCode;
using qrcodegen::QrSegment;

/// nullopt if `bytes` are too many.
std::optional<QrCode> encode(const std::vector<std::uint8_t>& bytes) {
  constexpr bool kRaiseLevel = false;
  try {
    return QrCode::encodeSegments({QrSegment::makeBytes(bytes)}, QrCode::Ecc::MEDIUM,
                                  QrCode::MIN_VERSION, LinkCode::kLargestVersion,
                                  LinkCode::kMaskPattern, kRaiseLevel);
  } catch (const qrcodegen::data_too_long&) {
    return std::nullopt;
  }
}

}  // namespace

LinkCode make_link_code(const std::string& link) {
  LinkCode code{link, 0, {}};
  if (link.empty()) return code;
  const auto drawn = encode({link.begin(), link.end()});
  if (!drawn) return code;
  code.size = drawn->getSize();
  for (int y = 0; y < code.size; ++y) {
    for (int x = 0; x < code.size; ++x) code.dark.push_back(drawn->getModule(x, y) ? 1 : 0);
  }
  return code;
}

}  // namespace planish::cli
