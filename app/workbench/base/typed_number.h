// Numbers as people type them: with a decimal point or comma, with an exponent, with their unit behind.
#pragma once

#include <QString>
#include <optional>
#include <tl/expected.hpp>
#include <vector>

namespace tactus::workbench {

/// The number that the whole of `typed` says, or one sentence that says what is wrong. `13.5`, `13,5`, `1e2`, `+4` and
/// `13.5 mm` with `unit` "mm" are numbers; with both marks or two of one (`1.234,5`) nobody knows which is meant.
tl::expected<double, QString> typedNumber(const QString& typed, const QString& unit = {});

/// What a number must be beyond a number.
struct NumberBounds {
  double min = 0;
  double max = 0;
  bool whole = false;
  QString unit;
};
/// The same within bounds; never a number that is not the typed one.
tl::expected<double, QString> typedNumber(const QString& typed, const NumberBounds& bounds);

/// Numbers between semicolons, or between commas with a space behind each: `290; 365`, `290, 365`, `13,5; 20`.
tl::expected<std::vector<double>, QString> typedNumbers(const QString& typed, const QString& unit = {});

}  // namespace tactus::workbench
