
#include <filesystem>
#include <gtest/gtest.h>

#include "core/store/copies.h"
#include "core/store/persons.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

class RollingCopies : public testing::Test {
 protected:
  std::size_t personsIn(const std::string& path) {
    const auto renamed = folder_.file("looked-at.tactus");
    fs::copy_file(path, renamed, fs::copy_options::overwrite_existing);
    const auto file = StudyFile::open(renamed, {Access::kReadOnly, {}});
    EXPECT_TRUE(file) << file.error().message();
    return persons(*file)->size();
  }
  void addPerson(const std::string& code) {
    ASSERT_TRUE(append(study_.file, study::Person{study::RecordIds(++seed_).next(), code, false}));
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("a.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
  std::uint64_t seed_ = 100;
};

TEST_F(RollingCopies, TheNewestTwoStayWithTheModeOfTheStudy) {
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  for (const char* const code : {"first-fox", "second-fox", "third-fox"}) {
    ASSERT_TRUE(keepCopy(study_.file));
    addPerson(code);
  }
  EXPECT_EQ(personsIn(path_ + ".copy-1"), 3U);
  EXPECT_EQ(personsIn(path_ + ".copy-2"), 2U);
  EXPECT_FALSE(fs::exists(path_ + ".copy-3"));
  EXPECT_FALSE(fs::exists(path_ + ".copy-0"));
  EXPECT_EQ(fs::status(path_ + ".copy-1").permissions(), fs::status(path_).permissions());
}

TEST_F(RollingCopies, WhereNoneCanBeKeptTheOldOnesStay) {
  ASSERT_TRUE(keepCopy(study_.file));
  fs::create_directories(path_ + ".copy-0/in the way");
  const auto kept = keepCopy(study_.file);
  ASSERT_FALSE(kept);
  EXPECT_FALSE(kept.error().message().empty());
  EXPECT_EQ(personsIn(path_ + ".copy-1"), 1U);
}

TEST_F(RollingCopies, AWithdrawalRemovesThem) {
  ASSERT_TRUE(keepCopy(study_.file));
  ASSERT_TRUE(keepCopy(study_.file));
  const auto found = findCopies(path_, study_.person.id, {});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].what, "a copy made when the study was opened");
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 10));
  EXPECT_FALSE(fs::exists(path_ + ".copy-1"));
  EXPECT_FALSE(fs::exists(path_ + ".copy-2"));
}

}  // namespace
}  // namespace tactus::store
