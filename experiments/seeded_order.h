// Random orders for the blocks of a session, derived from its seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/random.h"

namespace tactus::experiments {

/// The seed of one block: a mix of the session's seed and the block's name. FNV-1a over the 8 bytes of `seed` (least
/// significant first) and the bytes of `block`, then the finalizer of splitmix64. Each block has its own random
/// numbers, so adding or omitting a block changes no other. Blocks in use: `speed/levels`, `force/descending`,
/// `force/random`, `force/ascending/catches`, `force/descending/catches`.
std::uint64_t blockSeed(std::uint64_t seed, std::string_view block) noexcept;

/// `items` in random order, each order equally likely (Fisher and Yates; Durstenfeld 1964).
template <class Item>
std::vector<Item> shuffled(std::vector<Item> items, base::Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
  return items;
}

}  // namespace tactus::experiments
