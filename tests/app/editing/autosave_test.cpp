#include "app/editing/autosave.h"

#include <gtest/gtest.h>

#include "app/editing/same_bits.h"
#include "core/base/random.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

const Stamp kAnn{"Ann", 1000};

class AutosaveTest : public testing::Test {
 protected:
  Edit foot(double to) const { return must(moveVertex(history_.base(), {kDepth, "nasopharynx", 3}, to)); }

  EditHistory history_ = EditHistory::open(support::s4AsPrinted(), "S4", kAnn, study::RecordIds(1)).value();
};

TEST_F(AutosaveTest, NothingIsLostInACrash) {
  history_.apply(foot(130), kAnn);
  const auto stored = unstoredVersions(history_);
  for (const auto& version : stored) history_.markStored(version.id);
  EXPECT_FALSE(needsAutosave(history_));
  history_.apply(foot(131), kAnn);
  ASSERT_TRUE(history_.undo(kAnn));
  history_.update(foot(135));
  EXPECT_TRUE(needsAutosave(history_));

  const auto autosave = parseAutosave(autosaveText(history_, "models/s4.tactus.json"), "autosave").value();
  EXPECT_EQ(autosave.document, "models/s4.tactus.json");
  ASSERT_EQ(autosave.versions.size(), 2);
  ASSERT_TRUE(autosave.unfinished);
  auto back = recovered(stored, autosave, study::RecordIds(2), {"Ann", 9000}).value();
  EXPECT_TRUE(sameBits(back.model(), history_.model()));
  EXPECT_EQ(back.labelOf(back.current()), "Depth / nasopharynx: right foot 130 to 135 mm (recovered)");
  // What the study file did not have it does not have now either, nor the gesture.
  const auto unstored = unstoredVersions(back);
  ASSERT_EQ(unstored.size(), 3);
  EXPECT_EQ(unstored[0], autosave.versions[0]);
  EXPECT_EQ(unstored[1], autosave.versions[1]);
  EXPECT_TRUE(needsAutosave(back));
  ASSERT_TRUE(back.undo(kAnn));
  EXPECT_TRUE(sameBits(back.model(), history_.base()));
}

TEST_F(AutosaveTest, AModelThatWasOnlyOpenedNeedsNone) {
  EXPECT_FALSE(needsAutosave(history_));
  history_.begin();
  EXPECT_FALSE(needsAutosave(history_));
  history_.update(foot(130));
  EXPECT_TRUE(needsAutosave(history_));
  history_.cancel();
  history_.snapshot("as it came", kAnn);
  EXPECT_TRUE(needsAutosave(history_));
}

TEST_F(AutosaveTest, PartsTogetherSayTheSame) {
  for (const double to : {130.0, 131.0, 132.0}) history_.apply(foot(to), kAnn);
  history_.update(foot(140));
  const auto whole = parseAutosave(autosaveText(history_, "x"), "whole").value();
  const auto first = parseAutosave(autosaveText(history_, "x", {0, 2}), "first").value();
  const auto second = parseAutosave(autosaveText(history_, "x", {2, 4}), "second").value();
  ASSERT_EQ(first.versions.size(), 2);
  EXPECT_FALSE(first.unfinished);
  auto joined = first.versions;
  joined.insert(joined.end(), second.versions.begin(), second.versions.end());
  EXPECT_EQ(joined, whole.versions);
  ASSERT_TRUE(second.unfinished);
}

TEST_F(AutosaveTest, WithoutAStudyEveryStateComesBack) {
  const auto opened = history_.model();
  history_.apply(foot(130), kAnn);
  ASSERT_TRUE(history_.undo(kAnn));
  history_.apply(foot(131), kAnn);
  history_.signOff({"S4", 2000});
  const auto autosave = parseAutosave(autosaveText(history_, "x"), "autosave").value();
  auto back = recovered({}, autosave, study::RecordIds(2), kAnn).value();
  EXPECT_TRUE(sameBits(back.model(), history_.model()));
  EXPECT_EQ(back.events().size(), history_.events().size());
  ASSERT_TRUE(back.returnTo(1, kAnn));
  EXPECT_EQ(pointsOf(back.model(), "depth", "nasopharynx")[3], 130);
  ASSERT_TRUE(back.undo(kAnn));
  EXPECT_TRUE(sameBits(back.model(), opened));
  EXPECT_FALSE(back.canUndo());
}

TEST_F(AutosaveTest, WhatReachedTheStudyFileIsNotAppendedTwice) {
  history_.apply(foot(130), kAnn);
  const auto all = unstoredVersions(history_);
  const auto autosave = parseAutosave(autosaveText(history_, "x"), "autosave").value();
  EXPECT_EQ(lostVersions(autosave, {}), all);
  EXPECT_EQ(lostVersions(autosave, std::span(all).first(1)), (std::vector{all[1]}));
  EXPECT_TRUE(lostVersions(autosave, all).empty());
  EXPECT_TRUE(sameBits(recovered(all, autosave, study::RecordIds(2), kAnn)->model(), history_.model()));
}

TEST_F(AutosaveTest, DamageIsRefusedInOneSentence) {
  history_.apply(foot(130), kAnn);
  history_.update(foot(140));
  const std::string text = autosaveText(history_, "x");
  EXPECT_FALSE(parseAutosave("", "f"));
  EXPECT_FALSE(parseAutosave("{}", "f"));
  EXPECT_FALSE(parseAutosave("{\"format\": \"tactus-autosave\", \"version\": 2}", "f"));
  // Another number inside a model does not fit the SHA-256.
  auto other = text;
  const auto place = other.find("Ann");
  ASSERT_NE(place, std::string::npos);
  const auto digit = other.find("130", other.find("right foot") + 60);
  ASSERT_NE(digit, std::string::npos);
  other[digit + 2] = '1';
  const auto refused = parseAutosave(other, "f");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::kMismatch);
  // Any cut and any flipped byte: an error or a model, never a crash.
  base::Random random(5);
  for (int k = 0; k < 300; ++k) {
    auto broken = text.substr(0, static_cast<std::size_t>(random.below(static_cast<int>(text.size()))));
    EXPECT_FALSE(parseAutosave(broken, "f"));
    broken = text;
    broken[static_cast<std::size_t>(random.below(static_cast<int>(text.size())))] =
        static_cast<char>(random.below(256));
    (void)parseAutosave(broken, "f");
  }
}

}  // namespace
}  // namespace tactus::editing
