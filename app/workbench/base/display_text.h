// Numbers, units and names of a model as they stand on the screen. Always with a decimal point, whatever the locale.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

QString text(const std::string& utf8);

/// Outside text in a sentence: nothing in it turns the sentence around or breaks its line (base::oneLine).
QString harmless(const QString& outside);
/// The name of the file `path` without its folder, as it is shown: harmless.
QString shownFileName(const QString& path);

/// `value` with at most `decimals` digits after the point, without zeros at the end.
QString numberText(double value, int decimals = 2);

/// The unit as it is written: nothing for `1` (a ratio).
QString unitText(const std::string& unit);

/// `value` and its unit: `30 mm/s`.
QString quantityText(double value, const std::string& unit, int decimals = 2);

/// `value` in full, as it reads back, and its unit: `33.333333333333336 mm/s`.
QString exactText(double value, const std::string& unit);

/// `value` as precise as a mouse can set it: rounded to a thousandth of the universe or a little finer.
double placeOf(const fuzzy::Variable& variable, double value);
/// `value` rounded in the same way, also beyond the universe.
double roundedPlace(const fuzzy::Variable& variable, double value);
/// That place with its unit.
QString placeText(const fuzzy::Variable& variable, double value);
/// Two places with one unit: `0 to 150 mm`.
QString rangeText(const fuzzy::Variable& variable, double from, double to);

/// A force as it is read off a curve, to three digits: `0.468 N`.
QString forceText(double force, const std::string& unit);

/// The label of a variable or term, or its id where the file gives no label.
QString labelOf(const fuzzy::Variable& variable);
QString labelOf(const fuzzy::Term& term);
QString labelOf(const fuzzy::Expert& expert);

/// The id of a variable as words, where its label does not fit: `Neck flexion`.
QString shortLabelOf(const fuzzy::Variable& variable);

/// `Insertion depth (mm)`.
QString axisText(const fuzzy::Variable& variable);

/// The terms that `value` belongs to with their memberships: `Slow 0.56 · Medium 0.44`. Empty where there is none.
QString membershipText(const std::vector<fuzzy::Term>& terms, double value);

}  // namespace tactus::workbench
