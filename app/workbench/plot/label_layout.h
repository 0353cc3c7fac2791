// Places the names of terms above a plot without overlap.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace tactus::workbench {

// The numbers on an axis over a universe: round numbers and both ends.

/// About `count` >= 1 round numbers between `min` and `max`, ascending, and both ends. A round number that would
/// overlap an end is left out. `count` = 1 gives the ends alone.
std::vector<double> universeTicks(double min, double max, int count);

/// A name of `width` px that should be centered at `center` px.
struct Label {
  double center = 0;
  double width = 0;
};

struct LabelPlace {
  double left = 0;  ///< px
  int row = 0;      ///< 0 is the row next to the plot
};

/// Places `labels` (ascending centers) in at most `rows` rows between `left` and `right`, at least `gap` px apart. Each
/// name is near its center; if possible, the line from a name down to its center crosses no other name. A label that
/// fits nowhere gets no place.
std::vector<std::optional<LabelPlace>> placeLabels(std::span<const Label> labels, int rows, double left, double right,
                                                   double gap);

/// The start of the line from a placed label down to its center: the point of the label nearest to the center, px.
double lineStart(const Label& label, const LabelPlace& place);

}  // namespace tactus::workbench
