#include "core/study/csv_tables.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "core/base/tables/csv.h"
#include "core/base/text.h"

namespace tactus::study {

bool isSummaryWord(std::string_view word) {
  static constexpr std::array<std::string_view, 21> kWords = {
      "average", "anzahl", "count",   "durchschnitt", "gesamt",  "maximum", "mean",
      "mean_sd", "median", "minimum", "mittelwert",   "mw",      "overall", "sd",
      "stabw",   "std",    "stdev",   "sum",          "summary", "summe",   "total"};
  std::string key = base::columnKey(word);
  while (!key.empty() && (base::isDigit(key.back()) || key.back() == '_')) key.pop_back();
  // `n=4` and `N = 12`; a code `N4` is one.
  if (key == "n") return word.find('=') != std::string_view::npos;
  const bool has_number = key.size() != base::columnKey(word).size();
  return !has_number && std::find(kWords.begin(), kWords.end(), key) != kWords.end();
}

}  // namespace tactus::study
