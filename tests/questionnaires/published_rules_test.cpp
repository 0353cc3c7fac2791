#include "questionnaires/published_rules.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <map>

#include "core/base/tables/csv.h"
#include "questionnaires/form_file.h"

#include "tests/questionnaires/paper_table.h"

namespace tactus::questionnaires {
namespace {

struct MatrixRow {
  const char* input;
  const char* term;
  std::array<const char*, 5> force;
};

// Table A2 laid out by hand: one row per condition, one column per printed region.
constexpr std::array<const char*, 5> kPrintedRegions = {"nasal_cavity", "nasopharynx", "laryngopharynx", "esophagus",
                                                        "stomach"};
constexpr std::array<MatrixRow, 9> kMatrix = {{
    {"lubrication", "well", {"VS", "S", "S", "M", "VS"}},
    {"lubrication", "medium", {"VS", "S", "S", "L", "S"}},
    {"lubrication", "poor", {"L", "VL", "VL", "VL", "L"}},
    {"neck_flexion", "small", {"VS", "M", "M", "M", "S"}},
    {"neck_flexion", "medium", {"VS", "M", "M", "M", "S"}},
    {"neck_flexion", "large", {"VS", "M", "L", "VL", "M"}},
    {"speed", "slow", {"VS", "M", "M", "S", "VS"}},
    {"speed", "medium", {"S", "L", "L", "L", "S"}},
    {"speed", "fast", {"M", "VL", "VL", "VL", "L"}},
}};
const std::map<std::string, std::string> kForceTerms = {
    {"VS", "very_small"}, {"S", "small"}, {"M", "medium"}, {"L", "large"}, {"VL", "very_large"}};

/// The consequent of the rule on `input` is `term` and depth is `region`; empty where there is none or several.
std::string consequent(const std::vector<study::GivenRule>& rules, const MatrixRow& row, const std::string& region) {
  std::string found;
  for (const auto& rule : rules) {
    const auto has = [&rule](const study::ItemCondition& condition) {
      return std::find(rule.conditions.begin(), rule.conditions.end(), condition) != rule.conditions.end();
    };
    if (rule.conditions.size() != 2 || !has({row.input, row.term}) || !has({"depth", region})) continue;
    if (!found.empty()) return {};
    found = rule.then;
  }
  return found;
}

void expectMatrix(const std::string& reading, const std::array<const char*, 5>& regions) {
  const auto rules = s4Rules(reading);
  ASSERT_TRUE(rules) << rules.error().message();
  EXPECT_EQ(rules->size(), 45U);
  for (const auto& row : kMatrix) {
    for (std::size_t i = 0; i < regions.size(); ++i) {
      EXPECT_EQ(consequent(*rules, row, regions[i]), kForceTerms.at(row.force[i]))
          << reading << ": " << row.input << " " << row.term << ", " << regions[i];
    }
  }
  for (const auto& rule : *rules) {
    EXPECT_EQ(rule.participant, "S4");
    EXPECT_EQ(rule.form, reading);
    EXPECT_EQ(rule.weight, 1);
  }
}

TEST(TableA2, AsPrinted) { expectMatrix("ngt-a2-printed", kPrintedRegions); }

TEST(TableA2, ShiftedRegions) {
  expectMatrix("ngt-a2-shifted", {"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus"});
}

TEST(TableA2, FiveRegionsIsTheDefault) {
  expectMatrix("ngt-a2-five-regions", kPrintedRegions);
  EXPECT_EQ(s4Rules().value(), s4Rules("ngt-a2-five-regions").value());
}

TEST(TableA2, HasTheWordingOfThePaper) {
  const auto printed = paperTable("table_a2.txt");
  const auto table = base::CsvTable::parse(std::string(tableA2Csv()), "table_a2.csv");
  ASSERT_TRUE(table);
  ASSERT_EQ(printed.size(), 45U);
  ASSERT_EQ(table->rowCount(), 45U);
  for (std::size_t i = 0; i < 45; ++i) {
    EXPECT_EQ(table->integer(i, 0).value(), printed[i].first);
    EXPECT_EQ(table->cell(i, 1), printed[i].second);
  }
}

TEST(TableA2, EachReadingSaysWhatItAssumes) {
  const auto readings = s4Readings();
  ASSERT_EQ(readings.size(), 3U);
  for (const auto& reading : readings) {
    EXPECT_TRUE(reading.assumes.ends_with(".")) << reading.id;
    EXPECT_EQ(reading.regions.size(), 5U) << reading.id;
  }
}

TEST(TableA2, UnknownReadingIsRefusedWithTheKnownOnes) {
  const auto rules = s4Rules("ngt-a2");
  ASSERT_FALSE(rules);
  EXPECT_EQ(rules.error().message(),
            "reading of Table A2: found 'ngt-a2', wanted one of ngt-a2-printed, ngt-a2-shifted, ngt-a2-five-regions");
}

}  // namespace
}  // namespace tactus::questionnaires
