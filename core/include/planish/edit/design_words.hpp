// SPDX-License-Identifier: MIT
/// The words that a design's text uses; part of the format, so never renamed.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "planish/measures/energies.hpp"
#include "planish/problem/engine.hpp"

namespace planish {

inline constexpr std::string_view kDesignFormat = "planish-design";
inline constexpr int kDesignVersion = 1;

template <class Value, std::size_t kCount>
using Words = std::array<std::pair<std::string_view, Value>, kCount>;

inline constexpr Words<FairnessKind, 3> kFairnessWords = {
    {{"laplacian", FairnessKind::kLaplacian},
     {"second", FairnessKind::kSecondDifference},
     {"third", FairnessKind::kThirdDifference}}};
inline constexpr Words<Sparsity, 3> kSparsityWords = {
    {{"l21", Sparsity::kL21}, {"l2", Sparsity::kL2}, {"none", Sparsity::kNone}}};
inline constexpr Words<Engine, 2> kEngineWords = {
    {{"newton", Engine::kNewton}, {"alm", Engine::kAugmentedLagrangian}}};

/// The words for the values of an option that is one of a few.
[[nodiscard]] constexpr const auto& words_for(FairnessKind) { return kFairnessWords; }
[[nodiscard]] constexpr const auto& words_for(Sparsity) { return kSparsityWords; }
[[nodiscard]] constexpr const auto& words_for(Engine) { return kEngineWords; }

template <class Value, std::size_t kCount>
[[nodiscard]] constexpr std::string_view word_of(Value value, const Words<Value, kCount>& words) {
  for (const auto& [word, meaning] : words) {
    if (meaning == value) return word;
  }
  return words[0].first;
}

template <class Value, std::size_t kCount>
[[nodiscard]] constexpr std::optional<Value> value_of(std::string_view text,
                                                      const Words<Value, kCount>& words) {
  for (const auto& [word, meaning] : words) {
    if (word == text) return meaning;
  }
  return std::nullopt;
}

}  // namespace planish
