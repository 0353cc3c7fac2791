// Tables as spreadsheets of other countries save them: read where it is plain, and said; otherwise refused.
#include <gtest/gtest.h>
#include <string>

#include "core/base/tables/csv.h"
#include "core/base/tables/text_encoding.h"

#include "tests/core/base/tables/csv_error.h"

namespace tactus::base {
namespace {

CsvTable tableOf(std::string text) {
  auto table = CsvTable::parse(std::move(text), "t.csv");
  EXPECT_TRUE(table.has_value()) << table.error().message();
  return table.value();
}

std::string numberError(std::string text) {
  const auto table = tableOf(std::move(text));
  const auto number = table.number(0, table.columns().size() - 1);
  return number ? "accepted " + std::to_string(*number) : number.error().message();
}

std::string utf16(const std::string& ascii, bool little, bool mark) {
  std::string out;
  if (mark) out = little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : ascii) out += little ? std::string({c, '\0'}) : std::string({'\0', c});
  return out;
}

TEST(CsvSpreadsheets, SemicolonsAndDecimalCommas) {
  const auto table = tableOf("code;time_s;speed_mm_s\r\nA;0,001;46,125\r\nB;0,002;-3\r\n");
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"code", "time_s", "speed_mm_s"}));
  EXPECT_EQ(table.number(0, 1).value(), 0.001);
  EXPECT_EQ(table.number(0, 2).value(), 46.125) << "0,001 can only be a decimal, so 46,125 is one";
  EXPECT_EQ(table.number(1, 2).value(), -3);
  EXPECT_EQ(table.note(), "t.csv: read with semicolons between the cells, decimal commas");
}

TEST(CsvSpreadsheets, BarsAndCaretsWhereNothingElseSeparates) {
  const auto bars = tableOf("code|text\nA|\"x|y\"\n");
  EXPECT_EQ(bars.columns(), (std::vector<std::string>{"code", "text"}));
  EXPECT_EQ(bars.cell(0, 1), "x|y");
  EXPECT_EQ(bars.note(), "t.csv: read with vertical bars between the cells");
  EXPECT_EQ(tableOf("code^text\nA^b,c\n").note(), "t.csv: read with carets between the cells");
  EXPECT_EQ(tableOf("a|b,c^d\n1,2\n").columns(), (std::vector<std::string>{"a|b", "c^d"}));
}

TEST(CsvSpreadsheets, TabsAndDecimalPoints) {
  EXPECT_EQ(tableOf("a\tb, c\n1.5\tx,2\n").columns(), (std::vector<std::string>{"a\tb", "c"}))
      << "a comma in the first line separates";
  const auto tabs = tableOf("a\tb\n1.5\tx, y\n");
  EXPECT_EQ(tabs.cell(0, 1), "x, y");
  EXPECT_EQ(tabs.number(0, 0).value(), 1.5);
  EXPECT_EQ(tabs.note(), "t.csv: read with tabs between the cells");
}

TEST(CsvSpreadsheets, PlainTablesSayNothing) {
  EXPECT_EQ(tableOf("a,b\n1.5,x\n").note(), std::nullopt);
  EXPECT_EQ(tableOf("\xEF\xBB\xBF"
                    "a,b\n1,\xE6\x85\xA2\n")
                .note(),
            std::nullopt);
  EXPECT_EQ(tableOf("a,\"b;c\"\n1,2\n").columns().size(), 2U) << "semicolons in quotes separate nothing";
}

TEST(CsvSpreadsheets, ALineThatNamesTheSeparator) {
  const auto table = tableOf("sep=;\r\na;b\r\n1;2\r\n");
  EXPECT_EQ(table.columns().size(), 2U);
  EXPECT_EQ(table.cell(0, 1), "2");
  EXPECT_EQ(table.line(0), 3U);
}

TEST(CsvSpreadsheets, NumbersThatNobodyCanBeSureOfAreRefused) {
  EXPECT_EQ(numberError("a,b\n1,\"1,234\"\n"),
            "t.csv: line 2, column 'b': found '1,234', wanted a finite number with a decimal point");
  EXPECT_EQ(numberError("a;b\n1;1,234\n"),
            "t.csv: line 2, column 'b': found '1,234', wanted a finite number with a decimal point");
  EXPECT_EQ(numberError("a;b\n0.5;1,5\n"),
            "t.csv: line 2, column 'b': found '1,5', wanted a finite number with a decimal point");
  EXPECT_EQ(numberError("a;b\n0,5;1.234,5\n"),
            "t.csv: line 2, column 'b': found '1.234,5', wanted a finite number with a decimal point, without "
            "separators of thousands");
  EXPECT_EQ(errorOf("a,b\n1,5,2\n"),
            "t.csv: line 2: found 3 cells, wanted 2 as in the first line (decimal commas? then semicolons between the "
            "cells)");
}

TEST(CsvSpreadsheets, KindsOfCommas) {
  using Cell = DecimalCommas::Cell;
  for (const char* cell : {"1,5", "-0,125", "0,001", "1234,567", " 12,50 ", "1,5e3", "1,5E-03"})
    EXPECT_EQ(DecimalCommas::kindOf(cell), Cell::kDecimal) << cell;
  for (const char* cell : {"1,234", "-12,345", "999,000"})
    EXPECT_EQ(DecimalCommas::kindOf(cell), Cell::kEither) << cell;
  for (const char* cell : {"1,234,567", "1,234.5", "123,456.7", "12,345,678"})
    EXPECT_EQ(DecimalCommas::kindOf(cell), Cell::kThousands) << cell;
  for (const char* cell : {"1.5", "-.5"}) EXPECT_EQ(DecimalCommas::kindOf(cell), Cell::kPoint) << cell;
  for (const char* cell : {"", ",", "1,", ",5", "a,b", "1,b", "1,2,3", "12", "1 2,5", "1.234,5"})
    EXPECT_EQ(DecimalCommas::kindOf(cell), Cell::kOther) << cell;
}

