#include "core/base/tables/odd_cell.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/text.h"

namespace tactus::base {
namespace {

/// The name of a month or its beginning, of three letters or more.
bool isMonth(std::string_view word) {
  static constexpr std::array<std::string_view, 19> kMonths = {
      "january",  "february", "march",  "april",   "may", "june", "july", "august",  "september", "october",
      "november", "december", "januar", "februar", "mrz", "mai",  "juni", "oktober", "dezember"};
  return word.size() >= 3 && std::any_of(kMonths.begin(), kMonths.end(),
                                         [word](std::string_view month) { return month.starts_with(word); });
}

/// `5`, `jan` of `5-Jan`; nothing where other characters than spaces, dots, dashes and slashes stand between, or none.
std::vector<std::string> dateParts(const std::string& text) {
  std::vector<std::string> parts;
  bool apart = true;
  for (const char c : text) {
    if (c == ' ' || c == '.' || c == '-' || c == '/') {
      apart = true;
      continue;
    }
    if (!isDigit(c) && !isLetter(c)) return {};
    if (apart) parts.emplace_back();
    if (!apart && isDigit(c) != isDigit(parts.back().back())) return {};
    parts.back() += c;
    apart = false;
  }
  return parts;
}

}  // namespace

bool looksLikeDate(std::string_view cell) {
  const auto parts = dateParts(lowered(trimmed(cell)));
  const auto is_number = [](const std::string& part) { return isDigit(part.front()) && part.size() <= 4; };
  const auto numbers = static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), is_number));
  const bool month = std::any_of(parts.begin(), parts.end(), [](const auto& part) { return isMonth(part); });
  if (month) return parts.size() >= 2 && parts.size() <= 3 && numbers + 1 == parts.size();
  if (parts.size() != 3 || numbers != 3) return false;
  const bool year_first = parts[0].size() == 4;
  const auto& year = year_first ? parts[0] : parts[2];
  return (year.size() == 4 || year.size() == 2) && parts[1].size() <= 2 &&
         (year_first ? parts[2] : parts[0]).size() <= 2;
}

bool isMissingWord(std::string_view cell) {
  static constexpr std::array<std::string_view, 13> kWords = {"-",   "--",   "\u2013", "\u2014", "na", "n/a",    "n.a.",
                                                              "n.a", "#n/a", "null",   "nan",    "?",  "missing"};
  const std::string word = lowered(trimmed(cell));
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

std::string numberWanted(std::string_view cell) {
  const std::string wanted = "a finite number";
  const std::string text(trimmed(cell));
  if (looksLikeDate(text)) return wanted + " (a date that a spreadsheet made of it? format the column as text)";
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (commas > 1 || (commas == 1 && text.find('.') != std::string::npos)) {
    return wanted + " with a decimal point, without separators of thousands";
  }
  if (commas == 1) return wanted + " with a decimal point";
  const auto end = std::find_if(text.begin(), text.end(), [](char c) { return !isDigit(c) && c != '.' && c != '-'; });
  const std::string_view rest = trimmed(std::string_view(text).substr(static_cast<std::size_t>(end - text.begin())));
  if (end == text.begin() || rest.empty() ||
      !parseNumber(trimmed(std::string_view(text.data(), static_cast<std::size_t>(end - text.begin())))))
    return wanted;
  return wanted + (rest == "%" ? " without %" : " without its unit");
}

}  // namespace tactus::base
