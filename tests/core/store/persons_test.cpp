#include "core/store/persons.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "core/store/person_codes.h"

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
  EXPECT_GT(drawn.size(), 95U);  // 100 draws from 46,161 codes: 0.1 doubles are expected
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

TEST_F(Persons, ANewCodeIsOneThatNobodyHas) {
  PersonCodes codes(3);
  const auto first = unusedCode(study_.file, codes);
  ASSERT_TRUE(first);
  ASSERT_TRUE(append(study_.file, records_.person(*first)));
  PersonCodes again(3);
  const auto second = unusedCode(study_.file, again);
  ASSERT_TRUE(second);
  EXPECT_NE(*second, *first);
}

}  // namespace
}  // namespace tactus::store
