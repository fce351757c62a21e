// SPDX-License-Identifier: MIT
/// Rows of several kinds, one homogeneous batch a kind: a walk picks the code of a kind once per
/// batch, and its rows are compiled for it.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace planish {

/// Kinds of rows as a type: of constraints, or of limits.
template <class... Kinds>
struct KindList {
  static constexpr std::size_t kCount = sizeof...(Kinds);

  /// Calls visit(std::type_identity<Kind>()) for every kind, in order.
  template <class Visit>
  static constexpr void for_each(const Visit& visit) {
    (visit(std::type_identity<Kinds>()), ...);
  }

  /// Whether test(std::type_identity<Kind>()) is true of every kind.
  template <class Test>
  static constexpr bool all(const Test& test) {
    return (test(std::type_identity<Kinds>()) && ...);
  }

  /// The place of a kind in the list.
  template <class Kind>
  static constexpr std::size_t index_of() {
    std::size_t index = 0;
    std::size_t found = kCount;
    ((std::is_same_v<Kind, Kinds> ? found = index++ : index++), ...);
    return found;
  }

  using Batches = std::tuple<std::vector<typename Kinds::Row>...>;

  /// The list with one more at its end.
  template <class More>
  using With = KindList<Kinds..., More>;
  /// The list with one more at its beginning.
  template <class First>
  using After = KindList<First, Kinds...>;
};

/// Rows of the kinds of a list. They are numbered through: batch after batch.
template <class List>
class RowBatches {
 public:
  using Kinds = List;

  template <class Kind>
  [[nodiscard]] std::vector<typename Kind::Row>& of() {
    return std::get<List::template index_of<Kind>()>(batches_);
  }
  template <class Kind>
  [[nodiscard]] const std::vector<typename Kind::Row>& of() const {
    return std::get<List::template index_of<Kind>()>(batches_);
  }

  [[nodiscard]] std::size_t size() const {
    return std::apply([](const auto&... batch) { return (batch.size() + ...); }, batches_);
  }
  [[nodiscard]] bool empty() const { return size() == 0; }

  void clear() {
    std::apply([](auto&... batch) { (batch.clear(), ...); }, batches_);
  }

  /// Calls visit(number, row) for every row, in order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    int number = 0;
    const auto walk = [&](const auto& batch) {
      for (const auto& row : batch) visit(number++, row);
    };
    std::apply([&](const auto&... batch) { (walk(batch), ...); }, batches_);
  }

 private:
  typename List::Batches batches_;
};

}  // namespace planish
