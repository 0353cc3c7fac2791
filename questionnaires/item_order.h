// The display order of a form's items.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tactus::questionnaires {

enum class ItemOrder {
  kFixed,     ///< as in the form
  kShuffled,  ///< random, from a seed
};

/// `fixed`, `shuffled`.
std::string_view name(ItemOrder order) noexcept;

/// The indices 0 to count - 1 in display order. Shuffled: every order is equally likely (Fisher and Yates), and the
/// same seed gives the same order on every machine.
std::vector<std::size_t> itemOrder(std::size_t count, ItemOrder order, std::uint64_t seed);

}  // namespace tactus::questionnaires
