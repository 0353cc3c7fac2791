#include "app/workbench/labs/force/force_lab.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/force/judgement_grid.h"
#include "core/store/entries.h"
#include "elicitation/model/method_study.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using elicitation::ForceTermsFrom;
using elicitation::VoteReason;
using tests::comesTrue;
using Judged = study::ForceJudgement::Kind;

/// The demo's study, whose judgements give the votes of the paper's Table 2.
class ForceLabTest : public testing::Test {
 protected:
  void SetUp() override {
    study.open(path);
    lab.setWanted(true);
    ASSERT_TRUE(comesTrue([this] { return lab.votes().steps.size() >= 11; }));
  }

  const elicitation::VoteStep& stepAt(double force_n) const {
    for (const auto& step : lab.votes().steps) {
      if (std::abs(step.force_n - force_n) < 1e-9) return step;
    }
    ADD_FAILURE() << "no step at " << force_n;
    return lab.votes().steps.front();
  }
  const session::JudgedForce& judgedAt(double force_n, const std::string& word) const {
    for (const auto& one : lab.judgements()) {
      if (one.counts && std::abs(one.record.commanded_n - force_n) < 1e-9 && one.record.term == word) return one;
    }
    ADD_FAILURE() << "nobody said " << word;
    return lab.judgements().front();
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  StudyConnection study;
  LabData data{study};
  Corrections corrections{data};
  LabModel model{data};
  ForceLab lab{data, model, corrections};
};

// The newtons beside a method are those of the two models, over the points of the method study.
TEST_F(ForceLabTest, EachOtherWaySaysWhatItWouldDoToTheForce) {
  ASSERT_TRUE(comesTrue([this] { return !lab.effectOf(ForceTermsFrom::kProbit).isEmpty(); }));
  EXPECT_TRUE(lab.effectOf(ForceTermsFrom::kVote).isEmpty());
  const LabStudy& of = *data.study();
  auto settings = data.settings();
  const auto now = elicitation::buildModel(of.study, of.forms, settings);
  settings.force_terms = ForceTermsFrom::kProbit;
  const auto instead = elicitation::buildModel(of.study, of.forms, settings);
  ASSERT_TRUE(now && instead);
  const auto moved = elicitation::methodDifference(now->model, instead->model);
  ASSERT_TRUE(moved);
  ASSERT_GT(moved->largest_n, 0.001);
  EXPECT_EQ(lab.effectOf(ForceTermsFrom::kProbit),
            QStringLiteral("Instead: at most %1").arg(quantityText(moved->largest_n, "N", 3)));
  // With the other way chosen it is the present one that has an effect.
  lab.setMethod(ForceTermsFrom::kProbit);
  EXPECT_TRUE(comesTrue([this] {
    return lab.effectOf(ForceTermsFrom::kProbit).isEmpty() && !lab.effectOf(ForceTermsFrom::kVote).isEmpty();
  }));
}

TEST_F(ForceLabTest, Table2WithItsWinnersAndReasons) {
  VoteTable table;
  table.setVotes(lab.votes());
  // domain.md 0.3
  const char* const winners[] = {"Very Small", "Very Small", "Small",      "Small",      "Medium",    "Medium",
                                 "Large",      "Very Large", "Very Large", "Very Large", "Very Large"};
  for (int row = 0; row < 11; ++row) {
    const QModelIndex cell = table.index(row, table.winnerColumn());
    EXPECT_EQ(cell.data().toString().toLower(), QString::fromLatin1(winners[row]).toLower()) << row;
  }
  EXPECT_EQ(table.index(2, VoteTable::kForce).data().toString(), QStringLiteral("0.3 N"));
  EXPECT_EQ(stepAt(0.3).reason, VoteReason::kNextLevel);
  EXPECT_EQ(stepAt(0.9).reason, VoteReason::kTieHigher);
  EXPECT_EQ(table.index(0, VoteTable::kFirstWord).data().toString(), QStringLiteral("3"));
  EXPECT_DOUBLE_EQ(table.index(0, VoteTable::kFirstWord).data(VoteTable::kShareRole).toDouble(), 0.75);
  EXPECT_TRUE(table.index(2, VoteTable::kFirstWord + 1).data(VoteTable::kWinsRole).toBool());
}

TEST_F(ForceLabTest, TheFourWaysSideBySide) {
  for (const ForceMethod& method : lab.votes().methods) {
    EXPECT_TRUE(method.terms) << method.refusal.toStdString();
    EXPECT_TRUE(method.refusal.isEmpty());
  }
  // elicitation.md 3: medium is .4 .5 .6 .7 by the vote.
  const auto& vote = lab.votes().methods[0];
  ASSERT_EQ(vote.from, ForceTermsFrom::kVote);
  const std::vector<double>& medium = vote.terms->output.terms[2].points;
  ASSERT_EQ(medium.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(medium[i], 0.4 + 0.1 * static_cast<double>(i), 1e-9);
  lab.setMethod(ForceTermsFrom::kThresholds);
  EXPECT_EQ(data.settings().force_terms, ForceTermsFrom::kThresholds);
}

TEST_F(ForceLabTest, ACorrectedJudgementVotesAnewAndUndoBringsTheOldOneBack) {
  // At .3 N all four differ; with two votes for medium it is the majority.
  const session::JudgedForce judged = judgedAt(0.3, "very_small");
  lab.correct(judged, {Judged::kTerm, "medium"});
  ASSERT_TRUE(comesTrue([this] { return stepAt(0.3).reason == VoteReason::kMajority && !corrections.isBusy(); }));
  EXPECT_EQ(stepAt(0.3).votes, (std::vector<int>{0, 1, 2, 1, 0}));
  EXPECT_EQ(*stepAt(0.3).term, 2U);
  // The running maximum lifts the small forces above it.
  EXPECT_TRUE(stepAt(0.4).monotone_raised);

  JudgementGrid grid;
  grid.setJudgements(lab.votes().words, lab.judgements(), "ascending");
  ASSERT_EQ(grid.rowCount(), 4);
  int corrected = 0;
  for (int row = 0; row < 4; ++row) {
    const auto cell = grid.at(grid.index(row, grid.columnOf(0.3)));
    ASSERT_EQ(cell.size(), 1U);
    corrected += cell[0]->before.empty() ? 0 : 1;
  }
  EXPECT_EQ(corrected, 1);

  corrections.undo();
  ASSERT_TRUE(comesTrue([this] { return stepAt(0.3).reason == VoteReason::kNextLevel && !corrections.isBusy(); }));
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  EXPECT_TRUE(lab.votes().steps.empty());
  const auto file = tests::lookInto(path);
  const auto all = store::judgements(file, {{}, {}, true});
  EXPECT_EQ(std::count_if(all->begin(), all->end(), [](const auto& one) { return one.entry.supersedes.has_value(); }),
            2);
}

TEST_F(ForceLabTest, BeyondPracticeIsOfferedOnlyAtTheEndOfASeries) {
  const auto offers = [this](const session::JudgedForce& judged, Judged kind) {
    const auto words = offeredWords(lab.votes().words, lab.judgements(), judged);
    return std::any_of(words.begin(), words.end(), [&](const auto& word) { return word.kind == kind; });
  };
  const session::JudgedForce& first = judgedAt(0.1, "very_small");
  EXPECT_FALSE(offers(first, Judged::kBeyondPractice));
  EXPECT_TRUE(offers(first, Judged::kNotFelt));
  EXPECT_TRUE(offers(first, Judged::kNoAnswer));
  const auto words = offeredWords(lab.votes().words, lab.judgements(), first);
  EXPECT_EQ(std::count(words.begin(), words.end(), judgedWord(first.record)), 0);
  const session::JudgedForce* last = nullptr;
  for (const auto& one : lab.judgements()) {
    if (one.record.series == "ascending" && (last == nullptr || one.record.step > last->record.step)) last = &one;
  }
  session::JudgedForce end = *last;
  end.record.kind = Judged::kTerm;
  end.record.term = "very_large";
  EXPECT_TRUE(offers(end, Judged::kBeyondPractice));
}

TEST_F(ForceLabTest, AJudgementSaysHowFarItMovesTheAveragedForce) {
  ASSERT_TRUE(comesTrue([this] { return model.built() != nullptr; }));
  // One of the two votes for small at .4 N decides; at 1.1 N all say very large.
  lab.askInfluence(judgedAt(0.4, "small"));
  ASSERT_TRUE(comesTrue([this] { return lab.influence().contains(QStringLiteral("0.4 N")); }));
  EXPECT_TRUE(lab.influence().contains(QStringLiteral("just-noticeable"))) << lab.influence().toStdString();
  lab.askInfluence(judgedAt(1.1, "very_large"));
  ASSERT_TRUE(comesTrue([this] { return lab.influence().contains(QStringLiteral("1.1 N")); }));
  EXPECT_TRUE(lab.influence().contains(QStringLiteral("is the same"))) << lab.influence().toStdString();
}

TEST_F(ForceLabTest, TheAnswerFollowsACorrection) {
  ASSERT_TRUE(comesTrue([this] { return model.built() != nullptr; }));
  // At .4 N two of four say small, one medium, one very large: without the last the winner is the same. With medium in
  // its place it is a tie, which medium wins: without it small would win again.
  const session::JudgedForce last = judgedAt(0.4, "very_large");
  lab.askInfluence(last);
  ASSERT_TRUE(comesTrue([this] { return lab.influence().contains(QStringLiteral("is the same")); }));
  lab.correct(last, {Judged::kTerm, "medium"});
  EXPECT_TRUE(comesTrue([this] { return lab.influence().contains(QStringLiteral("just-noticeable")); }))
      << lab.influence().toStdString();
}

TEST_F(ForceLabTest, ChecksOfEachParticipant) {
  ASSERT_EQ(lab.checks().size(), 4U);
  struct CheckTable {
    enum { kWho = 0 };
  };
  Columns<ParticipantChecks> table(checkColumns());
  table.setRows(lab.checks());
  EXPECT_EQ(table.index(0, CheckTable::kWho).data().toString(), QStringLiteral("S1"));
  // Table 2 splits into four monotone participants: no larger force has a smaller word in the rising series.
  for (const ParticipantChecks& one : lab.checks()) {
    ASSERT_FALSE(one.checks.monotonicity.empty());
    EXPECT_EQ(one.checks.monotonicity.front().violations, 0U) << one.participant;
  }
}

}  // namespace
}  // namespace tactus::workbench
