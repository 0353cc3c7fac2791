// `tactus import` on the command line.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

class ImportTest : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    const std::string path = folder_.file(name);
    writeText(path, text);
    return path;
  }

  const std::string small_ =
      "Engine: pump\nInputVariable: speed\n  range: 0 10\n  term: low Ramp 10 0\n  term: high Ramp 0 10\n"
      "OutputVariable: force\n  range: 0 8\n  aggregation: Maximum\n  defuzzifier: Centroid 100\n"
      "  lock-previous: true\n  term: small Triangle 1 2 3\n  term: large Triangle 5 6 7\n"
      "RuleBlock:\n  implication: AlgebraicProduct\n  rule: if speed is low then force is small\n"
      "  rule: if speed is high then force is large\n";
  support::TempFolder folder_;
};

TEST_F(ImportTest, WritesAModelFileWithChecks) {
  const std::string out = folder_.file("pump.tactus.json");
  const ProgramRun made({"import", file("pump.fll", small_), "--out", out});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.out, out + ": pump; inputs 1, output force, rules 2\n");
  EXPECT_NE(
      made.err.find("tactus: warning: " + folder_.file("pump.fll") + ": line 10, column 18: the last value is kept"),
      std::string::npos)
      << made.err;
  const auto read = model_io::readModel(out);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_FALSE(read->model.checks.empty());
  EXPECT_EQ(read->model.generator.substr(0, 7), "tactus ");
  EXPECT_FALSE(read->model.created_utc.empty());
  const auto compiled = fuzzy::compile(read->model);
  // Scaled by 0.75 and 0.25, the triangles have their areas in this ratio.
  EXPECT_NEAR(compiled->evaluate(std::vector<double>{2.5}).force_n, 0.75 * 2 + 0.25 * 6, 1e-14);
}

TEST_F(ImportTest, JsonNamesWhatWasRead) {
  const ProgramRun made({"import", file("pump.txt", small_), "--out", folder_.file("m.json"), "--json"});
  ASSERT_EQ(made.status, 0) << made.err;
  const Json result = Json::parse(made.out);
  EXPECT_EQ(result["format"], "fll");
  EXPECT_EQ(result["inputs"], Json::parse("[\"speed\"]"));
  EXPECT_EQ(result["output"], "force");
  EXPECT_EQ(result["rules"], 2);
  EXPECT_EQ(result["warnings"].size(), 1U);
}

TEST_F(ImportTest, AWrongFileIsOneSentenceAndNoModel) {
  const std::string out = folder_.file("m.json");
  const std::string path = file("pump.fll", small_ + "  rule: if speed is very low then force is small\n");
  const ProgramRun refused({"import", path, "--out", out});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.err,
            "tactus: " + path +
                ": line 17, column 21: found the hedge 'very', wanted terms without hedges, which Tactus lacks\n");
  EXPECT_FALSE(std::filesystem::exists(out));
  const std::string good = file("good.fll", small_);
  EXPECT_EQ(ProgramRun({"import", good, "--out", good}).status, 1);
  EXPECT_EQ(readText(good), small_);
  EXPECT_EQ(ProgramRun({"import", good, "--out", out, "--from", "fis"}).status, 1);
  EXPECT_EQ(ProgramRun({"import", good, "--out", out, "--from", "fml"}).status, 2);
  EXPECT_EQ(ProgramRun({"import", good}).status, 2);
  EXPECT_EQ(ProgramRun({"import", folder_.file("nowhere.fll"), "--out", out}).status, 1);
}

TEST_F(ImportTest, SeveralOutputsAskForOne) {
  std::string text = small_;
  text.insert(text.find("RuleBlock"), "OutputVariable: heat\n  range: 0 1\n  term: some Triangle 0 1 2\n");
  const std::string path = file("two.fll", text);
  const ProgramRun asked({"import", path, "--out", folder_.file("m.json")});
  EXPECT_EQ(asked.status, 1);
  EXPECT_NE(
      asked.err.find("found 2 outputs, 'force', 'heat', wanted the choice of one of them, the force: --output NAME"),
      std::string::npos)
      << asked.err;
  EXPECT_EQ(ProgramRun({"import", path, "--out", folder_.file("m.json"), "--output", "force"}).status, 0);
}

TEST_F(ImportTest, WhatConvertWritesComesBack) {
  const std::string model = folder_.file("s4.json");
  ASSERT_TRUE(model_io::writeModel(support::s4Shifted(), model));
  const auto before = fuzzy::compile(support::s4Shifted());
  for (const auto& [to, name] :
       {std::pair{"fll", "S4.fll"}, {"fcl", "S4.iec.fcl"}, {"fcl-fuzzylite", "S4.fuzzylite.fcl"}, {"fis", "S4.fis"}}) {
    ASSERT_EQ(ProgramRun({"convert", model, "--to", to, "--out", folder_.file("out")}).status, 0);
    const std::string back = folder_.file(std::string(to) + ".json");
    const ProgramRun made({"import", folder_.file("out/") + name, "--out", back});
    ASSERT_EQ(made.status, 0) << made.err;
    const auto read = model_io::readModel(back);
    ASSERT_TRUE(read) << read.error().message();
    const auto after = fuzzy::compile(read->model);
    for (const auto& point :
         {std::vector<double>{1, 45, 30, 30}, {1, 45, 130, 60}, {0.3, 20, 300, 200}, {0.7, 65, 440, 140}}) {
      // 1e-12 of the range of 1.1 N.
      EXPECT_NEAR(after->evaluate(point).force_n, before->evaluate(point).force_n, 1.1e-12) << to;
    }
  }
}

}  // namespace
}  // namespace tactus::cli
