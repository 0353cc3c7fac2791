#include "app/session/study_export.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/session/shareable.h"
#include "app/session/study_import.h"
#include "app/session/study_view.h"
#include "core/base/tables/csv.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/record_import.h"
#include "core/store/sessions.h"
#include "core/study/csv_tables.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/default_procedure.h"
#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> bytesBelow(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ostringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    files[entry.path().lexically_relative(folder).generic_string()] = bytes.str();
  }
  return files;
}

/// Four simulated participants with rows in each table; only S4 gave rules.
study::Study tableStudy() {
  study::Study study;
  for (int i = 1; i <= 4; ++i) {
    const std::string code = "S" + std::to_string(i);
    study::Participant participant;
    participant.code = code;
    participant.years_experience = 4 * i;
    participant.category = "expert";
    participant.simulated = true;
    study.participants.push_back(participant);
    for (int sample = 0; sample < 5; ++sample) {
      study.speeds.push_back({code, "slow", 1, 0.001 * sample, 0.1 * i * sample, 100.5 * i});
    }
    study.judgements.push_back({code, "ascending", 1, 0.1 * 3, study::ForceJudgement::Kind::kTerm, "small"});
    study.judgements.push_back({code, "ascending", 2, 0.4, study::ForceJudgement::Kind::kNoAnswer, ""});
    if (i < 4) study.answers.push_back({code, "ngt-force-v1", i, "large", study::Answer::Status::kAnswered});
  }
  study.rules.push_back({"S4", "ngt-a2-printed", {{"depth", "stomach"}, {"speed", "fast"}}, "large", 0.5});
  return study;
}

class ExportedStudy : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }

  /// The study above, in a study file.
  store::StudyFile imported() {
    auto file = store::StudyFile::create(path("a.tactus"), records_.study());
    EXPECT_TRUE(importTables(tableStudy(), *file));
    return *std::move(file);
  }

  support::TempFolder folder_;
  store::SampleRecords records_;
};

TEST_F(ExportedStudy, GivesTheTablesOfTheView) {
  const auto file = imported();
  ASSERT_TRUE(exportStudy(file, path("out")));
  const auto tables = study::readStudyFolder(path("out"), support::ngtInputIds());
  ASSERT_TRUE(tables) << tables.error().message();
  EXPECT_TRUE(tables->notes.empty());
  auto view = studyForElicitation(file);
  ASSERT_TRUE(view);
  view->study.name = "out";
  EXPECT_EQ(tables->study, view->study);
}

TEST_F(ExportedStudy, IsTheSameAfterItsImport) {
  const auto file = imported();
  ASSERT_TRUE(exportStudy(file, path("out")));
  ASSERT_TRUE(store::restoreRecords(path("out/records"), path("b.tactus")));
  const auto restored = store::StudyFile::open(path("b.tactus"));
  ASSERT_TRUE(restored);
  ASSERT_TRUE(exportStudy(*restored, path("again")));
  EXPECT_EQ(bytesBelow(path("out")), bytesBelow(path("again")));
}

TEST_F(ExportedStudy, CodebookDescribesEveryColumnOfEveryTable) {
  const auto file = imported();
  for (const bool is_shareable : {false, true}) {
    const std::string out = path(is_shareable ? "shareable" : "full");
    ExportOptions options;
    options.shareable = is_shareable;
    ASSERT_TRUE(exportStudy(file, out, options));
    const auto codebook = nlohmann::json::parse(std::ifstream(out + "/codebook.json"));
    EXPECT_EQ(codebook["profile"], is_shareable ? "shareable" : "full");
    EXPECT_NE(codebook["notes"][0].get<std::string>().find("4 of 4"), std::string::npos);  // all simulated
    std::set<std::string> described;
    for (const auto& table : codebook["tables"]) {
      std::vector<std::string> columns;
      for (const auto& column : table["columns"]) columns.push_back(column["name"]);
      described.insert(table["file"]);
      const auto csv = base::CsvTable::read(out + '/' + table["file"].get<std::string>());
      ASSERT_TRUE(csv);
      EXPECT_EQ(csv->columns(), columns) << table["file"];
    }
    for (const auto& [name, bytes] : bytesBelow(out)) {
      const bool is_table = name.ends_with(".csv") && name.find("recordings/") == std::string::npos;
      EXPECT_EQ(described.contains(name), is_table) << name;
    }
  }
}

