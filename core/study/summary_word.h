// Words that stand below a table of data, in the place of a code.
#pragma once

#include <string_view>

namespace tactus::study {

/// Whether `word` heads a line that sums a table up: `Mean`, `SD`, `Total`, `n=4`, `Mittelwert`, … Capitals and what is
/// neither a letter nor a digit do not count.
bool isSummaryWord(std::string_view word);

}  // namespace tactus::study
