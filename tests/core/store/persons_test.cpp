#include "core/store/persons.h"

#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <set>

#include "core/base/text.h"
#include "core/store/person_codes.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

TEST(PersonCodes, AreMadeOfPlainDifferentWords) {
  const PersonCodes codes(1);
  std::set<std::string_view> all;
  for (const auto& words : {codes.firstWords(), codes.secondWords()}) {
    EXPECT_GE(words.size(), 200U);
    for (const auto word : words) {
      EXPECT_TRUE(all.insert(word).second) << word << " twice";
      EXPECT_TRUE(word.size() >= 3 && word.size() <= 11) << word;
      EXPECT_TRUE(std::all_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; })) << word;
    }
  }
}

// Misheard or mistyped by one letter, a word is no other word, and two codes typed without their dash are never the
// same.
TEST(PersonCodes, AreEasyToTellApart) {
  const PersonCodes codes(1);
  for (const auto& words : {codes.firstWords(), codes.secondWords()}) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) EXPECT_GE(base::editDistance(words[i], words[k]), 2U) << words[i] << words[k];
    }
  }
  std::set<std::string> joined;
  for (const auto first : codes.firstWords()) {
    for (const auto second : codes.secondWords()) joined.insert(std::string(first) + std::string(second));
  }
  EXPECT_EQ(joined.size(), codes.firstWords().size() * codes.secondWords().size());
}

TEST(PersonCodes, FollowFromTheSeed) {
  PersonCodes first(7);
  PersonCodes same(7);
  PersonCodes other(8);
  std::set<std::string> drawn;
  int differences = 0;
  for (int i = 0; i < 100; ++i) {
    const auto code = first.next();
    EXPECT_EQ(code, same.next());
    if (code != other.next()) ++differences;
    drawn.insert(code);
    EXPECT_EQ(std::count(code.begin(), code.end(), '-'), 1) << code;
  }
  EXPECT_GT(differences, 95);
  EXPECT_GT(drawn.size(), 95U);  // 100 draws from 44,457 codes: 0.1 doubles are expected
  EXPECT_NE(PersonCodes().next() + PersonCodes().next(), PersonCodes().next() + PersonCodes().next());
}

class Persons : public testing::Test {
 protected:
  support::TempFolder folder_;
  SampleRecords records_;
  OpenStudy study_ = makeStudy(folder_.file("study.tactus"), records_);
};

TEST_F(Persons, HaveACodeOfTheirOwn) {
  const auto taken = append(study_.file, records_.person("velvet-otter"));
  ASSERT_FALSE(taken);
  EXPECT_NE(taken.error().message().find("found the code 'velvet-otter', which a person of the study has"),
            std::string::npos);
  const auto real = study::Person{records_.id(), "calm-fox", false};
  ASSERT_TRUE(append(study_.file, real));
  EXPECT_EQ(*persons(study_.file), (std::vector{real, study_.person}));
  EXPECT_EQ(*findPerson(study_.file, "calm-fox"), real);
  EXPECT_EQ(*findPerson(study_.file, "calm-owl"), std::nullopt);
}

TEST_F(Persons, HaveNoCodeThatASpreadsheetWouldRun) {
  for (const char* code : {"=1", "+1", "-1", "@a", "\ta", "\ra"}) {
    const auto refused = append(study_.file, records_.person(code));
    ASSERT_FALSE(refused) << code;
    EXPECT_NE(refused.error().message().find("wanted a name that does not begin with = + - @"), std::string::npos);
  }
}

TEST_F(Persons, ANewCodeIsOneThatNobodyHas) {
  PersonCodes codes(3);
  const auto first = unusedCode(study_.file, codes);
  ASSERT_TRUE(first);
  ASSERT_TRUE(append(study_.file, records_.person(*first)));
  PersonCodes again(3);
  const auto second = unusedCode(study_.file, again);
  ASSERT_TRUE(second);
  EXPECT_NE(*second, *first);
  // Tables write the same code in another way.
  std::string written = *second;
  std::replace(written.begin(), written.end(), '-', ' ');
  written[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(written[0])));
  ASSERT_TRUE(append(study_.file, records_.person(written)));
  PersonCodes third(3);
  EXPECT_NE(*unusedCode(study_.file, third), *second);
}

