// Numbers as users type them: with a decimal point or comma, an exponent, and the unit after the number.
#pragma once

#include <QString>
#include <optional>
#include <tl/expected.hpp>
#include <vector>

namespace tactus::workbench {

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

}  // namespace tactus::workbench
