#include "core/store/merge.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/recoding.h"
#include "core/store/sessions.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/faulty_disk.h"
#include "tests/core/store/naming_model.h"
#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// All that a study says, whatever the order in which it came in: no row numbers, no log of merges, not when a model
/// was cleaned.
std::string contentOf(const std::string& path) {
  PlainSql sql(path);
  std::string all;
  for (const std::string table : {"person", "person_code", "session", "profile", "event", "stroke", "recording",
                                  "judgement", "answer", "rating", "rule", "model_version", "tombstone"}) {
    SQLite::Database database(path);
    SQLite::Statement columns(database, "SELECT name FROM pragma_table_info('" + table +
                                            "') WHERE name NOT IN ('place', 'crc32', 'cleaned_utc_ms')");
    std::string row = "''";
    while (columns.executeStep()) row += " || ' ' || quote(\"" + columns.getColumn(0).getString() + "\")";
    all += table + "\n" + sql.lines("SELECT " + row + " FROM " + table + " ORDER BY 1");
  }
  return all;
}

class Merges : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name + ".tactus"); }

  /// Closes nothing: the files must be closed. Returns the outcome, `into` holds the result.
  base::Result<Merge> tryMerge(const std::string& into, const std::string& from) {
    auto file = StudyFile::open(path(into), fast());
    EXPECT_TRUE(file) << file.error().message();
    auto merged = mergeStudy(*file, path(from), records_.id(), 1'790'000'000'000);
    EXPECT_TRUE(file->close());
    return merged;
  }
  Merge mergeInto(const std::string& into, const std::string& from) {
    const auto merged = tryMerge(into, from);
    EXPECT_TRUE(merged) << merged.error().message();
    return merged ? *merged : Merge{};
  }
  void copy(const std::string& from, const std::string& to) const {
    fs::copy_file(path(from), path(to), fs::copy_options::overwrite_existing);
  }

  /// Without waiting for the disk: these tests write hundreds of files.
  OpenOptions fast() const { return {Access::kReadWrite, disk_.name()}; }

  support::TempFolder folder_;
  FaultyDisk disk_{"merging"};
  SampleRecords records_{77};
};

TEST_F(Merges, BringInWhatIsNewAndNothingTwice) {
  SampleRecords north_records(1);
  SampleRecords south_records(2);
  auto north = makeStudy(path("north"), north_records);
  auto south = makeStudy(path("south"), south_records);
  const auto stroke = south_records.stroke(south.session.id);
  auto correction = south_records.answer(south.session.id, 8);
  const auto answer = south_records.answer(south.session.id);
  correction.entry.supersedes = answer.entry.id;
  const auto model = south_records.model("{}");
  ASSERT_TRUE(append(south.file, stroke) && append(south.file, answer) && append(south.file, correction) &&
              append(south.file, model));
  ASSERT_TRUE(north.file.close() && south.file.close());

  const auto first = mergeInto("north", "south");
  EXPECT_EQ(first.added,
            (std::vector<TableCount>{
                {"person", 1}, {"session", 1}, {"stroke", 1}, {"answer", 2}, {"recording", 1}, {"model_version", 1}}));
  // Both stations drew the same code for their person.
  ASSERT_EQ(first.conflicts.size(), 1U);
  const auto [low, high] = std::minmax(north.person.id, south.person.id);
  EXPECT_EQ(first.conflicts[0], "person: 2 persons have the code 'velvet-otter' (ids " + study::toText(low) + ", " +
                                    study::toText(high) + "); give one of them another: tactus study recode " +
                                    path("north") + " " + study::toText(high) + " velvet-otter-2");
  const auto content = contentOf(path("north"));
  const auto second = mergeInto("north", "south");
  EXPECT_TRUE(second.added.empty());
  EXPECT_EQ(contentOf(path("north")), content);
  EXPECT_EQ(PlainSql(path("north")).number("SELECT count(*) FROM import_log"), 1);

  const auto file = StudyFile::open(path("north"));
  EXPECT_EQ(*strokes(*file), std::vector{stroke});
  EXPECT_EQ(*answers(*file), std::vector{correction});
  EXPECT_EQ((*latestModelVersion(*file))->id, model.id);
}