TEST(CsvSpreadsheets, EmptyColumnsAndRowsAtTheEnd) {
  const auto table = tableOf("a,b,,\n1,2,,\n,,,\n3,4,,\n,,,\n,,,\n");
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(table.rowCount(), 2U);
  EXPECT_EQ(table.cell(0, 1), "2");
  EXPECT_EQ(table.cell(1, 0), "3");
  EXPECT_EQ(table.cell(1, 1), "4");
  EXPECT_EQ(table.line(1), 4U);
  const auto wide = tableOf("a,b\n1,2,,\n3,4\n");
  EXPECT_EQ(wide.cell(0, 1), "2");
  EXPECT_EQ(wide.cell(1, 1), "4");
  EXPECT_EQ(errorOf("a,b,,\n1,2,3,\n"),
            "t.csv: line 2: found 4 cells, wanted a name for every column that holds something");
  EXPECT_EQ(errorOf("a,b\n1\n"), "t.csv: line 2: found 1 cells, wanted 2 as in the first line");
  EXPECT_EQ(errorOf("a,,b\n1,2,3\n"), "t.csv: line 1: found a column without a name, wanted a name for every column");
}

TEST(CsvSpreadsheets, HeadersWithUnitsCapitalsAndSpaces) {
  const auto table = tableOf("Participant;Speed [mm/s];Time (s);Neck flexion\nA;1;2;3\n");
  EXPECT_EQ(table.find("participant"), 0U);
  EXPECT_EQ(table.find("speed_mm_s"), 1U);
  EXPECT_EQ(table.find("time_s"), 2U);
  EXPECT_EQ(table.find("neck_flexion"), 3U);
  EXPECT_EQ(table.find("speed"), std::nullopt) << "without its unit it is another name";
  EXPECT_EQ(tableOf("a b,a-b\n1,2\n").find("a_b"), std::nullopt) << "two columns could be meant";
  EXPECT_EQ(tableOf("a b,a_b\n1,2\n").find("a_b"), 1U) << "the exact name comes first";
  EXPECT_EQ(tableOf("Speed [cm/s],x\n1,2\n").require("speed_mm_s").error().message(),
            "t.csv: header: found the columns 'Speed [cm/s]', 'x', wanted a column 'speed_mm_s'");
  EXPECT_EQ(tableOf("sped_mm_s,x\n1,2\n").require("speed_mm_s").error().message(),
            "t.csv: header: found the columns 'sped_mm_s', 'x', wanted a column 'speed_mm_s' (sped_mm_s?)");
}

TEST(CsvSpreadsheets, Windows1252) {
  const auto table = tableOf("code;category\nA;Anf\xE4nger \x96 gro\xDF\n");
  EXPECT_EQ(table.cell(0, 1), "Anfänger – groß");
  EXPECT_EQ(table.note(), "t.csv: read with semicolons between the cells, text in Windows-1252");
  EXPECT_EQ(tableOf("a,b\n1,Gr\xF6\xDF"
                    "e f\xFCr\n")
                .cell(0, 1),
            "Größe für");
}

TEST(CsvSpreadsheets, Gb18030) {
  // 慢, 快 and 专家 in GB 2312, as a Chinese Excel saves them.
  const auto table = tableOf("code,category\nA,\xC2\xFD\nB,\xBF\xEC\nC,\xD7\xA8\xBC\xD2\n");
  EXPECT_EQ(table.cell(0, 1), "慢");
  EXPECT_EQ(table.cell(1, 1), "快");
  EXPECT_EQ(table.cell(2, 1), "专家");
  EXPECT_EQ(table.note(), "t.csv: read with text in GB 18030");
}

TEST(CsvSpreadsheets, Utf16) {
  for (const bool little : {true, false}) {
    for (const bool mark : {true, false}) {
      const auto table = tableOf(utf16("code\tspeed_mm_s\r\nA\t12,5\r\n", little, mark));
      EXPECT_EQ(table.number(0, 1).value(), 12.5);
      EXPECT_EQ(table.note(), "t.csv: read with tabs between the cells, decimal commas, text in UTF-16");
    }
  }
  EXPECT_EQ(tableOf("\xFF\xFE" + std::string("a\0,\0b\0\n\0\x62\x61,\0"
                                             "2\0",
                                             14))
                .cell(0, 0),
            "慢");
  EXPECT_EQ(errorOf("\xFF\xFE"
                    "a"),
            "t.csv: found text that begins as UTF-16 and is none, wanted a table saved as CSV in UTF-8");
}

TEST(CsvSpreadsheets, RandomBytesNeverReadAsMoreThanTheyAre) {
  // Every byte string is refused or read; none crashes or is read beyond its end.
  std::uint64_t state = 1;
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    const std::string letters = "ab12,;\t\n\r\"#=.\xFF\xFE\xE4\xC2\xFD\x81" + std::string(1, '\0');
    for (int i = 0; i < round % 60; ++i) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      text += letters[(state >> 33U) % letters.size()];
    }
    const auto table = CsvTable::parse(text, "t.csv");
    if (!table) continue;
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
      std::size_t size = 0;
      for (std::size_t column = 0; column < table->columns().size(); ++column) size += table->cell(row, column).size();
      EXPECT_LE(size, 3 * text.size());
      EXPECT_GE(table->line(row), 1U);
    }
  }
}

}  // namespace
}  // namespace tactus::base
