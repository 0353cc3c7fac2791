// The rules of Psych-DS, one by one, on a small study.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "app/dataset/dataset.h"
#include "core/base/tables/csv.h"
#include "core/study/csv_tables.h"

#include "tests/app/dataset/small_study.h"
#include "tests/support/default_procedure.h"
#include "tests/support/temp_folder.h"

namespace tactus::dataset {
namespace {

class PsychDs : public testing::Test {
 protected:
  PsychDs() {
    const auto done = writeDataSet(smallStudy(), Layout::kPsychDs, out_, 1, "tactus 9.8.7");
    EXPECT_TRUE(done) << done.error().message();
    files_ = filesBelow(out_);
  }

  nlohmann::json description() const { return nlohmann::json::parse(files_.at("dataset_description.json")); }

  nlohmann::json variables() const { return description()["variableMeasured"]; }

  support::TempFolder folder_;
  std::string out_ = folder_.file("out");
  std::map<std::string, std::string> files_;
};

TEST_F(PsychDs, TheDescriptionIsAJsonLdDataset) {
  const auto json = description();
  EXPECT_EQ(json["@context"], "https://schema.org/");
  EXPECT_EQ(json["@type"], "Dataset");
  EXPECT_FALSE(json["name"].get<std::string>().empty());
  EXPECT_NE(json["description"].get<std::string>().find("Simulated by a program, not measured: the data of 1 of 3"),
            std::string::npos);
}

TEST_F(PsychDs, VariableMeasuredListsEveryColumnOfEveryTableOnceAndNothingElse) {
  std::set<std::string> columns;
  for (const auto& [name, bytes] : files_) {
    if (!name.ends_with(".csv")) continue;
    const auto table = base::CsvTable::parse(bytes, name);  // refuses ragged rows
    ASSERT_TRUE(table) << table.error().message();
    columns.insert(table->columns().begin(), table->columns().end());
  }
  std::multiset<std::string> listed;
  for (const auto& variable : variables()) {
    EXPECT_EQ(variable["@type"], "PropertyValue");
    EXPECT_FALSE(variable["description"].get<std::string>().empty());
    listed.insert(variable["name"].get<std::string>());
  }
  EXPECT_EQ(listed, std::multiset<std::string>(columns.begin(), columns.end()));
  EXPECT_FALSE(columns.contains("row_id"));
}

TEST_F(PsychDs, ColumnsHaveTheirUnits) {
  std::map<std::string, std::string> units;
  for (const auto& variable : variables()) {
    if (variable.contains("unitText")) units[variable["name"]] = variable["unitText"];
  }
  EXPECT_EQ(units, (std::map<std::string, std::string>{{"time_s", "s"},
                                                       {"depth_mm", "mm"},
                                                       {"speed_mm_s", "mm/s"},
                                                       {"force_n", "N"},
                                                       {"years_experience_band", "years"}}));
}

TEST_F(PsychDs, FileNamesAreKeysAndValues) {
  const std::regex wanted("data/([a-z]+-[A-Za-z0-9]+_)+data\\.csv");
  std::size_t tables = 0;
  for (const auto& [name, bytes] : files_) {
    if (!name.ends_with(".csv")) continue;
    ++tables;
    EXPECT_TRUE(std::regex_match(name, wanted)) << name;
    EXPECT_FALSE(bytes.starts_with("\xEF\xBB\xBF")) << name;
  }
  EXPECT_EQ(tables, 5U);
  EXPECT_TRUE(files_.contains("README.md"));
}

TEST_F(PsychDs, ATableWithoutRowsIsLeftOut) {
  auto study = smallStudy();
  study.rules.clear();
  study.answers.clear();
  ASSERT_TRUE(writeDataSet(study, Layout::kPsychDs, out_, 1, "tactus 9.8.7"));
  const auto files = filesBelow(out_);
  EXPECT_FALSE(files.contains("data/study-ngt_description-rules_data.csv"));
  EXPECT_FALSE(files.contains("data/study-ngt_description-answers_data.csv"));
  EXPECT_EQ(files.at("dataset_description.json").find("\"status\""), std::string::npos);
}

TEST_F(PsychDs, IsReadAsAStudy) {
  const auto read = study::readStudyFolder(out_, support::ngtInputIds());
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->study.participants.size(), 3U);
  EXPECT_EQ(read->study.speeds.size(), 8U);
  EXPECT_EQ(read->study.judgements.size(), 3U);
  EXPECT_EQ(read->study.answers.size(), 2U);
  EXPECT_EQ(read->study.rules.at(0).conditions, smallStudy().rules.at(0).conditions);
}

}  // namespace
}  // namespace tactus::dataset
