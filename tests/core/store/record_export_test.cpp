
#include <SQLiteCpp/SQLiteCpp.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <sstream>

#include "core/store/copies.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/record_import.h"
#include "core/store/record_tables.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// The files below a folder with their bytes.
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

void edit(const std::string& path, const std::string& from, const std::string& to) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  std::string text = bytes.str();
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos) << path << " has no " << from;
  std::ofstream(path, std::ios::binary) << text.replace(at, from.size(), to);
}

/// Every stored value of every table of a closed study, with its type.
std::string allValues(const std::string& path) {
  PlainSql sql(path);
  SQLite::Database database(path);
  std::string all;
  SQLite::Statement tables(database,
                           "SELECT name FROM sqlite_schema WHERE type = 'table' AND name <> 'opening' ORDER BY name");
  while (tables.executeStep()) {
    const std::string table = tables.getColumn(0).getString();
    std::string values;
    SQLite::Statement columns(database, "SELECT name FROM pragma_table_info('" + table + "')");
    while (columns.executeStep()) values += " || quote(" + columns.getColumn(0).getString() + ") || ','";
    all += table + '\n' + sql.lines("SELECT ''" + values + " FROM " + table + " ORDER BY 1");
  }
  return all;
}

/// A study of several persons with records of all kinds, corrections and odd values drawn with `seed`; closed.
std::string makeRandomStudy(const support::TempFolder& folder, std::uint64_t seed, const std::string& name) {
  std::mt19937_64 random(seed);
  const auto below = [&random](std::uint64_t count) { return random() % count; };
  const std::vector<std::string> odd = {"", "a,b", "\"quoted\"", "two\nlines\r\nof text", "  spaces  ", "größer", "#"};
  SampleRecords records(seed);
  const std::string path = folder.file(name);
  auto study = makeStudy(path, records);
  StudyFile& file = study.file;
  std::vector<study::SessionRecord> sessions = {study.session};
  for (int i = 0; i < 2; ++i) {
    const auto person = records.person("code-" + std::to_string(i) + odd[below(odd.size())]);
    EXPECT_TRUE(append(file, person));
    for (std::uint64_t n = 0; n <= below(2); ++n) {
      auto session = records.session(person.id);
      session.station = odd[below(odd.size())];
      if (below(2) == 0) session.device_friction_n.reset();
      EXPECT_TRUE(append(file, session));
      sessions.push_back(session);
    }
  }
  for (const auto& session : sessions) {
    auto profile = records.profile(session.id);
    if (below(2) == 0) profile.years_experience.reset();
    EXPECT_TRUE(append(file, profile));
    auto event = records.event(session.id);
    event.entry.reason = odd[below(odd.size())];
    EXPECT_TRUE(append(file, event));
    auto stroke = records.stroke(session.id, 2 + below(30));
    stroke.recording.channels[1].values[0] = -0.0;
    stroke.recording.channels[0].values[1] = 5e-324;
    if (below(2) == 0) stroke.recording.channels.push_back({"depth", "mm", stroke.recording.channels[0].values});
    if (below(2) == 0)
      stroke.recording.channels.push_back({odd[below(odd.size())], "mm/s [2]", stroke.recording.channels[1].values});
    EXPECT_TRUE(append(file, stroke));
    study::StrokeRecord nothing = records.stroke(session.id, 0);
    nothing.first = 0;
    nothing.recording.channels.clear();
    EXPECT_TRUE(append(file, nothing));
    for (std::uint64_t i = 0; i < 1 + below(4); ++i) {
      auto judgement = records.judgement(session.id);
      judgement.commanded_n = static_cast<double>(random()) / 1e18;
      if (below(2) == 0) judgement.felt_n.reset();
      EXPECT_TRUE(append(file, judgement));
    }
    study::AnswerRecord answer = records.answer(session.id);
    EXPECT_TRUE(append(file, answer));
    for (std::uint64_t i = 0; i < below(3); ++i) {  // a chain of corrections
      auto correction = records.answer(session.id);
      correction.entry.supersedes = answer.entry.id;
      correction.entry.reason = odd[below(odd.size())];
      EXPECT_TRUE(append(file, correction));
      answer = correction;
    }
    EXPECT_TRUE(append(file, records.rating(session.id)));
    EXPECT_TRUE(append(file, records.rule(session.id)));
  }
  auto model = records.model("{\"name\": \"größer\"}\n");
  EXPECT_TRUE(append(file, model));
  auto child = records.model("no JSON\r\n\"at all\"");
  child.parent = model.id;
  EXPECT_TRUE(append(file, child));
  const auto leaving = records.person("leaving");
  EXPECT_TRUE(append(file, leaving));
  EXPECT_TRUE(withdraw(file, leaving.id, 1'790'000'000'000));
  EXPECT_TRUE(file.close());
  return path;
}

