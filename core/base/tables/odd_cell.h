// What a cell of a table is that should be a number, or nothing.
#pragma once

#include <string>
#include <string_view>

namespace tactus::base {

/// Whether the cell is a date as spreadsheets make them of codes and numbers: `05. Jan`, `5-Jan`, `2026-01-05`,
/// `05.01.2026`, `1/5/26`. Months in English and German.
bool looksLikeDate(std::string_view cell);

/// Whether people write the cell where there is no value: a dash, `NA`, `n/a`, `#N/A`, `null`, `?`. Not `none`, which
/// can mean that nothing was felt.
bool isMissingWord(std::string_view cell);

/// What is wanted instead of `cell`, which is no finite number: `a finite number`, and the remedy where the cause is
/// plain (a date, a unit, a per cent sign, separators of thousands, a decimal comma).
std::string numberWanted(std::string_view cell);

}  // namespace tactus::base
