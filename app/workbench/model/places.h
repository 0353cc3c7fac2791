// Places in the input space: typed by a person, of a figure, where a rule acts.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/fuzzy/force_model.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench {

/// The figures of `procedure` whose inputs `model` has, in its order; none without a procedure.
std::vector<procedure::Figure> figuresOf(const procedure::Procedure* procedure, const fuzzy::ForceModel& model);

// Where in the input space a rule or an edit acts, as a point to go to and in words.

/// The point next to `from` at which all conditions of `rule` hold fully; an input that the rule does not name keeps
/// its value. `from` has one value per input. `rule` belongs to `expert`, and `expert` to the valid `model`.
std::vector<double> pointOfRule(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule,
                                std::span<const double> from);

/// The inputs of `region` that keep the setting `values` outside of it: `lubrication 0.4 to 0.6, speed 30 to 60 mm/s`.
/// The input `but` does not count. Empty if the setting lies inside.
QString rangesOutside(const fuzzy::ForceModel& model, const std::vector<analysis::InputRange>& region,
                      std::span<const double> values, std::size_t but);

/// A place in the input space as a person types it: `130 mm poor fast`, `depth 130, speed medium`.
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
