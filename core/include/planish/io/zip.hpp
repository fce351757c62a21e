// SPDX-License-Identifier: MIT
/// Zip archives, written: one entry after the other, compressed where that helps.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace planish {

/// Takes the bytes of a file in order, piece by piece; they are valid during the call.
using ByteSink = std::function<void(std::string_view)>;

/// Writes one archive in pieces. The same entries give the same bytes everywhere: entries carry no
/// time but 1 January 1980.
class ZipWriter {
 public:
  /// What the format holds without its 64-bit extension.
  static constexpr int kMostEntries = 65535;

  /// How much is gathered before it is handed on, bytes; a piece is longer by one entry at most.
  static constexpr std::size_t kPiece = std::size_t{1} << 20;

  /// @param sink may throw: the archive is lost then
  explicit ZipWriter(ByteSink sink);

  /// @param name ASCII, folders with '/'; not twice; @param bytes less than 2 GiB
  void add(std::string_view name, std::string_view bytes);

  /// Hands on what is left and the directory: the end of an archive below 4 GiB.
  void finish();

 private:
  void hand_on();

  ByteSink sink_;
  std::string piece_, directory_;
  std::uint32_t handed_on_ = 0;  ///< bytes
  std::uint32_t count_ = 0;
};

/// `bytes` as a raw DEFLATE stream (RFC 1951).
[[nodiscard]] std::string deflate_raw(std::string_view bytes);

}  // namespace planish
