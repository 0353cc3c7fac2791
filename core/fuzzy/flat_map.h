// A small hash table in one array, for the temporary indices of the compiler.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tactus::fuzzy {

/// Maps keys other than 0 to numbers.
class FlatMap {
 public:
  /// Allocates space for `expected` keys. The table grows if more are added.
  explicit FlatMap(std::size_t expected) { makeRoom(expected); }

  /// Returns the value of `key`. If the key is new, stores `value` under it and returns `value`.
  std::uint32_t findOrAdd(std::uint64_t key, std::uint32_t value) {
    std::size_t at = placeOf(key);
    if (cells_[at].key == key) return cells_[at].value;
    if (left_ == 0) {
      grow();
      at = placeOf(key);
    }
    --left_;
    cells_[at] = {key, value};
    return value;
  }

 private:
  struct Cell {
    std::uint64_t key = 0;
    std::uint32_t value = 0;
  };

  /// The cell of the key, or the empty cell in which it belongs.
  std::size_t placeOf(std::uint64_t key) const noexcept {
    // Fibonacci hashing: the upper bits of the product depend on all bits of the key.
    std::size_t at = key * 0x9E3779B97F4A7C15U >> shift_;
    while (cells_[at].key != key && cells_[at].key != 0) at = (at + 1) & (cells_.size() - 1);
    return at;
  }

  /// Allocates empty cells: at least twice as many as keys, so that probing stays short.
  void makeRoom(std::size_t expected) {
    cells_.assign(std::bit_ceil(2 * expected + 2), {});
    shift_ = 64 - static_cast<int>(std::bit_width(cells_.size() - 1));
    left_ = cells_.size() / 2;
  }

  void grow() {
    const std::vector<Cell> old = std::move(cells_);
    makeRoom(old.size());
    for (const Cell& cell : old) {
      if (cell.key != 0) findOrAdd(cell.key, cell.value);
    }
  }

  std::vector<Cell> cells_;
  std::size_t left_ = 0;  ///< number of keys that can be added before the table grows
  int shift_ = 0;
};

}  // namespace tactus::fuzzy
