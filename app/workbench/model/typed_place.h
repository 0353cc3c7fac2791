// A place in the input space as a person types it: `130 mm poor fast`, `depth 130, speed medium`.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

struct TypedPlace {
  std::vector<double> point;  ///< one value per input
  QStringList words;          ///< what was typed of it: `Depth 130 mm`, `Lubrication Poor`
};

/// Parts are a number with the unit of one input, a term of one input, or either behind or before the input's name. A
/// term stands for the middle of its core. Inputs that are not named keep their value of `from`. Nothing where a word
/// is none of these, is a term of several inputs, or a number is outside its universe; and for a term alone.
std::optional<TypedPlace> typedPlace(const QString& typed, const fuzzy::ForceModel& model,
                                     std::span<const double> from);

}  // namespace tactus::workbench