void exportTo(const std::string& study, const std::string& folder, ByteOrderMark mark = ByteOrderMark::kNone) {
  const auto file = StudyFile::open(study, {Access::kReadOnly});
  ASSERT_TRUE(file) << file.error().message();
  const auto written = writeRecords(*file, folder, mark);
  ASSERT_TRUE(written) << written.error().message();
}

TEST(RecordTables, DescribeEveryColumnOfTheSchema) {
  const support::TempFolder folder;
  SampleRecords records;
  ASSERT_TRUE(makeStudy(folder.file("a.tactus"), records).file.close());
  PlainSql sql(folder.file("a.tactus"));
  std::string described;
  for (const auto& table : recordTables()) {
    std::string columns;
    for (const auto& column : table.columns) {
      if (column.kind != ColumnKind::kChannels && column.name != "schema_version")
        columns += std::string(column.name) + "\n";
    }
    EXPECT_EQ(columns, sql.lines("SELECT name FROM pragma_table_info('" + std::string(table.name) +
                                 "') WHERE name NOT IN ('one', 'crc32')"));
  }
  EXPECT_EQ(static_cast<long long>(recordTables().size()),
            sql.number("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite_%'"
                       " AND name NOT IN ('opening', 'erasure', 'research_key')"));
}

TEST(RecordExport, ComesBackAsTheSameStudyByteForByte) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const support::TempFolder folder;
    const std::string study = makeRandomStudy(folder, seed, "a.tactus");
    const auto mark = seed % 2 == 0 ? ByteOrderMark::kWrite : ByteOrderMark::kNone;
    exportTo(study, folder.file("first"), mark);
    const auto restored = restoreRecords(folder.file("first"), folder.file("b.tactus"));
    ASSERT_TRUE(restored) << restored.error().message();
    EXPECT_EQ(allValues(study), allValues(folder.file("b.tactus")));
    exportTo(folder.file("b.tactus"), folder.file("second"), mark);
    EXPECT_EQ(bytesBelow(folder.file("first")), bytesBelow(folder.file("second")));
    const auto open = StudyFile::open(folder.file("b.tactus"));
    ASSERT_TRUE(open);
    EXPECT_EQ(checkStudy(*open).value(), std::vector<std::string>());
  }
}

TEST(RecordExport, MarksEveryTableForSpreadsheets) {
  const support::TempFolder folder;
  exportTo(makeRandomStudy(folder, 7, "a.tactus"), folder.file("out"), ByteOrderMark::kWrite);
  int tables = 0;
  for (const auto& [name, bytes] : bytesBelow(folder.file("out"))) {
    if (!name.ends_with(".csv")) continue;
    ++tables;
    EXPECT_TRUE(bytes.starts_with("\xEF\xBB\xBF")) << name;
  }
  EXPECT_GT(tables, 14);
}

TEST(RecordImport, AddsWhatIsNewOnce) {
  const support::TempFolder folder;
  exportTo(makeRandomStudy(folder, 8, "a.tactus"), folder.file("out"));
  SampleRecords records(99);
  auto ours = makeStudy(folder.file("ours.tactus"), records);
  const auto first = importRecords(ours.file, folder.file("out"), records.id(), 1);
  ASSERT_TRUE(first) << first.error().message();
  EXPECT_FALSE(first->added.empty());
  const auto before = studyInfo(ours.file)->counts;
  const auto again = importRecords(ours.file, folder.file("out"), records.id(), 2);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_TRUE(again->added.empty());
  EXPECT_EQ(studyInfo(ours.file)->counts, before);
  // The two stations' persons both have the code of makeStudy: listed, both kept.
  ASSERT_EQ(again->conflicts.size(), 1U);
  EXPECT_NE(again->conflicts[0].find("velvet-otter"), std::string::npos);
  ASSERT_TRUE(ours.file.close());
  EXPECT_EQ(PlainSql(folder.file("ours.tactus")).text("SELECT source FROM import_log WHERE utc_ms = 1"), "out");
}

