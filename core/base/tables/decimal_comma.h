// Decides whether commas in the cells of a table are decimal points.
#pragma once

#include <cstddef>
#include <string_view>

namespace tactus::base {

/// Counts the kinds of commas in a table, cell by cell.
class DecimalCommas {
 public:
  enum class Cell {
    kOther,      ///< not a number with a comma
    kDecimal,    ///< `1,5`, `0,125`, `-12,50`, `1,5e3`: the comma must be a decimal point
    kEither,     ///< `1,234`: a thousands separator or a decimal point
    kThousands,  ///< `1,234,567`, `1,234.5`
    kPoint,      ///< a number with a decimal point
  };
  static Cell kindOf(std::string_view cell);

  void add(std::string_view cell);

  /// Whether all commas between digits are decimal points: at least one must be, none must be a thousands separator,
  /// and no number has a decimal point.
  bool decimal() const { return decimal_ > 0 && thousands_ == 0 && points_ == 0; }

 private:
  std::size_t decimal_ = 0;
  std::size_t thousands_ = 0;
  std::size_t points_ = 0;
};

}  // namespace tactus::base
