// The lines of experts in a plot: told apart by color and dashes, or faint where there are many.
#pragma once

#include <QPen>
#include <cstddef>

namespace tactus::workbench {

/// The line of the expert with this number (figures::expertNumbers) among `count`. Up to 24 differ by color and dashes;
/// of more, the lines are faint and thin: together they show the spread, and the mean stands out.
QPen expertPen(std::size_t number, std::size_t count);

}  // namespace tactus::workbench
