// A small hash table in one array, for the indices that compiling builds and throws away.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tactus::fuzzy {

/// From keys other than 0 to numbers; at most as many as said beforehand.
class FlatMap {
 public:
  explicit FlatMap(std::size_t most)
      : cells_(std::bit_ceil(2 * most + 2)), shift_(64 - static_cast<int>(std::bit_width(cells_.size() - 1))) {}

  /// What stands under `key`; where nothing does, `value` stands there from now on and comes back.
  std::uint32_t findOrAdd(std::uint64_t key, std::uint32_t value) {
    // Fibonacci hashing: the upper bits of the product depend on all bits of the key.
    std::size_t at = key * 0x9E3779B97F4A7C15U >> shift_;
    while (cells_[at].key != key) {
      if (cells_[at].key == 0) {
        cells_[at] = {key, value};
        break;
      }
      at = (at + 1) & (cells_.size() - 1);
    }
    return cells_[at].value;
  }

 private:
  struct Cell {
    std::uint64_t key = 0;
    std::uint32_t value = 0;
  };
  std::vector<Cell> cells_;
  int shift_;
};

}  // namespace tactus::fuzzy