TEST(RecordImport, NeverBringsBackWhoWithdrew) {
  const support::TempFolder folder;
  SampleRecords records;
  auto study = makeStudy(folder.file("a.tactus"), records);
  ASSERT_TRUE(append(study.file, records.stroke(study.session.id)));
  ASSERT_TRUE(backUp(study.file, folder.file("copy.tactus")));
  ASSERT_TRUE(writeRecords(study.file, folder.file("with")));
  ASSERT_TRUE(withdraw(study.file, study.person.id, 5));
  ASSERT_TRUE(writeRecords(study.file, folder.file("without")));

  // Their records in the tables, the tombstone here.
  ASSERT_TRUE(importRecords(study.file, folder.file("with"), records.id(), 6));
  EXPECT_TRUE(persons(study.file)->empty());
  EXPECT_TRUE(strokes(study.file)->empty());
  // The tombstone in the tables, their records here.
  auto copy = StudyFile::open(folder.file("copy.tactus"));
  ASSERT_TRUE(copy);
  ASSERT_EQ(persons(*copy)->size(), 1U);
  const auto merged = importRecords(*copy, folder.file("without"), records.id(), 7);
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->withdrawn, 1);
  EXPECT_TRUE(persons(*copy)->empty());
}

TEST(RecordImport, RefusesTablesOfAParticipantWhoWithdrew) {
  const support::TempFolder folder;
  SampleRecords records;
  auto study = makeStudy(folder.file("a.tactus"), records);
  ASSERT_TRUE(writeRecords(study.file, folder.file("out")));
  std::ofstream(folder.file("out/tombstones.csv"), std::ios::app) << toText(study.person.id) << ",5,,\n";
  const auto restored = restoreRecords(folder.file("out"), folder.file("b.tactus"));
  ASSERT_FALSE(restored);
  EXPECT_TRUE(restored.error().message().starts_with(folder.file("out/persons.csv") + ": line 2: "))
      << restored.error().message();
  EXPECT_NE(restored.error().message().find("withdrew"), std::string::npos);
}

class BrokenTables : public testing::Test {
 protected:
  BrokenTables() {
    SampleRecords records;
    auto study = makeStudy(folder_.file("a.tactus"), records);
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(append(study.file, records.rating(study.session.id)));
    auto correction = records.rating(study.session.id);
    correction.entry.supersedes = ratings(study.file)->front().entry.id;
    EXPECT_TRUE(append(study.file, correction));
    EXPECT_TRUE(append(study.file, records.stroke(study.session.id)));
    EXPECT_TRUE(append(study.file, records.model("{}")));
    EXPECT_TRUE(writeRecords(study.file, folder_.file("out")));
    session_ = toText(study.session.id);
  }

  std::string out(const std::string& name) const { return folder_.file("out/" + name); }
  std::string complaint() const {
    const auto restored = restoreRecords(folder_.file("out"), folder_.file("b.tactus"));
    EXPECT_FALSE(fs::exists(folder_.file("b.tactus")));
    return restored ? "" : restored.error().message();
  }
  void expectRefused(const std::string& beginning) const {
    const std::string found = complaint();
    EXPECT_TRUE(found.starts_with(beginning)) << found << "\n, not " << beginning;
  }
  fs::path only(const std::string& below) const { return *fs::directory_iterator(out(below)); }

  support::TempFolder folder_;
  std::string session_;
};

TEST_F(BrokenTables, ALinkToTheOutsideIsRefused) {
  const fs::path model = only("models");
  fs::rename(model, folder_.file("elsewhere.json"));
  fs::create_symlink(folder_.file("elsewhere.json"), model);
  expectRefused(model.string() + ": found a link to '" + folder_.file("elsewhere.json").substr(0, 20));
  EXPECT_NE(complaint().find("outside of the folder, wanted a file in the folder itself"), std::string::npos);
  fs::remove(model);
  fs::rename(folder_.file("elsewhere.json"), model);
  // A folder that is itself reached by a link is fine.
  fs::rename(folder_.file("out"), folder_.file("real"));
  fs::create_directory_symlink(folder_.file("real"), folder_.file("out"));
  EXPECT_TRUE(restoreRecords(folder_.file("out"), folder_.file("b.tactus")));
}

TEST_F(BrokenTables, OutOfRange) {
  edit(out("ratings.csv"), ",speed,3,6", ",speed,8,6");
  expectRefused(out("ratings.csv") + ": line 2, column 'effort': found '8'");
}

