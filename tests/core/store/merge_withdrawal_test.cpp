// Who withdrew stays out of every merge.
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

}  // namespace
}  // namespace tactus::store