TEST_F(Persons, ANewCodeCountsEverywhereAndTheOldOneStaysTheirs) {
  ASSERT_TRUE(recode(study_.file, study_.person.id, "calm-fox", records_.id(), 10));
  EXPECT_EQ(persons(study_.file)->front().code, "calm-fox");
  EXPECT_EQ((*findPerson(study_.file, "calm-fox"))->id, study_.person.id);
  EXPECT_EQ(*findPerson(study_.file, "velvet-otter"), std::nullopt);
  // A later change counts, whatever the order in which the changes are told.
  ASSERT_TRUE(recode(study_.file, study_.person.id, "misty-lake", records_.id(), 8));
  EXPECT_EQ(persons(study_.file)->front().code, "calm-fox");
  for (const char* used : {"calm-fox", "velvet-otter", "misty-lake", ""}) {
    const auto other = recode(study_.file, study_.person.id, used, records_.id(), 11);
    EXPECT_FALSE(other) << used;
  }
  const auto refused = recode(study_.file, study_.person.id, "velvet-otter", records_.id(), 11);
  EXPECT_NE(
      refused.error().message().find("which a person of the study has or had, wanted one that no person had yet, such "
                                     "as 'velvet-otter-2'"),
      std::string::npos)
      << refused.error().message();
  EXPECT_FALSE(recode(study_.file, records_.id(), "quiet-drum", records_.id(), 11));
}

TEST_F(Persons, AreMeantByCodeOrById) {
  EXPECT_EQ(personNamed(study_.file, "velvet-otter")->id, study_.person.id);
  EXPECT_EQ(personNamed(study_.file, study::toText(study_.person.id))->id, study_.person.id);
  EXPECT_FALSE(personNamed(study_.file, study::toText(records_.id())));
  EXPECT_NE(personNamed(study_.file, "calm-owl").error().message().find("no participant 'calm-owl'"),
            std::string::npos);
}

TEST_F(Persons, TwoWithOneCodeAreNamedWithTheRemedy) {
  EXPECT_TRUE(requireDistinctCodes(study_.file));
  ASSERT_TRUE(study_.file.close());
  const std::string path = folder_.file("study.tactus");
  const std::string id = "ffffffffffffffffffffffffffffffff";
  {
    PlainSql sql(path);
    ASSERT_EQ(sql.complaintWithoutGuards("INSERT INTO person VALUES (x'" + id + "', 'velvet-otter', 0, 0);" +
                                         sql.seal("person")),
              "");
  }
  auto file = StudyFile::open(path);
  ASSERT_TRUE(file) << file.error().message();
  const std::string both =
      "found 2 persons with the code 'velvet-otter' (ids " + study::toText(study_.person.id) + ", " + id + "), wanted ";
  const std::string command = "tactus study recode " + path + " " + id + " velvet-otter-2";
  EXPECT_EQ(requireDistinctCodes(*file).error().message(),
            path + ": " + both + "a code of its own for each person: " + command);
  EXPECT_EQ(personNamed(*file, "velvet-otter").error().message(), path + ": " + both + "one of the ids");
  EXPECT_NE(findPerson(*file, "velvet-otter").error().message().find(command), std::string::npos);
  ASSERT_TRUE(recode(*file, *study::parseRecordId(id), "velvet-otter-2", records_.id(), 10));
  EXPECT_TRUE(requireDistinctCodes(*file));
  EXPECT_EQ((*findPerson(*file, "velvet-otter"))->id, study_.person.id);
}

TEST(ShellWord, IsOneWord) {
  EXPECT_EQ(shellWord("/tmp/a-b_c.tactus"), "/tmp/a-b_c.tactus");
  EXPECT_EQ(shellWord("my study.tactus"), "'my study.tactus'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(shellWord(""), "''");
}

}  // namespace
}  // namespace tactus::store