TEST_F(Merges, AreRefusedWhereTheyMakeNoSense) {
  SampleRecords records(1);
  auto study = makeStudy(path("a"), records);
  const auto itself = mergeStudy(study.file, path("a"), records.id(), 1);
  ASSERT_FALSE(itself);
  EXPECT_NE(itself.error().message().find("open elsewhere"), std::string::npos);
  EXPECT_FALSE(mergeStudy(study.file, path("nothing"), records.id(), 1));
  SampleRecords others(2);
  ASSERT_TRUE(makeStudy(path("b"), others).file.close());
  PlainSql(path("b")).complaint("PRAGMA user_version = 3");
  const auto newer = mergeStudy(study.file, path("b"), records.id(), 1);
  ASSERT_FALSE(newer);
  EXPECT_EQ(newer.error().code, base::ErrorCode::kVersion);
}

TEST_F(Merges, AChangedRecordIsListedAndNotTakenOver) {
  SampleRecords records(1);
  auto study = makeStudy(path("a"), records);
  ASSERT_TRUE(append(study.file, records.answer(study.session.id)) && study.file.close());
  copy("a", "b");
  ASSERT_EQ(PlainSql(path("b")).complaintWithoutGuards("UPDATE answer SET value = 'small'"), "");
  const auto content = contentOf(path("a"));
  const auto merged = mergeInto("a", "b");
  ASSERT_EQ(merged.conflicts.size(), 1U);
  EXPECT_NE(merged.conflicts[0].find("differs in the other file, this file's was kept"), std::string::npos);
  EXPECT_EQ(contentOf(path("a")), content);
}

TEST_F(Merges, WhatBothCorrectedIsListedAndTheLaterCounts) {
  SampleRecords records(1);
  auto study = makeStudy(path("a"), records);
  const auto answer = records.answer(study.session.id);
  ASSERT_TRUE(append(study.file, answer) && study.file.close());
  copy("a", "b");
  const auto correct = [&](const std::string& name, const std::string& value, std::int64_t utc_ms) {
    auto file = StudyFile::open(path(name));
    auto correction = records_.answer(study.session.id);
    correction.value = value;
    correction.entry.when.utc_ms = utc_ms;
    correction.entry.supersedes = answer.entry.id;
    ASSERT_TRUE(append(*file, correction) && file->close());
  };
  correct("a", "small", 1'800'000'000'000);
  correct("b", "medium", 1'700'000'000'000);
  const auto merged = mergeInto("a", "b");
  ASSERT_EQ(merged.conflicts.size(), 2U);  // the double correction, and the session that went on in two copies
  const auto file = StudyFile::open(path("a"));
  ASSERT_EQ(answers(*file)->size(), 1U);
  EXPECT_EQ(answers(*file)->front().value, "small");
  EXPECT_EQ(answers(*file, {.history = true})->size(), 3U);
}

TEST_F(Merges, APersonWhoWithdrewStaysOutWithEveryNameAndRule) {
  SampleRecords shared(1);
  auto study = makeStudy(path("a"), shared);
  const auto other = shared.person("calm-fox");
  const auto session = shared.session(other.id);
  ASSERT_TRUE(append(study.file, other) && append(study.file, session) && study.file.close());
  copy("a", "b");
  const auto version = shared.model(namingModel({"velvet-otter", "calm-fox"}));
  {
    auto b = StudyFile::open(path("b"), fast());
    auto felt = shared.event(session.id);
    felt.detail = R"({"model":"velvet-otter alone"})";
    ASSERT_TRUE(b && append(*b, version) && append(*b, felt) && b->close());
    auto a = StudyFile::open(path("a"), fast());
    ASSERT_TRUE(a && withdraw(*a, study.person.id, 1'780'000'000'000) && a->close());
  }
  copy("b", "b_before");
  const auto merged = mergeInto("a", "b");
  ASSERT_FALSE(merged.conflicts.empty());
  EXPECT_EQ(
      merged.conflicts[0],
      "person 'velvet-otter': withdrew on 2026-05-28T20:26:40Z, so nothing of theirs comes in; withdraw them there "
      "too: tactus study withdraw " +
          path("b") + " " + study::toText(study.person.id) + " --yes");
  const auto content = contentOf(path("a"));
  EXPECT_EQ(content.find("velvet-otter"), std::string::npos);
  EXPECT_EQ(content.find(ruleWeightOf("velvet-otter")), std::string::npos);
  EXPECT_NE(content.find("(withdrawn) alone"), std::string::npos);
  EXPECT_NE(content.find(ruleWeightOf("calm-fox")), std::string::npos);
  // Again, and the other way round: the same.
  EXPECT_TRUE(mergeInto("a", "b").added.empty());
  EXPECT_EQ(contentOf(path("a")), content);
  const auto removed = mergeInto("b", "a");
  EXPECT_EQ(removed.withdrawn, 1);
  EXPECT_EQ(contentOf(path("b")), content);
  for (const char* name : {"a", "b"}) {
    const auto file = StudyFile::open(path(name), fast());
    EXPECT_TRUE(unfinishedErasures(*file)->empty());
    EXPECT_TRUE(modelVersion(*file, version.id));
  }
}

