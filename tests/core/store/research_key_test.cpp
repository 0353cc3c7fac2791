#include "core/store/research_key.h"

#include <gtest/gtest.h>

#include "core/store/record_import.h"
#include "core/store/record_tables.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

// `mkpasswd -m yescrypt -S '$y$j9T$Zm9vYmFyYmF6cXV4' 'correct horse'` gives this hash.
constexpr const char* kKnown = "$y$j9T$Zm9vYmFyYmF6cXV4$mCfFVdvAdSFZUWueyyR1ZFnKEWnB0j.Zwqo49CU0.b1";

TEST(Passphrase, HasTheHashThatOtherProgramsCompute) {
  EXPECT_TRUE(*hasHash("correct horse", kKnown));
  EXPECT_FALSE(*hasHash("correct Horse", kKnown));
  EXPECT_FALSE(hasHash("correct horse", "$unknown$method"));
}

TEST(Passphrase, HasAnotherSaltEachTime) {
  const auto first = hashOfPassphrase("geheim ist geheim");
  const auto second = hashOfPassphrase("geheim ist geheim");
  ASSERT_TRUE(first && second);
  EXPECT_NE(*first, *second);
  EXPECT_TRUE(first->starts_with("$y$"));
  EXPECT_TRUE(*hasHash("geheim ist geheim", *first));
  for (const std::string& bad : {std::string("short"), std::string(501, 'x'), std::string("with\0zero", 9)}) {
    EXPECT_FALSE(hashOfPassphrase(bad)) << bad.size();
  }
}

class ResearchKey : public testing::Test {
 protected:
  support::TempFolder folder_;
  SampleRecords records_;
  OpenStudy study_ = makeStudy(folder_.file("study.tactus"), records_);
};

TEST_F(ResearchKey, IsOptional) {
  EXPECT_FALSE(*hasResearchKey(study_.file));
  EXPECT_TRUE(*opensResearch(study_.file, "anything"));
  ASSERT_TRUE(setResearchKey(study_.file, "first key", 10));
  EXPECT_TRUE(*hasResearchKey(study_.file));
  EXPECT_TRUE(*opensResearch(study_.file, "first key"));
  EXPECT_FALSE(*opensResearch(study_.file, ""));
  ASSERT_TRUE(setResearchKey(study_.file, "second key", 9));  // an earlier time: the order of entry counts
  EXPECT_FALSE(*opensResearch(study_.file, "first key"));
  EXPECT_TRUE(*opensResearch(study_.file, "second key"));
  EXPECT_FALSE(setResearchKey(study_.file, "tiny", 11));
  ASSERT_TRUE(setResearchKey(study_.file, "", 12));
  EXPECT_FALSE(*hasResearchKey(study_.file));
}

TEST_F(ResearchKey, StaysInItsFile) {
  ASSERT_TRUE(setResearchKey(study_.file, "first key", 10));
  ASSERT_TRUE(writeRecords(study_.file, folder_.file("tables")));
  ASSERT_TRUE(restoreRecords(folder_.file("tables"), folder_.file("restored.tactus")));
  EXPECT_FALSE(*hasResearchKey(*StudyFile::open(folder_.file("restored.tactus"))));
}

TEST_F(ResearchKey, ADamagedHashOpensNothing) {
  ASSERT_TRUE(setResearchKey(study_.file, "first key", 10));
  ASSERT_TRUE(study_.file.close());
  ASSERT_EQ(PlainSql(folder_.file("study.tactus")).complaintWithoutGuards("UPDATE research_key SET hash = ''"), "");
  const auto file = StudyFile::open(folder_.file("study.tactus"));
  EXPECT_FALSE(hasResearchKey(*file));
  EXPECT_FALSE(opensResearch(*file, "first key"));
}

}  // namespace
}  // namespace tactus::store
