// The order in which the items of a form are shown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tactus::questionnaires {

enum class ItemOrder {
  kFixed,     ///< as in the form
  kShuffled,  ///< by a seed
};

/// `fixed`, `shuffled`.
std::string_view name(ItemOrder order) noexcept;

/// The places 0 to count - 1 in the order in which they are shown. Shuffled: every order is equally likely (Fisher and
/// Yates), and the same seed gives the same order on every machine.
std::vector<std::size_t> itemOrder(std::size_t count, ItemOrder order, std::uint64_t seed);

}  // namespace tactus::questionnaires