TEST_F(Merges, ACodeOfAnotherWhoWithdrewIsRefusedUntilItIsAnother) {
  SampleRecords north_records(1);
  SampleRecords south_records(2);
  auto north = makeStudy(path("north"), north_records);
  auto south = makeStudy(path("south"), south_records);
  ASSERT_TRUE(append(south.file, south_records.model(namingModel({"velvet-otter"}))));
  ASSERT_TRUE(withdraw(north.file, north.person.id, 1'780'000'000'000));
  ASSERT_TRUE(north.file.close() && south.file.close());
  for (const auto& [into, from] : {std::pair("north", "south"), std::pair("south", "north")}) {
    const auto content = contentOf(path(into));
    const auto refused = tryMerge(into, from);
    ASSERT_FALSE(refused);
    EXPECT_EQ(
        refused.error().message(),
        path("south") + ": found the code 'velvet-otter' of a participant who withdrew on 2026-05-28T20:26:40Z from " +
            path("north") + ", wanted for another person another code (tactus study recode " + path("south") + " " +
            study::toText(south.person.id) + " NEWCODE), for the same person the withdrawal here too (tactus " +
            "study withdraw " + path("south") + " " + study::toText(south.person.id) + " --yes)");
    EXPECT_EQ(contentOf(path(into)), content);
  }
  {
    auto file = StudyFile::open(path("south"), fast());
    ASSERT_TRUE(file && recode(*file, south.person.id, "misty-lake", records_.id(), 9) && file->close());
  }
  copy("north", "north_south");
  mergeInto("north_south", "south");
  copy("south", "south_north");
  mergeInto("south_north", "north");
  EXPECT_EQ(contentOf(path("north_south")), contentOf(path("south_north")));
  // The earlier code is the other person's too, so their model stays.
  EXPECT_NE(contentOf(path("south_north")).find(ruleWeightOf("velvet-otter")), std::string::npos);
}

TEST_F(Merges, DifferentTablesThatAnOlderVersionGaveToOnePersonAreNotMixed) {
  // The id that version 1 gave to everybody with this code: the first half of the SHA-256 of "person N01".
  const auto id = study::parseRecordId("b9ccdac316bc5a16a7450b7e871ab6fb");
  SampleRecords records(3);
  const auto import = [&](const std::string& name) {
    auto study = makeStudy(path(name), records);
    auto session = records.session(*id);
    session.kind = study::SessionKind::kImport;
    ASSERT_TRUE(append(study.file, study::Person{*id, "N01", false}) && append(study.file, session));
    ASSERT_TRUE(append(study.file, records.answer(session.id)) && study.file.close());
  };
  import("north");
  import("south");
  const auto content = contentOf(path("north"));
  const auto refused = tryMerge("north", "south");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(),
            path("south") +
                ": found other tables for 'N01' than this study has; an older version imported both and cannot "
                "tell two persons of one code apart, wanted a study made by importing the tables again, into "
                "a new file");
  EXPECT_EQ(contentOf(path("north")), content);
  // A copy that went on shares what was imported.
  copy("north", "copied");
  {
    auto file = StudyFile::open(path("copied"), fast());
    auto session = records.session(*id);
    session.kind = study::SessionKind::kImport;
    ASSERT_TRUE(file && append(*file, session) && file->close());
  }
  EXPECT_TRUE(tryMerge("north", "copied"));
}

