#include "core/base/tables/csv.h"

#include <gtest/gtest.h>
#include <limits>
#include <malloc.h>
#include <string>

#include "tests/core/base/tables/csv_error.h"

namespace tactus::base {
namespace {

TEST(Csv, ReadsCellsWithQuotesCommentsAndAnyLineEnd) {
  const auto table = CsvTable::parse(
      "\xEF\xBB\xBF# comment, with \"quote\r\n a ,b\r\n\r\n1,\"x, \"\"y\"\"\nz\"\n#2,no comment\n3,\"\"\r\"#4\",last",
      "t.csv");
  ASSERT_TRUE(table.has_value()) << table.error().message();
  EXPECT_EQ(table->columns(), (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(table->rowCount(), 4U);
  EXPECT_EQ(table->cell(0, 1), "x, \"y\"\nz");
  EXPECT_EQ(table->cell(1, 0), "#2") << "comments stand above the header only: no row may vanish";
  EXPECT_EQ(table->cell(2, 0), "3");
  EXPECT_EQ(table->cell(2, 1), "");
  EXPECT_EQ(table->cell(3, 0), "#4");
  EXPECT_EQ(table->cell(3, 1), "last");
  EXPECT_EQ(table->place(0, 0), "line 4, column 'a'");
  EXPECT_EQ(table->place(2, 1), "line 7, column 'b'");
}

TEST(Csv, CellsAfterQuotesCommentsAndEmptyLinesStayTheirOwn) {
  const auto table =
      CsvTable::parse("#\n\"a\"\"\",b,c\n\"\",,\"\"\n\n\"\"\"\",\"1,2\",x\n\n\n,,y\nä,\"\n\",\r\n,,", "t.csv");
  ASSERT_TRUE(table.has_value()) << table.error().message();
  EXPECT_EQ(table->columns(), (std::vector<std::string>{"a\"", "b", "c"}));
  const std::vector<std::vector<std::string>> wanted = {
      {"", "", ""}, {"\"", "1,2", "x"}, {"", "", "y"}, {"ä", "\n", ""}};
  const std::vector<std::size_t> lines = {3, 5, 8, 9};
  ASSERT_EQ(table->rowCount(), wanted.size());
  for (std::size_t row = 0; row < wanted.size(); ++row) {
    for (std::size_t column = 0; column < 3; ++column) EXPECT_EQ(table->cell(row, column), wanted[row][column]);
    EXPECT_EQ(table->line(row), lines[row]);
  }
}

#ifdef __GLIBC__
TEST(Csv, ATableOfShortCellsNeedsLessThanThreeTimesItsText) {
  // What malloc has handed out; 0 where a sanitizer replaces it.
  const auto used = [] {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
  };
  const std::size_t before = used();
  std::string text = "a,b,c\n";
  constexpr std::size_t kBytes = 4'000'000;
  text.reserve(kBytes + 10);
  while (text.size() < kBytes) text += "lub,spd,3\n";
  const auto table = CsvTable::parse(std::move(text), "t.csv");
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ(table->cell(table->rowCount() - 1, 1), "spd");
  EXPECT_LT(used() - before, 3 * kBytes);
}
#endif

TEST(Csv, CopiesShareTheirText) {
  CsvTable copy;
  {
    const auto table = CsvTable::parse("a\nlong enough to live on the heap\n", "t.csv");
    ASSERT_TRUE(table.has_value());
    copy = *table;
  }
  EXPECT_EQ(copy.cell(0, 0), "long enough to live on the heap");
}

TEST(Csv, NumbersOfACell) {
  const auto table = CsvTable::parse("n\n 0.5 \n1e-3\n-7\n\nnan\n1e999\n0,5\n", "t.csv");
  ASSERT_FALSE(table.has_value());
  EXPECT_EQ(table.error().message(),
            "t.csv: line 8: found 2 cells, wanted 1 as in the first line (decimal commas? then semicolons between the "
            "cells)");
  const auto good = CsvTable::parse("n,m\n 0.5 ,7\n1e-3,7.5\nnan,\n1e999,x\n", "t.csv");
  ASSERT_TRUE(good.has_value());
  EXPECT_EQ(good->number(0, 0), 0.5);
  EXPECT_EQ(good->number(1, 0), 0.001);
  EXPECT_EQ(good->integer(0, 1), 7);
  EXPECT_EQ(good->integer(1, 1).error().message(), "t.csv: line 3, column 'm': found '7.5', wanted an integer");
  EXPECT_EQ(good->number(2, 0).error().message(), "t.csv: line 4, column 'n': found 'nan', wanted a finite number");
  EXPECT_EQ(good->number(2, 1).error().message(),
            "t.csv: line 4, column 'm': found an empty cell, wanted a finite number");
  EXPECT_EQ(good->number(3, 0).error().code, ErrorCode::kValue);
}

TEST(Csv, RefusesWhatIsNotATable) {
  EXPECT_EQ(errorOf(""), "t.csv: found an empty table, wanted a header line with the names of the columns");
  EXPECT_EQ(errorOf("# only a comment\n"),
            "t.csv: found an empty table, wanted a header line with the names of the columns");
  EXPECT_EQ(errorOf("a,b,a\n"), "t.csv: line 1: found column 'a' twice, wanted each column once");
  EXPECT_EQ(errorOf("\n\na,,b\n"), "t.csv: line 3: found a column without a name, wanted a name for every column");
  EXPECT_EQ(errorOf("a,b\n1\n"), "t.csv: line 2: found 1 cells, wanted 2 as in the first line");
  EXPECT_EQ(errorOf("a\n\"open\n\n"), "t.csv: line 2: found an opening quote without its end, wanted a closing quote");
  EXPECT_EQ(errorOf("a\n\"x\"y\n"),
            "t.csv: line 2: found text after a closing quote, wanted a comma or the end of the line");
  EXPECT_EQ(errorOf("a\ncaf\xE9 \x81\n"),
            "t.csv: found bytes that are not UTF-8 text, nor plainly Windows-1252 or GB 18030, wanted a CSV table in "
            "UTF-8: save it again as \"CSV UTF-8\"");
  EXPECT_EQ(errorOf("a\n" + std::string(2'000'000, 'x')),
            "t.csv: line 2: found a line of more than 1 MiB, wanted rows of comma-separated cells");
}

TEST(Csv, MissingColumnsAreNamed) {
  const auto table = CsvTable::parse("force_n,term\n", "t.csv");
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ(table->require("term"), 1U);
  EXPECT_EQ(table->require("step").error().message(),
            "t.csv: header: found the columns 'force_n', 'term', wanted a column 'step'");
  EXPECT_FALSE(table->find("Term").has_value());
}

TEST(Csv, WriterQuotesOnlyWhereItMust) {
  CsvWriter csv({"a", "b,c"});
  csv.cell("plain").cell(0.1).endRow();
  csv.cell("#no comment").cell(std::string_view("say \"hi\"\n")).endRow();
  csv.cell(-3).cell("").endRow();
  EXPECT_EQ(csv.text(), "a,\"b,c\"\nplain,0.1\n\"#no comment\",\"say \"\"hi\"\"\n\"\n-3,\n");
}

TEST(Csv, WhatIsWrittenReadsBack) {
  const std::vector<std::string> cells = {"", "#", "\"", "a,b", "\r\n", " spaces ", "Ä", "'"};
  CsvWriter one({"only"});
  for (const auto& cell : cells) one.cell(cell).endRow();
  const auto table = CsvTable::parse(one.text(), "t.csv");
  ASSERT_TRUE(table.has_value()) << table.error().message();
  ASSERT_EQ(table->rowCount(), cells.size());
  for (std::size_t row = 0; row < cells.size(); ++row) EXPECT_EQ(table->cell(row, 0), cells[row]);
}

TEST(Csv, AHeaderCanBeOptional) {
  const auto bare = CsvTable::parse("1,1\n2,3\n", "t.csv", CsvTable::Header::kOptional);
  ASSERT_TRUE(bare) << bare.error().message();
  EXPECT_FALSE(bare->hasHeader());
  EXPECT_EQ(bare->rowCount(), 2U);
  EXPECT_EQ(bare->number(1, *bare->find("2")).value(), 3);
  const auto named = CsvTable::parse("a,1\n2,3\n", "t.csv", CsvTable::Header::kOptional);
  ASSERT_TRUE(named);
  EXPECT_TRUE(named->hasHeader());
  EXPECT_EQ(named->rowCount(), 1U);
}

TEST(Csv, WhatLooksLikeAFormulaIsGuardedAndComesBack) {
  for (const char* const formula : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1"}) {
    EXPECT_TRUE(looksLikeFormula(formula)) << formula;
    EXPECT_EQ(guarded(formula), '\'' + std::string(formula));
  }
  for (const char* const plain : {"", "a=1", "1-2", " =1", "'s", "'", "''", "ä"}) {
    EXPECT_FALSE(looksLikeFormula(plain)) << plain;
    EXPECT_EQ(guarded(plain), plain);
    EXPECT_EQ(withoutGuard(plain), plain);
  }
  for (const char* const text : {"=1", "'=1", "''=1", "'a", "-", "'-"}) EXPECT_EQ(withoutGuard(guarded(text)), text);
}

TEST(Csv, SaysWhetherItBeganWithAMark) {
  EXPECT_TRUE(CsvTable::parse("\xEF\xBB\xBF"
                              "a\n1\n",
                              "t.csv")
                  ->hasMark());
  EXPECT_FALSE(CsvTable::parse("a\n1\n", "t.csv")->hasMark());
}

}  // namespace
}  // namespace tactus::base
