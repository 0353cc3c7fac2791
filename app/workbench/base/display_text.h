// Numbers, units and names of a model for the screen. The decimal mark is a point in every locale.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// What a statistic on the screen means, in one or two sentences for the place where it stands.
enum class Statistic {
  kNoticeable,     ///< JND
  kRms,            ///< root mean square
  kInterval,       ///< 95 % of the draws
  kAlpha,          ///< Krippendorff (2013), Content Analysis, ch. 12
  kKappa,          ///< Fleiss (1971)
  kWeightedKappa,  ///< Cohen (1968), quadratic weights
  kKendallW,       ///< Kendall and Babington Smith (1939)
  kConsensus,      ///< Tastle and Wierman (2007)
};

/// Begins with the name of the statistic: `RMS: the root of …`.
QString explained(Statistic statistic);

// The languages of the nurse's screens by their own names.

/// `English` for `en`, `繁體中文` for `zh-Hant`, `简体中文` for `zh-Hans`, `Français` for `fr`; an unknown id as it is.
QString languageName(const QString& id);

/// The language in which the program speaks, as a pack names it: `en`.
QString programLanguage();

// The initials of a name, for places where the name does not fit.

/// `VS` for `Very Small`.
QString initialsOf(const QString& words);

// Numbers as users type them: with a decimal point or comma, an exponent, and the unit after the number.

/// Reads the whole of `typed` as one number; otherwise returns one sentence with the reason. Numbers are `13.5`,
/// `13,5`, `1e2`, `+4` and, with `unit` "mm", `13.5 mm`. Refused as ambiguous: both marks, or one mark twice
/// (`1.234,5`).
tl::expected<double, QString> typedNumber(const QString& typed, const QString& unit = {});

/// Limits for a typed number.
struct NumberBounds {
  double min = 0;
  double max = 0;
  bool whole = false;
  QString unit;
};
/// Refuses a number outside `bounds`. It never changes the number.
tl::expected<double, QString> typedNumber(const QString& typed, const NumberBounds& bounds);

/// Numbers separated by semicolons, or by commas followed by a space: `290; 365`, `290, 365`, `13,5; 20`.
tl::expected<std::vector<double>, QString> typedNumbers(const QString& typed, const QString& unit = {});

QString text(const std::string& utf8);

/// Text from outside, safe inside a sentence: it cannot change the writing direction or break the line (base::oneLine).
QString harmless(const QString& outside);
/// The file name of `path` without its folder, made safe with `harmless`.
QString shownFileName(const QString& path);

/// A list such as `lubrication 0.4, 0 mm/s` that breaks into lines at its commas alone: a number stays with its unit.
QString brokenAtCommas(const QString& listed);

/// `value` with at most `decimals` digits after the point, without trailing zeros.
QString numberText(double value, int decimals = 2);

/// A share as percent, `23.1 %`; a share above 0 is never shown as 0.
QString percentText(double share);

/// An id as words: `very small` for `very_small`.
QString spelled(std::string_view id);

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
