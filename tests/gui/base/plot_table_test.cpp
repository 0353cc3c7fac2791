#include "app/workbench/base/plot_table.h"

#include <gtest/gtest.h>

#include "core/base/tables/csv.h"

namespace tactus::workbench {
namespace {

TEST(PlotTable, ColumnsHaveTheirUnitInTheName) {
  EXPECT_EQ(columnName("depth", "mm"), "depth_mm");
  EXPECT_EQ(columnName("speed", "mm/s"), "speed_mm_s");
  EXPECT_EQ(columnName("force", "N"), "force_n");
  EXPECT_EQ(columnName("lubrication", "1"), "lubrication");
  EXPECT_EQ(columnName("share", "%"), "share");
  fuzzy::Variable output;
  output.id = "force";
  output.unit = "N";
  fuzzy::Expert expert;
  expert.id = "S1";
  EXPECT_EQ(columnName(output, expert), "force_S1_n");
}

TEST(PlotTable, TheReaderOfTheProjectReadsWhatIsWritten) {
  PlotTable table;
  table.caption = {QStringLiteral("A model: force along depth"), QStringLiteral("two\nlines")};
  table.columns = {"depth_mm", "force_n", "who"};
  table.rows = {{0.1, 1.0 / 3, std::string("S1, the \"first\"")}, {600.0, {}, std::string()}};
  const auto read = base::CsvTable::parse(csvText(table), "table.csv");
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->columns(), table.columns);
  ASSERT_EQ(read->rowCount(), 2U);
  EXPECT_EQ(read->number(0, 0).value(), 0.1);
  EXPECT_EQ(read->number(0, 1).value(), 1.0 / 3);
  EXPECT_EQ(read->cell(0, 2), "S1, the \"first\"");
  EXPECT_EQ(read->cell(1, 1), "");
}

TEST(PlotTable, TabsSeparateTheCellsOfTheClipboard) {
  PlotTable table;
  table.caption = {QStringLiteral("Caption")};
  table.columns = {"a", "b"};
  table.rows = {{1.5, std::string("x\ty")}};
  EXPECT_EQ(tabText(table), "# Caption\na\tb\n1.5\tx y\n");
}

}  // namespace
}  // namespace tactus::workbench
