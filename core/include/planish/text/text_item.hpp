// SPDX-License-Identifier: MIT
/// What an item of a list is called in designs, links and JavaScript: one text.
#pragma once

#include <string_view>
#include <utility>

namespace planish {

/// Specialised beside each kind of item that a list option may have; who reads or writes options
/// asks it, so that a list is read and written once:
/// - kMost items of a list, kLongest bytes of a text that a design may hold
/// - parse(text): the item; nullopt where the text is none, whatever its numbers
/// - text(item): what parse() reads, with the same bits
/// - known(): the forms of all, for messages
/// - unread(text): an item for a text that is none, which breaks a rule of find_problem()
template <class Item>
struct TextItem;

/// The item that `text` says; one that breaks a rule where it says none.
template <class Item>
[[nodiscard]] Item read_item(std::string_view text) {
  auto item = TextItem<Item>::parse(text);
  return item ? *std::move(item) : TextItem<Item>::unread(text);
}

}  // namespace planish
