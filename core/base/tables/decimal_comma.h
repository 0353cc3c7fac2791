// Which commas in the cells of a table are decimal points.
#pragma once

#include <cstddef>
#include <string_view>

namespace tactus::base {

/// What a table's cells say of its commas, cell after cell.
class DecimalCommas {
 public:
  enum class Cell {
    kOther,      ///< no number with a comma
    kDecimal,    ///< `1,5`, `0,125`, `-12,50`, `1,5e3`: the comma can only be a decimal point
    kEither,     ///< `1,234`: thousands or a decimal
    kThousands,  ///< `1,234,567`, `1,234.5`
    kPoint,      ///< a number with a decimal point
  };
  static Cell kindOf(std::string_view cell);

  void add(std::string_view cell);

  /// All commas between digits are decimal points: some can only be one, none can only separate thousands, and there is
  /// no decimal point beside them.
  bool decimal() const { return decimal_ > 0 && thousands_ == 0 && points_ == 0; }

 private:
  std::size_t decimal_ = 0;
  std::size_t thousands_ = 0;
  std::size_t points_ = 0;
};

}  // namespace tactus::base
