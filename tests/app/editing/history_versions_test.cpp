#include "app/editing/history_versions.h"

#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "core/store/model_versions.h"

#include "tests/app/editing/sample_models.h"
#include "tests/support/temp_folder.h"

namespace tactus::editing {
namespace {

const Stamp kVersionsByAnn{"Ann", 1000};

class HistoryVersions : public testing::Test {
 protected:
  Edit foot(double to) const { return must(moveVertex(history_.model(), {kDepth, "nasopharynx", 3}, to)); }

  /// Everything that happened, appended to the study file.
  void storeAll() {
    for (const auto& version : unstoredVersions(history_)) {
      const auto added = store::append(file_, version);
      ASSERT_TRUE(added) << added.error().message();
      history_.markStored(version.id);
    }
  }

  /// The history read again as a workbench does at its start: texts of the last version only.
  EditHistory reopened() const {
    auto versions = store::modelVersions(file_).value();
    versions.back() = store::latestModelVersion(file_).value().value();
    auto read = historyFrom(versions, study::RecordIds(2));
    EXPECT_TRUE(read.has_value()) << (read ? "" : read.error().message());
    return std::move(*read);
  }

  void load(EditHistory& history, StateId state) const {
    const auto id = history.missing(state);
    ASSERT_TRUE(id);
    ASSERT_TRUE(provideVersion(history, state, store::modelVersion(file_, *id).value()));
  }

  support::TempFolder folder_;
  store::StudyFile file_ =
      store::StudyFile::create(folder_.file("study.tactus"), {study::RecordIds(3).next(), "study", 0, "test"}).value();
  const fuzzy::ForceModel model_ = support::s4AsPrinted();
  EditHistory history_ = EditHistory::open(model_, "S4", kVersionsByAnn, study::RecordIds(1)).value();
};

TEST_F(HistoryVersions, TheStudyFileTellsTheWholeStory) {
  history_.apply(foot(130), kVersionsByAnn);
  history_.apply(foot(131), kVersionsByAnn);
  ASSERT_TRUE(history_.undo(kVersionsByAnn));
  history_.snapshot("wide", kVersionsByAnn);
  history_.apply(foot(140), {"Ben", 2000});
  ASSERT_TRUE(history_.returnTo(2, kVersionsByAnn));
  ASSERT_TRUE(history_.undo(kVersionsByAnn));
  history_.signOff({"S4", 3000});
  storeAll();
  EXPECT_TRUE(unstoredVersions(history_).empty());

  auto read = reopened();
  EXPECT_EQ(read.current(), history_.current());
  EXPECT_TRUE(sameBits(read.model(), history_.model()));
  EXPECT_EQ(read.line(), history_.line());
  ASSERT_EQ(read.events().size(), history_.events().size());
  for (std::size_t e = 0; e < read.events().size(); ++e) {
    EXPECT_EQ(read.events()[e].kind, history_.events()[e].kind) << e;
    EXPECT_EQ(read.events()[e].label, history_.events()[e].label) << e;
    EXPECT_EQ(read.events()[e].state, history_.events()[e].state) << e;
    EXPECT_EQ(read.events()[e].stamp, history_.events()[e].stamp) << e;
    EXPECT_EQ(read.events()[e].id, history_.events()[e].id) << e;
  }
  EXPECT_EQ(read.states()[3].edits, 2);
  EXPECT_TRUE(unstoredVersions(read).empty());
  EXPECT_EQ(store::modelVersions(file_)->back().label, "sign-off: approved without feeling, after 1 edit");
}

TEST_F(HistoryVersions, UndoWorksAcrossARestart) {
  history_.apply(foot(130), kVersionsByAnn);
  history_.apply(foot(131), kVersionsByAnn);
  storeAll();
  auto read = reopened();
  EXPECT_FALSE(read.undo(kVersionsByAnn));
  load(read, 1);
  ASSERT_TRUE(read.undo(kVersionsByAnn));
  load(read, 0);
  ASSERT_TRUE(read.undo(kVersionsByAnn));
  EXPECT_TRUE(sameBits(read.model(), model_));
  EXPECT_EQ(unstoredVersions(read).size(), 2);
}

TEST_F(HistoryVersions, VersionsOfOtherProgramsAreEdits) {
  history_.apply(foot(130), kVersionsByAnn);
  auto versions = unstoredVersions(history_);
  versions[1].label = "tuned elsewhere";
  const auto read = historyFrom(versions, study::RecordIds(2)).value();
  EXPECT_EQ(read.labelOf(1), "tuned elsewhere");
  EXPECT_EQ(read.states()[1].parent, 0);
}

TEST_F(HistoryVersions, WhatMakesNoHistoryIsRefused) {
  EXPECT_FALSE(historyFrom({}, study::RecordIds(2)));
  auto versions = unstoredVersions(history_);
  versions.push_back(versions[0]);
  EXPECT_FALSE(historyFrom(versions, study::RecordIds(2)));
  versions.resize(1);
  versions[0].text = "{";
  EXPECT_FALSE(historyFrom(versions, study::RecordIds(2)));
}

}  // namespace
}  // namespace tactus::editing
