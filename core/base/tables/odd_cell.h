// Cells of a table that should hold a number and hold something else: dates, words for "no value", units.
// Example: a spreadsheet has turned 5.1 into `05. Jan`.
#pragma once

#include <string>
#include <string_view>

namespace tactus::base {

/// Whether the cell is a date. Spreadsheets turn codes and numbers into dates: `05. Jan`, `5-Jan`, `2026-01-05`,
/// `05.01.2026`, `1/5/26`. Months in English and German.
bool looksLikeDate(std::string_view cell);

/// Whether the cell is a word for "no value": a dash, `NA`, `n/a`, `#N/A`, `null`, `?`. Not `none`, which
/// can mean that nothing was felt.
bool isMissingWord(std::string_view cell);

/// The words after "wanted" in the error about `cell`, which is no finite number: `a finite number`. Adds the remedy if
/// the cause is known (a date, a unit, a per cent sign, separators of thousands, a decimal comma).
std::string numberWanted(std::string_view cell);

}  // namespace tactus::base