TEST_F(Merges, TwoWithdrawalsOfOnePersonBecomeOne) {
  SampleRecords shared(1);
  auto study = makeStudy(path("a"), shared);
  ASSERT_TRUE(append(study.file, shared.model(namingModel({"velvet-otter", "calm-fox"}))) && study.file.close());
  copy("a", "b");
  for (const auto& [name, utc_ms] : {std::pair("a", 70), std::pair("b", 50)}) {
    auto file = StudyFile::open(path(name), fast());
    ASSERT_TRUE(file);
    ASSERT_TRUE(utc_ms != 50 || recode(*file, study.person.id, "misty-lake", records_.id(), 9));
    ASSERT_TRUE(withdraw(*file, study.person.id, utc_ms) && file->close());
  }
  copy("a", "ab");
  EXPECT_TRUE(mergeInto("ab", "b").conflicts.empty());
  copy("b", "ba");
  EXPECT_TRUE(mergeInto("ba", "a").conflicts.empty());
  EXPECT_EQ(contentOf(path("ab")), contentOf(path("ba")));
  const auto file = StudyFile::open(path("ab"), fast());
  EXPECT_EQ(*tombstones(*file), (std::vector{Tombstone{study.person.id, 50}}));
  for (const char* code : {"velvet-otter", "misty-lake"}) EXPECT_TRUE(*withdrawnWithCode(*file, code)) << code;
  EXPECT_TRUE(unfinishedErasures(*file)->empty());
}

/// Chains of corrections on both sides of a merge, against a model that knows only what was written.
class MergedChains : public Merges, public testing::WithParamInterface<int> {
 protected:
  /// Lets a station correct what counts for it, `steps` times, with a clock that may be anywhere.
  void correct(const std::string& name, const std::string& from, base::Random& random, int steps) {
    copy(from, name);
    SampleRecords records(random.next());
    auto file = StudyFile::open(path(name), fast());
    ASSERT_TRUE(file);
    for (int step = 0; step < steps; ++step) {
      const auto there = *answers(*file);
      const auto& before = there[static_cast<std::size_t>(random.below(static_cast<int>(there.size())))];
      auto answer = records.answer(before.entry.session, before.item);
      answer.entry.supersedes = before.entry.id;
      answer.entry.when.utc_ms = 1'700'000'000'000 + random.below(20);
      ASSERT_TRUE(append(*file, answer));
    }
    ASSERT_TRUE(file->close());
  }
  /// Of each first answer the last correction that counts: of those without a correction the latest, then the highest
  /// id.
  static std::set<study::RecordId> expected(const std::vector<study::AnswerRecord>& history) {
    std::map<study::RecordId, const study::AnswerRecord*> by_id;
    std::set<study::RecordId> corrected;
    for (const auto& answer : history) {
      by_id[answer.entry.id] = &answer;
      if (answer.entry.supersedes) corrected.insert(*answer.entry.supersedes);
    }
    std::map<study::RecordId, const study::AnswerRecord*> latest;
    for (const auto& answer : history) {
      if (corrected.contains(answer.entry.id)) continue;
      const study::AnswerRecord* root = &answer;
      while (root->entry.supersedes) root = by_id.at(*root->entry.supersedes);
      const auto*& best = latest[root->entry.id];
      if (best == nullptr ||
          std::pair(best->entry.when.utc_ms, best->entry.id) < std::pair(answer.entry.when.utc_ms, answer.entry.id)) {
        best = &answer;
      }
    }
    std::set<study::RecordId> ids;
    for (const auto& [root, answer] : latest) ids.insert(answer->entry.id);
    return ids;
  }
  std::set<study::RecordId> current(const std::string& name) const {
    const auto file = StudyFile::open(path(name), fast());
    EXPECT_TRUE(file);
    std::set<study::RecordId> ids;
    const auto there = *answers(*file);
    for (const auto& answer : there) ids.insert(answer.entry.id);
    EXPECT_EQ(ids, expected(*answers(*file, {.history = true})));
    return ids;
  }
};