TEST_F(ExportedStudy, HasTheForcesThatEachPersonCalledByEachWord) {
  const auto file = imported();
  ASSERT_TRUE(exportStudy(file, path("out")));
  const auto table = base::CsvTable::read(path("out/word_intervals.csv"));
  ASSERT_TRUE(table) << table.error().message();
  EXPECT_EQ(table->columns(), (std::vector<std::string>{"person", "word", "left_n", "right_n"}));
  ASSERT_EQ(table->rowCount(), 4U) << "no answer is no word";
  EXPECT_EQ(table->cell(3, 0), "S4");
  EXPECT_EQ(table->cell(3, 1), "small");
  EXPECT_EQ(table->number(3, 2).value(), 0.1 * 3);
  EXPECT_EQ(table->number(3, 3).value(), 0.1 * 3);
  // For sharing they have the new codes, in their order.
  ASSERT_TRUE(exportStudy(file, path("shared"), {.shareable = true, .seed = 7}));
  const auto shared = base::CsvTable::read(path("shared/word_intervals.csv")).value();
  const auto judged = base::CsvTable::read(path("shared/judgements.csv")).value();
  for (std::size_t row = 0; row < 4; ++row) EXPECT_EQ(shared.cell(row, 0), judged.cell(2 * row, 0));
}

TEST_F(ExportedStudy, MarksEveryTable) {
  const auto file = imported();
  ExportOptions options;
  options.mark = store::ByteOrderMark::kWrite;
  ASSERT_TRUE(exportStudy(file, path("out"), options));
  for (const auto& [name, bytes] : bytesBelow(path("out"))) {
    EXPECT_EQ(bytes.starts_with("\xEF\xBB\xBF"), name.ends_with(".csv")) << name;
  }
  EXPECT_TRUE(study::readStudyFolder(path("out"), support::ngtInputIds()));
}

TEST_F(ExportedStudy, GuardsFreeTextForSpreadsheetsOnlyAndReadsItBack) {
  auto study = store::makeStudy(path("a.tactus"), records_);
  auto profile = records_.profile(study.session.id);
  profile.category = "=HYPERLINK(\"http://x\")";
  profile.handedness = "'-left";
  profile.gloves = "@SUM(A1)";
  ASSERT_TRUE(append(study.file, profile));
  ExportOptions options;
  ASSERT_TRUE(exportStudy(study.file, path("plain"), options));
  options.mark = store::ByteOrderMark::kWrite;
  ASSERT_TRUE(exportStudy(study.file, path("guarded"), options));
  const auto plain = bytesBelow(path("plain"));
  const auto guarded = bytesBelow(path("guarded"));
  for (const char* table : {"participants.csv", "records/profiles.csv"}) {
    EXPECT_NE(plain.at(table).find("\"=HYPERLINK"), std::string::npos) << table;
    EXPECT_NE(guarded.at(table).find("\"'=HYPERLINK"), std::string::npos) << table;
    EXPECT_NE(guarded.at(table).find("''-left"), std::string::npos) << table;
  }
  EXPECT_NE(guarded.at("records/profiles.csv").find("'@SUM"), std::string::npos);
  EXPECT_NE(plain.at("codebook.md").find("with `--bom`"), std::string::npos);
  EXPECT_NE(guarded.at("codebook.md").find("apostrophe in front, so"), std::string::npos);

  // Both give the same study again.
  ASSERT_TRUE(store::restoreRecords(path("guarded/records"), path("b.tactus")));
  const auto restored = store::StudyFile::open(path("b.tactus"));
  ASSERT_TRUE(restored);
  ASSERT_TRUE(exportStudy(*restored, path("again")));
  EXPECT_EQ(bytesBelow(path("again")), plain);
  const auto tables = study::readStudyFolder(path("guarded"), support::ngtInputIds());
  ASSERT_TRUE(tables) << tables.error().message();
  EXPECT_EQ(tables->study.participants[0].category, profile.category);
  EXPECT_EQ(tables->study.participants[0].handedness, profile.handedness);
}

TEST_F(ExportedStudy, ReplacesAnEarlierExportOnly) {
  const auto file = imported();
  fs::create_directory(path("out"));
  ASSERT_TRUE(exportStudy(file, path("out")));
  ExportOptions options;
  options.shareable = true;
  ASSERT_TRUE(exportStudy(file, path("out/"), options));
  EXPECT_FALSE(fs::exists(path("out/records")));

  std::ofstream(path("out/analysis.R")) << "mine";
  const auto before = bytesBelow(path("out"));
  const auto refused = exportStudy(file, path("out"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(), path("out") +
                                           ": found an earlier export with another file, 'analysis.R', wanted a new or "
                                           "empty folder, or one that an export made");
  fs::create_directory(path("other"));
  std::ofstream(path("other/codebook.json")) << "{}";
  EXPECT_FALSE(exportStudy(file, path("other")));
  EXPECT_FALSE(exportStudy(file, path("a.tactus")));
  EXPECT_EQ(bytesBelow(path("out")), before);
  // Nothing is left of the attempts.
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(path(""))) names.insert(entry.path().filename().string());
  EXPECT_EQ(names, (std::set<std::string>{"a.tactus", "a.tactus-wal", "other", "out"}));
}

