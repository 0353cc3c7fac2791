#include "core/base/tables/odd_cell.h"

#include <gtest/gtest.h>

namespace tactus::base {
namespace {

TEST(OddCell, DatesOfSpreadsheets) {
  for (const char* date : {"05. Jan", "5-Jan", "Jan-05", "1. Mrz", "12 Dez 2026", "2026-01-05", "05.01.2026", "1/5/26",
                           "5-January", " 5-Oct "})
    EXPECT_TRUE(looksLikeDate(date)) << date;
  for (const char* other : {"", "5", "0.5", "-5", "1-5", "N-05", "MAR3", "Jan", "S1", "A-12-3", "1.2.3.4", "2026",
                            "a b c", "12-34-5678-9", "jan feb", "0.5 N", "3 marks"})
    EXPECT_FALSE(looksLikeDate(other)) << other;
}

TEST(OddCell, WordsForNothing) {
  for (const char* word : {"-", "\u2013", "\u2014", "NA", "n/a", "N.A.", "#N/A", "NULL", "?", " na "})
    EXPECT_TRUE(isMissingWord(word)) << word;
  for (const char* word : {"", "0", "small", "--x", "nan1", "no", "none"}) EXPECT_FALSE(isMissingWord(word)) << word;
}

TEST(OddCell, WhatIsWantedNamesAPlainCause) {
  EXPECT_EQ(numberWanted("much"), "a finite number");
  EXPECT_EQ(numberWanted("nan"), "a finite number");
  EXPECT_EQ(numberWanted(""), "a finite number");
  EXPECT_EQ(numberWanted("0,5"), "a finite number with a decimal point");
  EXPECT_EQ(numberWanted("1,234.5"), "a finite number with a decimal point, without separators of thousands");
  EXPECT_EQ(numberWanted("1.234,5"), "a finite number with a decimal point, without separators of thousands");
  EXPECT_EQ(numberWanted("25%"), "a finite number without %");
  EXPECT_EQ(numberWanted("25 %"), "a finite number without %");
  EXPECT_EQ(numberWanted("0.5 N"), "a finite number without its unit");
  EXPECT_EQ(numberWanted("12 years"), "a finite number without its unit");
  EXPECT_EQ(numberWanted("05. Jan"),
            "a finite number (a date that a spreadsheet made of it? format the column as text)");
}

}  // namespace
}  // namespace tactus::base
