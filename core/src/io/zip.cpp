// SPDX-License-Identifier: MIT
#include "planish/io/zip.hpp"

#include <cassert>
#include <utility>

#include "numeric/crc32.hpp"

namespace planish {
namespace {

void put16(std::string& bytes, std::uint32_t value) {
  bytes += static_cast<char>(value & 255u);
  bytes += static_cast<char>(value >> 8 & 255u);
}

void put32(std::string& bytes, std::uint32_t value) {
  put16(bytes, value & 0xffffu);
  put16(bytes, value >> 16);
}

constexpr std::uint32_t kZipVersion = 20;          // folders and DEFLATE
constexpr std::uint32_t kFirstDay = 1u << 5 | 1u;  // 1 January 1980

/// What the local header and the directory have in common.
std::string entry_fields(std::string_view name, std::string_view bytes, std::string_view stored) {
  std::string fields;
  put16(fields, kZipVersion);
  put16(fields, 0);  // no flags
  put16(fields, stored.size() < bytes.size() ? 8 : 0);
  put16(fields, 0);  // midnight
  put16(fields, kFirstDay);
  put32(fields, crc32(bytes));
  put32(fields, static_cast<std::uint32_t>(stored.size()));
  put32(fields, static_cast<std::uint32_t>(bytes.size()));
  put16(fields, static_cast<std::uint32_t>(name.size()));
  put16(fields, 0);  // no extra field
  return fields;
}

}  // namespace

ZipWriter::ZipWriter(ByteSink sink) : sink_(std::move(sink)) {}

void ZipWriter::add(std::string_view name, std::string_view bytes) {
  assert(count_ < kMostEntries);
  const std::string deflated = deflate_raw(bytes);
  const std::string_view stored =
      deflated.size() < bytes.size() ? std::string_view(deflated) : bytes;
  const std::string fields = entry_fields(name, bytes, stored);
  const auto place = handed_on_ + static_cast<std::uint32_t>(piece_.size());
  put32(piece_, 0x04034b50);
  piece_ += fields;
  piece_ += name;
  piece_ += stored;
  put32(directory_, 0x02014b50);
  put16(directory_, kZipVersion);
  directory_ += fields;
  put16(directory_, 0);  // no comment
  put16(directory_, 0);  // disk
  put16(directory_, 0);  // internal attributes
  put32(directory_, 0);  // external attributes
  put32(directory_, place);
  directory_ += name;
  ++count_;
  if (piece_.size() >= kPiece) hand_on();
}

void ZipWriter::hand_on() {
  sink_(piece_);
  handed_on_ += static_cast<std::uint32_t>(piece_.size());
  piece_.clear();
}

void ZipWriter::finish() {
  hand_on();
  piece_ = std::move(directory_);
  const auto size = static_cast<std::uint32_t>(piece_.size());
  put32(piece_, 0x06054b50);
  put16(piece_, 0);  // disk
  put16(piece_, 0);
  put16(piece_, count_);
  put16(piece_, count_);
  put32(piece_, size);
  put32(piece_, handed_on_);
  put16(piece_, 0);  // no comment
  hand_on();
}

}  // namespace planish
