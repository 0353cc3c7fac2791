// Numbers, units and names of a model for the screen. The decimal mark is a point in every locale.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

QString text(const std::string& utf8);

/// Text from outside, safe inside a sentence: it cannot change the writing direction or break the line (base::oneLine).
QString harmless(const QString& outside);
/// The file name of `path` without its folder, made safe with `harmless`.
QString shownFileName(const QString& path);

/// `value` with at most `decimals` digits after the point, without trailing zeros.
QString numberText(double value, int decimals = 2);

/// The unit for the screen; empty for `1` (a ratio).
QString unitText(const std::string& unit);

/// `value` and its unit: `30 mm/s`.
QString quantityText(double value, const std::string& unit, int decimals = 2);

/// `value` with all digits needed to read it back, and its unit: `33.333333333333336 mm/s`.
QString exactText(double value, const std::string& unit);

/// `value` as precise as a mouse can set it: clamped to the universe and rounded to a thousandth of it or a little
/// finer.
double placeOf(const fuzzy::Variable& variable, double value);
/// The same rounding without the clamp.
double roundedPlace(const fuzzy::Variable& variable, double value);
/// `placeOf` with its unit.
QString placeText(const fuzzy::Variable& variable, double value);
/// Two places with one unit: `0 to 150 mm`.
QString rangeText(const fuzzy::Variable& variable, double from, double to);

/// A force as read off a curve, with three digits: `0.468 N`.
QString forceText(double force, const std::string& unit);

/// The label of a variable, a term or an expert; its id if the file gives no label.
QString labelOf(const fuzzy::Variable& variable);
QString labelOf(const fuzzy::Term& term);
QString labelOf(const fuzzy::Expert& expert);

/// The id of a variable as words, for places too small for its label: `Neck flexion`.
QString shortLabelOf(const fuzzy::Variable& variable);

/// `Insertion depth (mm)`.
QString axisText(const fuzzy::Variable& variable);

/// The terms to which `value` belongs, with their memberships: `Slow 0.56 · Medium 0.44`. Empty if it belongs to none.
QString membershipText(const std::vector<fuzzy::Term>& terms, double value);

}  // namespace tactus::workbench
