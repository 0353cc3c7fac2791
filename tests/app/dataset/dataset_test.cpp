// What holds of every layout: nothing identifies a person or a place, and only an earlier data set is replaced.
#include "app/dataset/dataset.h"

#include <gtest/gtest.h>

#include "app/dataset/tsv.h"

#include "tests/app/dataset/small_study.h"
#include "tests/support/french_probe.h"
#include "tests/support/temp_folder.h"

namespace tactus::dataset {
namespace {

class EveryLayout : public testing::TestWithParam<Layout> {
 protected:
  base::Result<DataSet> write(const study::Study& study, std::uint64_t seed = 1) {
    return writeDataSet(study, GetParam(), out_, seed, "tactus 9.8.7");
  }

  support::TempFolder folder_;
  std::string out_ = folder_.file("out");
};

TEST_P(EveryLayout, TellsNothingOfPersonsAndPlaces) {
  ASSERT_TRUE(write(smallStudy()));
  for (const auto& [name, bytes] : filesBelow(out_)) {
    for (const char* text : {"nora", "Ode", "quiet", "Ward", "ward 3", "12.25", "3.5", "head nurse"}) {
      EXPECT_EQ(bytes.find(text), std::string::npos) << name << " says " << text;
      EXPECT_EQ(name.find(text), std::string::npos) << name;
    }
  }
}

TEST_P(EveryLayout, SaysThatDataAreSimulatedOnlyIfSomeAre) {
  auto study = smallStudy();
  study.participants[1].simulated = false;
  ASSERT_TRUE(write(study));
  const auto files = filesBelow(out_);
  EXPECT_EQ(files.at("dataset_description.json").find("imulated by a program"), std::string::npos);
  EXPECT_EQ(files.at("dataset_description.json").find("with simulated data"), std::string::npos);
}

TEST_P(EveryLayout, SaysWhichProcedureItIsAbout) {
  ASSERT_TRUE(write(smallStudy()));
  EXPECT_NE(filesBelow(out_).at("dataset_description.json").find("Forces of nasogastric tube insertion as experts"),
            std::string::npos);
  ASSERT_TRUE(write(support::probeStudy()));
  for (const auto& [name, bytes] : filesBelow(out_)) {
    for (const char* text : {"naso", "esoph", "nostril", "neck", "stomach", "lubric", "trokes at speeds that"})
      EXPECT_EQ(bytes.find(text), std::string::npos) << name << " says " << text;
  }
  EXPECT_NE(filesBelow(out_).at("dataset_description.json").find("Forces of sonde articulaire as experts"),
            std::string::npos);
}

TEST_P(EveryLayout, CountsItsFilesAndParticipants) {
  const auto done = write(smallStudy());
  ASSERT_TRUE(done);
  EXPECT_EQ(done->participants, 3U);
  EXPECT_EQ(done->files, filesBelow(out_).size());
}

TEST_P(EveryLayout, ReplacesAnEarlierOneOnly) {
  ASSERT_TRUE(write(smallStudy()));
  auto less = smallStudy();
  less.speeds.clear();
  ASSERT_TRUE(write(less));
  for (const auto& [name, bytes] : filesBelow(out_)) EXPECT_EQ(name.find("_motion."), std::string::npos) << name;

  std::ofstream(out_ + "/analysis.R") << "mine";
  const auto before = filesBelow(out_);
  const auto refused = write(smallStudy());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("'analysis.R'"), std::string::npos) << refused.error().message();
  EXPECT_EQ(filesBelow(out_), before);

  const auto other = GetParam() == Layout::kBids ? Layout::kPsychDs : Layout::kBids;
  std::filesystem::remove(out_ + "/analysis.R");
  EXPECT_FALSE(writeDataSet(smallStudy(), other, out_, 1, "tactus 9.8.7"));
}

TEST_P(EveryLayout, AStudyWithoutParticipantsIsRefused) {
  const auto refused = write(study::Study{"empty", {}, {}, {}, {}, {}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(), "empty: found no participant, wanted at least one");
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_P(EveryLayout, TheOrderOfTheParticipantsFollowsTheSeed) {
  ASSERT_TRUE(write(smallStudy(), 1));
  const auto first = filesBelow(out_);
  ASSERT_TRUE(write(smallStudy(), 1));
  EXPECT_EQ(filesBelow(out_), first);
  bool differs = false;
  for (std::uint64_t seed = 2; seed < 12 && !differs; ++seed) {
    ASSERT_TRUE(write(smallStudy(), seed));
    differs = filesBelow(out_) != first;
  }
  EXPECT_TRUE(differs);
}

INSTANTIATE_TEST_SUITE_P(Layouts, EveryLayout, testing::Values(Layout::kPsychDs, Layout::kBids),
                         [](const auto& layout) { return layout.param == Layout::kBids ? "Bids" : "PsychDs"; });

}  // namespace
}  // namespace tactus::dataset
