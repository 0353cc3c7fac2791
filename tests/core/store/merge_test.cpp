// What a merge brings in, refuses and lists.
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/merges.h"
#include "tests/core/store/naming_model.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

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
  PlainSql(path("b")).complaint("PRAGMA user_version = 2");
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

TEST_F(Merges, DifferentTablesThatAnOlderVersionGaveToOnePersonAreNotMixed) {
  // The id that version 1 gave to each person with this code: the first half of the SHA-256 of "person N01".
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

}  // namespace
}  // namespace tactus::store