TEST_F(BrokenTables, NotANumber) {
  edit(out("sessions.csv"), ",0.26,", ",much,");
  expectRefused(out("sessions.csv") + ": line 2, column 'device_friction_n': found 'much', wanted a finite number");
}

TEST_F(BrokenTables, CodeThatASpreadsheetWouldRun) {
  edit(out("persons.csv"), ",velvet-otter,", ",=velvet-otter,");
  expectRefused(out("persons.csv") +
                ": line 2, column 'code': found '=velvet-otter', wanted a name that does not begin");
}

TEST_F(BrokenTables, TermThatASpreadsheetWouldRun) {
  edit(out("strokes.csv"), ",medium,", ",@medium,");
  expectRefused(out("strokes.csv") + ": line 2, column 'level': found '@medium', wanted a name that does not begin");
}

TEST_F(BrokenTables, UnknownSession) {
  edit(out("ratings.csv"), session_, std::string(32, 'a'));
  expectRefused(out("ratings.csv") + ": line 2, column 'session_id': found '" + std::string(32, 'a') +
                "', wanted an id of sessions.csv");
}

TEST_F(BrokenTables, CorrectionOfNothing) {
  const auto id =
      PlainSql(folder_.file("a.tactus")).text("SELECT lower(hex(supersedes)) FROM rating WHERE supersedes IS NOT NULL");
  edit(out("ratings.csv"), ",researcher," + id, ",researcher," + std::string(32, 'b'));
  expectRefused(out("ratings.csv") + ": line 4, column 'supersedes': found '" + std::string(32, 'b') + "'");
}

TEST_F(BrokenTables, CorrectionBeforeWhatItCorrects) {
  std::ifstream in(out("ratings.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::ofstream(out("ratings.csv")) << lines[0] << '\n' << lines[3] << '\n' << lines[2] << '\n' << lines[1] << '\n';
  const auto restored = restoreRecords(folder_.file("out"), folder_.file("b.tactus"));
  ASSERT_TRUE(restored) << restored.error().message();
  EXPECT_EQ(allValues(folder_.file("a.tactus")), allValues(folder_.file("b.tactus")));
}

TEST_F(BrokenTables, TwiceTheSameId) {
  std::ofstream(out("persons.csv"), std::ios::app)
      << PlainSql(folder_.file("a.tactus")).text("SELECT lower(hex(id)) FROM person") << ",other-code,1\n";
  expectRefused(out("persons.csv") + ": line 3, column 'id': found '");
}

TEST_F(BrokenTables, LostSample) {
  const auto samples = only("recordings");
  std::ifstream in(samples);
  std::string text;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("7,")) text += line + '\n';
  }
  in.close();
  std::ofstream(samples) << text;
  expectRefused(samples.string() + ": line 9, column 'sample': found '8', wanted sample 7");
}

TEST_F(BrokenTables, OtherModel) {
  std::ofstream(only("models")) << "{\"other\": 1}";
  expectRefused(out("model_versions.csv") + ": line 2, column 'sha256'");
}

TEST_F(BrokenTables, FileOfSomebodyElse) {
  edit(out("model_versions.csv"), ",models/", ",../models/");
  expectRefused(out("model_versions.csv") + ": line 2, column 'text': found '../models/");
}

TEST_F(BrokenTables, MissingTable) {
  fs::remove(out("events.csv"));
  expectRefused(out("events.csv") + ": found No such file");
}

TEST_F(BrokenTables, UnknownColumn) {
  edit(out("persons.csv"), "id,code", "id,real_name,code");
  edit(out("persons.csv"), ",velvet-otter", ",Jane,velvet-otter");
  expectRefused(out("persons.csv") + ": header: found a column 'real_name'");
}

TEST_F(BrokenTables, NewerSchema) {
  edit(out("study.csv"), "0,1\n", "0,99\n");
  expectRefused(out("study.csv") + ": line 2, column 'schema_version': found '99'");
}

TEST_F(BrokenTables, TakenName) {
  std::ofstream(folder_.file("c.tactus")) << "mine";
  EXPECT_FALSE(restoreRecords(folder_.file("out"), folder_.file("c.tactus")));
  EXPECT_EQ(bytesBelow(folder_.file("")).at("c.tactus"), "mine");
}

}  // namespace
}  // namespace tactus::store