TEST_P(MergedChains, OneAnswerOfEachCountsInWhateverOrder) {
  SampleRecords shared(1);
  auto study = makeStudy(path("origin"), shared);
  for (int item = 1; item <= 3; ++item) ASSERT_TRUE(append(study.file, shared.answer(study.session.id, item)));
  ASSERT_TRUE(study.file.close());
  base::Random random(static_cast<std::uint64_t>(GetParam()));
  correct("a", "origin", random, 4);
  correct("b", "origin", random, 6);
  correct("c", "a", random, 3);
  copy("a", "abc");
  mergeInto("abc", "b");
  mergeInto("abc", "c");
  copy("c", "cba");
  mergeInto("cba", "b");
  mergeInto("cba", "a");
  EXPECT_EQ(current("abc").size(), 3U);
  EXPECT_EQ(current("cba"), current("abc"));
  // What was merged can be corrected further.
  correct("abcd", "abc", random, 4);
  EXPECT_EQ(current("abcd").size(), 3U);
  mergeInto("abcd", "cba");
  EXPECT_EQ(current("abcd").size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, MergedChains, testing::Range(1, 11));

TEST_F(Merges, ACorrectionOfACorrectionOnOneSideLeavesOneThatCounts) {
  SampleRecords records(1);
  auto study = makeStudy(path("a"), records);
  const auto root = records.answer(study.session.id);
  ASSERT_TRUE(append(study.file, root) && study.file.close());
  copy("a", "b");
  const auto correct = [&](const std::string& name, const study::RecordId& before, std::int64_t utc_ms) {
    auto file = StudyFile::open(path(name), fast());
    auto correction = records_.answer(study.session.id);
    correction.entry.when.utc_ms = utc_ms;
    correction.entry.supersedes = before;
    EXPECT_TRUE(append(*file, correction) && file->close());
    return correction;
  };
  const auto first = correct("a", root.entry.id, 1);
  const auto second = correct("a", first.entry.id, 2);
  const auto other = correct("b", root.entry.id, 3);
  mergeInto("a", "b");
  const auto file = StudyFile::open(path("a"));
  EXPECT_EQ(*answers(*file), std::vector{other});
}

/// Three stations that began with copies of one study, went on by themselves, and exchange their files.
class MergeProperties : public Merges, public testing::WithParamInterface<int> {
 protected:
  void SetUp() override {
    SampleRecords shared(1);
    auto study = makeStudy(path("origin"), shared);
    for (const char* code : {"calm-fox", "misty-lake", "quiet-drum"}) {
      const auto person = shared.person(code);
      const auto session = shared.session(person.id);
      ASSERT_TRUE(append(study.file, person) && append(study.file, session));
      ASSERT_TRUE(append(study.file, shared.answer(session.id)) && append(study.file, shared.stroke(session.id)));
    }
    ASSERT_TRUE(append(study.file, shared.model("first")) && study.file.close());
    base::Random random(static_cast<std::uint64_t>(GetParam()));
    for (const char* name : {"a", "b", "c"}) goOn(name, random);
  }

  /// A model with the experts that some of the persons are.
  static std::string modelOf(const StudyFile& file, base::Random& random) {
    std::vector<std::string> codes = {"printed-expert"};
    const auto there = *persons(file);
    for (const auto& person : there) {
      const bool is_twice = std::find(codes.begin(), codes.end(), person.code) != codes.end();
      if (random.below(2) == 0 && !is_twice) codes.push_back(person.code);
    }
    return namingModel(codes);
  }

  void goOn(const std::string& name, base::Random& random) {
    copy("origin", name);
    SampleRecords records(random.next());
    auto opened = StudyFile::open(path(name), fast());
    ASSERT_TRUE(opened);
    StudyFile& file = *opened;
    for (int step = 0; step < 10; ++step) {
      const auto there = *sessions(file);
      const auto session = there.empty() ? study::RecordId() : there[random.below(static_cast<int>(there.size()))].id;
      const int choice = random.below(there.empty() ? 1 : 6);
      if (choice == 0) {
        const auto person = records.person(random.uniform() < 0.3 ? "the-same" : study::toText(records.id()));
        const bool is_new = append(file, person).has_value();
        ASSERT_TRUE(!is_new || append(file, records.session(person.id)));
      } else if (choice == 1) {
        ASSERT_TRUE(append(file, records.stroke(session)));
      } else if (choice == 2) {
        const auto before = *answers(file, {.session = session});
        auto answer = records.answer(session);
        if (!before.empty()) answer.entry.supersedes = before.back().entry.id;
        EXPECT_TRUE(append(file, answer));
      } else if (choice == 3) {
        ASSERT_TRUE(append(file, records.judgement(session)));
      } else if (choice == 4) {
        auto model = records.model(modelOf(file, random));
        model.parent = (*latestModelVersion(file))->id;
        ASSERT_TRUE(append(file, model));
      } else {
        const auto persons_there = *persons(file);
        const auto person = persons_there[random.below(static_cast<int>(persons_there.size()))].id;
        if (random.uniform() < 0.5) {
          ASSERT_TRUE(withdraw(file, person, 5 + random.below(3)));
        } else {
          ASSERT_TRUE(recode(file, person,
                             "code-" + std::string(1, 'a' + static_cast<char>(random.below(26))) +
                                 study::toText(records.id()).substr(0, 6) + "x",
                             records.id(), random.below(9)));
        }
      }
    }
    ASSERT_TRUE(file.close());
  }
};

TEST_P(MergeProperties, OrderAndRepetitionDoNotMatter) {
  // A code of somebody else who withdrew refuses a merge, and then in every order.
  int refused = 0;
  const auto merge = [&](const char* into, const char* from) {
    const auto merged = tryMerge(into, from);
    if (merged) return true;
    EXPECT_EQ(merged.error().code, base::ErrorCode::kData) << merged.error().message();
    ++refused;
    return false;
  };
  const auto inOrder = [&](const char* into, const char* first, const char* second) {
    return merge(into, first) && merge(into, second);
  };
  copy("a", "ab_c");
  copy("b", "bc");
  copy("a", "a_bc");
  copy("c", "cba");
  const bool first = inOrder("ab_c", "b", "c");
  const bool second = merge("bc", "c") && merge("a_bc", "bc");
  const bool third = inOrder("cba", "b", "a");
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, third);
  if (!first) return;
  const auto content = contentOf(path("ab_c"));
  EXPECT_EQ(contentOf(path("a_bc")), content);
  EXPECT_EQ(contentOf(path("cba")), content);
  for (const char* again : {"a", "b", "c", "bc", "cba"}) {
    const auto repeated = mergeInto("ab_c", again);
    EXPECT_TRUE(repeated.added.empty() || (repeated.added.size() == 1 && repeated.added[0].table == "import_log"));
  }
  EXPECT_EQ(contentOf(path("ab_c")), content);
  // Nobody who withdrew is an expert of any model.
  auto file = StudyFile::open(path("ab_c"), fast());
  EXPECT_EQ(erase(*file)->models, 0);
}

TEST_P(MergeProperties, WhoWithdrewNeverComesBack) {
  if (!tryMerge("a", "b") || !tryMerge("a", "c")) return;  // a code of somebody else who withdrew
  mergeInto("a", "origin");
  PlainSql sql(path("a"));
  EXPECT_EQ(sql.number("SELECT count(*) FROM person WHERE id IN (SELECT person_id FROM tombstone)"), 0);
  EXPECT_EQ(sql.number("SELECT count(*) FROM session WHERE person_id IN (SELECT person_id FROM tombstone)"), 0);
  EXPECT_EQ(sql.lines("PRAGMA foreign_key_check"), "");
  EXPECT_EQ(sql.text("PRAGMA integrity_check"), "ok");
  // Each withdrawal of any station counts here.
  for (const char* name : {"b", "c"}) {
    EXPECT_EQ(sql.complaint("ATTACH '" + path(name) + "' AS other"), "");
    EXPECT_EQ(
        sql.number("SELECT count(*) FROM other.tombstone WHERE person_id NOT IN (SELECT person_id FROM tombstone)"), 0);
    sql.complaint("DETACH other");
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, MergeProperties, testing::Range(1, 9));

}  // namespace
}  // namespace tactus::store