TEST_F(ExportedStudy, TwoParticipantsOfOneCodeStayInTheRecords) {
  auto other = store::makeStudy(path("b.tactus"), records_);
  ASSERT_TRUE(other.file.close());
  store::SampleRecords more(5);
  auto study = store::makeStudy(path("a.tactus"), more);
  ASSERT_TRUE(store::mergeStudy(study.file, path("b.tactus"), more.id(), 1));
  const auto done = exportStudy(study.file, path("out"));
  ASSERT_TRUE(done) << done.error().message();
  ASSERT_EQ(done->notes.size(), 1U);
  EXPECT_NE(done->notes[0].find("2 persons with the code 'velvet-otter' (ids "), std::string::npos);
  EXPECT_FALSE(fs::exists(path("out/participants.csv")));
  EXPECT_TRUE(fs::exists(path("out/records/persons.csv")));
  ExportOptions options;
  options.shareable = true;
  EXPECT_FALSE(exportStudy(study.file, path("shareable"), options));
}

TEST_F(ExportedStudy, ShareableTellsNothingOfPersonsAndPlaces) {
  auto file = store::StudyFile::create(path("a.tactus"), records_.study());
  ASSERT_TRUE(file);
  std::set<std::string> identifying = {"Tube study", "velvet", "otter",  "north",  "Falcon",  "4711",
                                       "consent",    "größer", "ward 7", "12.25",  "nitrile", "14 Fr",
                                       "tired",      "176000", "177000", "records"};
  for (const char* code : {"velvet-otter", "amber-otter"}) {
    const auto person = records_.person(code);
    ASSERT_TRUE(append(*file, person));
    auto session = records_.session(person.id);
    session.device = "Falcon 4711";
    ASSERT_TRUE(append(*file, session));
    auto profile = records_.profile(session.id);
    profile.category = "head of ward 7";
    profile.years_experience = 12.25;
    profile.weight = 12.25;
    ASSERT_TRUE(append(*file, profile));
    auto event = records_.event(session.id);
    event.detail = R"({"note":"tired"})";
    ASSERT_TRUE(append(*file, event));
    ASSERT_TRUE(append(*file, records_.stroke(session.id)));
    auto judgement = records_.judgement(session.id);
    judgement.catch_trial = false;
    judgement.scored = true;
    ASSERT_TRUE(append(*file, judgement));
    ASSERT_TRUE(append(*file, records_.answer(session.id)));
    ASSERT_TRUE(append(*file, records_.rating(session.id)));
    identifying.insert(toText(person.id));
    identifying.insert(toText(session.id));
  }
  ExportOptions options;
  options.shareable = true;
  const auto done = exportStudy(*file, path("out"), options);
  ASSERT_TRUE(done) << done.error().message();
  const auto files = bytesBelow(path("out"));
  EXPECT_EQ(files.size(), 9U);
  for (const auto& [name, bytes] : files) {
    for (const auto& text : identifying) {
      if (name.starts_with("codebook") && (text == "records" || text == "consent")) continue;  // words of the codebook
      EXPECT_EQ(bytes.find(text), std::string::npos) << name << " says " << text;
    }
  }
  EXPECT_EQ(files.at("participants.csv"),
            "participant,years_experience,category,handedness,weight,simulated,years_experience_band\n"
            "P1,,,left,,1,10-14\nP2,,,left,,1,10-14\n");
  EXPECT_NE(files.at("speeds.csv").find("P2,medium,2,0,"), std::string::npos);
  EXPECT_NE(files.at("judgements.csv").find("P1,ascending,3,0.30000000000000004,small"), std::string::npos);
}

TEST(Shareable, ShufflesWholeParticipants) {
  const auto study = tableStudy();
  std::set<std::string> firsts;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto out = shareable(study, seed);
    ASSERT_EQ(out.study.participants.size(), 4U);
    ASSERT_EQ(out.study.speeds.size(), study.speeds.size());
    ASSERT_EQ(out.study.answers.size(), study.answers.size());
    // Only S4 gave rules, so the rules' code tells who became whom.
    ASSERT_EQ(out.study.rules.size(), study.rules.size());
    const std::string s4 = out.study.rules.front().participant;
    firsts.insert(s4);
    std::vector<double> before;
    std::vector<double> after;
    for (const auto& sample : study.speeds) {
      if (sample.participant == "S4") before.push_back(sample.speed_mm_s);
    }
    for (const auto& sample : out.study.speeds) {
      if (sample.participant == s4) after.push_back(sample.speed_mm_s);
    }
    EXPECT_EQ(before, after);
  }
  EXPECT_EQ(firsts, (std::set<std::string>{"P1", "P2", "P3", "P4"}));
}

TEST(Shareable, BandsOfExperience) {
  EXPECT_EQ(experienceBand(std::nullopt), "");
  EXPECT_EQ(experienceBand(0), "<5");
  EXPECT_EQ(experienceBand(4.9), "<5");
  EXPECT_EQ(experienceBand(5), "5-9");
  EXPECT_EQ(experienceBand(9.9), "5-9");
  EXPECT_EQ(experienceBand(10), "10-14");
  EXPECT_EQ(experienceBand(14.9), "10-14");
  EXPECT_EQ(experienceBand(15), "15+");
}

}  // namespace
}  // namespace tactus::session
