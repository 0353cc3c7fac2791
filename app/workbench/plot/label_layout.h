// Where the names of terms stand above a plot, so that no two overlap.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace tactus::workbench {

/// A name that wants to be centered at `center` and is `width` wide, both in px.
struct Label {
  double center = 0;
  double width = 0;
};

struct LabelPlace {
  double left = 0;  ///< px
  int row = 0;      ///< 0 is the row next to the plot
};

/// Places `labels` (ascending centers) in at most `rows` rows between `left` and `right`, `gap` px apart: near to their
/// centers, and so that the line from a name down to its center does not run through another name where that can be
/// had. A label that fits nowhere gets no place.
std::vector<std::optional<LabelPlace>> placeLabels(std::span<const Label> labels, int rows, double left, double right,
                                                   double gap);

/// Where the line from a placed label down to its center starts: at the point of the label nearest to the center, px.
double lineStart(const Label& label, const LabelPlace& place);

}  // namespace tactus::workbench
