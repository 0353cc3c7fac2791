#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/base/tables/csv.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class Eval : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(model_io::writeModel(support::s4AsPrinted(), model_).has_value());
    writeText(points_, "id,depth,speed,neck_flexion,lubrication\na,30,30,45,1\nb,130,50,60,1\nc,\"200\",200,0,0\n");
  }

  support::TempFolder folder_;
  std::string model_ = folder_.file("s4.tactus.json");
  std::string points_ = folder_.file("points.csv");
};

// The forces are those of three independent programs, to their six digits.
TEST_F(Eval, AddsForceAndFiredAndKeepsRowsAndColumns) {
  const ProgramRun run({"eval", model_, "--in", points_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto table = base::CsvTable::parse(run.out, "out");
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ(table->columns(),
            (std::vector<std::string>{"id", "depth", "speed", "neck_flexion", "lubrication", "force", "fired"}));
  ASSERT_EQ(table->rowCount(), 3);
  EXPECT_EQ(table->cell(2, 0), "c");
  EXPECT_NEAR(table->number(0, 5).value(), 0.126667, 0.5e-6);
  EXPECT_EQ(table->cell(0, 6), "1");
  EXPECT_EQ(table->cell(1, 5), "0");
  EXPECT_EQ(table->cell(1, 6), "0");
  EXPECT_NEAR(table->number(2, 5).value(), 0.767333, 0.5e-6);
}

TEST_F(Eval, WritesAFileInsteadOfPrinting) {
  const std::string out = folder_.file("out.csv");
  const ProgramRun run({"eval", model_, "--in", points_, "--out", out});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(readText(out), ProgramRun({"eval", model_, "--in", points_}).out);
}

TEST_F(Eval, OneExpertAndTheSampledMethods) {
  EXPECT_EQ(ProgramRun({"eval", model_, "--in", points_, "--expert", "S4"}).out,
            ProgramRun({"eval", model_, "--in", points_}).out);
  for (const char* method : {"midpoint:1000", "linspace:100001"}) {
    const ProgramRun run({"eval", model_, "--in", points_, "--method", method});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(base::CsvTable::parse(run.out, "out")->number(2, 5).value(), 0.767333, 1e-5);
  }
}

TEST_F(Eval, AnOldOutputStaysWhereTheInputIsWrong) {
  const std::string out = folder_.file("out.csv");
  writeText(out, "precious");
  writeText(points_, "lubrication,neck_flexion,depth,speed\n1,45,30,30\n1,45,30,nan\n");
  const ProgramRun run({"eval", model_, "--in", points_, "--out", out});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "tactus: " + points_ + ": line 3, column 'speed': found 'nan', wanted a finite number\n");
  EXPECT_EQ(readText(out), "precious");
}

// What eval prints reads back as the very double that the evaluator gave.
TEST_F(Eval, PrintsEveryDigit) {
  base::Random random(9);
  for (int m = 0; m < 20; ++m) {
    const auto model = support::randomModel(random, {});
    ASSERT_TRUE(model_io::writeModel(model, model_).has_value());
    std::vector<std::string> columns;
    for (const auto& input : model.inputs) columns.push_back(input.id);
    base::CsvWriter csv(columns);
    std::vector<std::vector<double>> points;
    for (int p = 0; p < 10; ++p) {
      points.push_back(support::randomPoint(random, model));
      for (const double value : points.back()) csv.cell(value);
      csv.endRow();
    }
    writeText(points_, csv.text());
    const auto table = base::CsvTable::parse(ProgramRun({"eval", model_, "--in", points_}).out, "out");
    ASSERT_TRUE(table.has_value());
    const auto compiled = fuzzy::compile(model);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto force = compiled->evaluate(points[p]);
      EXPECT_EQ(table->number(p, *table->find("force")).value(), force.force_n);
      EXPECT_EQ(table->cell(p, *table->find("fired")), force.fired ? "1" : "0");
    }
  }
}

}  // namespace
}  // namespace tactus::cli
