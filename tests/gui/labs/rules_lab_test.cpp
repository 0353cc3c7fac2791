#include "app/workbench/labs/rules/rules_lab.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/labs/rules/expert_grids.h"
#include "core/store/entries.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

/// The demo's study: S1, S2 and S3 answered the form, S4's rules are those of the paper's Table A2.
class RulesLabTest : public testing::Test {
 protected:
  void SetUp() override {
    study.open(path);
    lab.setWanted(true);
    ASSERT_TRUE(comesTrue([this] { return lab.conflicts() != nullptr && !lab.work().isBusy(); }));
  }

  GridPlace placeOf(const std::string& input, const std::string& term, const std::string& region) const {
    const auto place = lab.grids().placeOf({{input, term}, {"depth", region}});
    EXPECT_TRUE(place) << input << " " << term << " " << region;
    return place ? GridPlace{place->first, place->second} : GridPlace();
  }
  std::size_t expertCalled(const std::string& id) const {
    const auto& experts = lab.grids().experts;
    for (std::size_t e = 0; e < experts.size(); ++e) {
      if (experts[e].id == id) return e;
    }
    ADD_FAILURE() << id;
    return 0;
  }
  const AskedCell& cell(const std::string& expert, const GridPlace& place) const {
    return lab.grids().at(expertCalled(expert), place.row, place.column);
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  StudyConnection study;
  LabData data{study};
  LabModel model{data};
  Corrections corrections{data};
  RulesLab lab{model, corrections};
};

TEST_F(RulesLabTest, TheGridOfS4IsTableA2) {
  EXPECT_EQ(lab.grids().rows.size(), 9U);
  // domain.md 0.4: words from 0 (very small) to 4; S4 knows no oropharynx, which the others were asked about.
  EXPECT_EQ(*cell("S4", placeOf("lubrication", "poor", "nasopharynx")).word, 4U);
  EXPECT_EQ(*cell("S4", placeOf("lubrication", "well", "stomach")).word, 0U);
  EXPECT_EQ(*cell("S4", placeOf("neck_flexion", "large", "esophagus")).word, 4U);
  EXPECT_EQ(*cell("S4", placeOf("speed", "slow", "esophagus")).word, 1U);
  EXPECT_TRUE(cell("S4", placeOf("speed", "slow", "esophagus")).given);
  EXPECT_FALSE(cell("S4", placeOf("lubrication", "well", "oropharynx")).asked);
  EXPECT_TRUE(cell("S1", placeOf("lubrication", "well", "oropharynx")).asked);
  EXPECT_FALSE(cell("S1", placeOf("lubrication", "well", "stomach")).asked);
  for (const GridExpert& expert : lab.grids().experts) EXPECT_EQ(expert.other_rules, 0U) << expert.id;
}

// A finding about a rule leads to the cell of that rule.
TEST_F(RulesLabTest, AFindingLeadsToItsCell) {
  ASSERT_TRUE(comesTrue([this] { return lab.findings() != nullptr; }));
  ASSERT_FALSE(lab.findings()->empty());
  std::size_t led = 0;
  for (std::size_t i = 0; i < lab.findings()->size(); ++i) {
    const elicitation::RuleFinding& finding = (*lab.findings())[i].finding;
    if (finding.experts.empty() || finding.sources.empty() || !finding.sources.front().rule) continue;
    if (!lab.chooseFinding(i)) continue;
    ++led;
    ASSERT_TRUE(lab.chosen());
    EXPECT_EQ(cell(finding.experts.front(), *lab.chosen()).rule, *finding.sources.front().rule) << finding.text;
  }
  EXPECT_GT(led, 0U);
}

// As in the bench: labels and no ids, and a rule by the item of the form that it came from.
TEST_F(RulesLabTest, AFindingIsSaidWithTheLabelsOfTheModel) {
  ASSERT_TRUE(comesTrue([this] { return lab.findings() != nullptr; }));
  bool items = false;
  for (const WordedFinding& worded : *lab.findings()) {
    EXPECT_FALSE(worded.sentence.contains(QLatin1Char('_'))) << worded.sentence.toStdString();
    EXPECT_FALSE(worded.who.isEmpty());
    const auto& sources = worded.finding.sources;
    if (worded.finding.kind != elicitation::RuleFinding::Kind::kLevelJump || sources.size() != 2) continue;
    if (sources[0].origin.item == 0) continue;
    items = true;
    const QString named = QStringLiteral("(item(s) %1, %2)").arg(sources[0].origin.item).arg(sources[1].origin.item);
    EXPECT_TRUE(worded.sentence.contains(named)) << worded.sentence.toStdString();
  }
  EXPECT_TRUE(items);
}

TEST_F(RulesLabTest, EachCellHasItsConflictInNewtons) {
  double largest = 0;
  std::size_t with_words = 0;
  for (std::size_t row = 0; row < lab.grids().rows.size(); ++row) {
    for (std::size_t column = 0; column < lab.grids().columns.size(); ++column) {
      const auto* const conflict = lab.conflictAt({row, column});
      if (conflict == nullptr) continue;
      ++with_words;
      largest = std::max(largest, conflict->rms_n);
      // Where all say the same nothing is felt.
      if (lab.grids().wordsApart(row, column) > 0) continue;
      EXPECT_EQ(conflict->rms_n, 0) << row << " " << column;
    }
  }
  EXPECT_EQ(with_words, lab.conflicts()->cells.size());
  EXPECT_GT(largest, 0);
}

TEST_F(RulesLabTest, ACorrectedAnswerChangesTheModelAndUndoBringsItBack) {
  const GridPlace place = placeOf("lubrication", "poor", "esophagus");
  const std::size_t before = *cell("S1", place).word;
  const std::size_t other = before == 0 ? 4 : 0;
  ASSERT_TRUE(cell("S1", place).record);
  EXPECT_GT(cell("S1", place).item, 0);
  lab.correctWord(expertCalled("S1"), place, other);
  ASSERT_TRUE(comesTrue([&] { return cell("S1", place).word == other && !lab.work().isBusy(); }));
  EXPECT_TRUE(cell("S1", place).corrected);
  const auto ruleSays = [&](const std::string& term) {
    for (const fuzzy::Rule& rule : model.built()->model.experts[expertCalled("S1")].rules) {
      if (rule.then == term && lab.grids().placeOf(rule.conditions) == std::pair(place.row, place.column)) return true;
    }
    return false;
  };
  EXPECT_TRUE(ruleSays(lab.grids().output.terms[other].id));
  EXPECT_GE(lab.conflictAt(place)->rms_n, 0);
  corrections.undo();
  ASSERT_TRUE(comesTrue([&] { return cell("S1", place).word == before && !lab.work().isBusy(); }));
  EXPECT_TRUE(ruleSays(lab.grids().output.terms[before].id));
}

TEST_F(RulesLabTest, AnAnswerTakenBackLeavesItsReasonAndAGivenRuleKeepsItsRecord) {
  const GridPlace place = placeOf("speed", "fast", "nasopharynx");
  lab.correctStatus(expertCalled("S2"), place, study::Answer::Status::kCantTell);
  ASSERT_TRUE(comesTrue([&] { return !cell("S2", place).word && !lab.work().isBusy(); }));
  EXPECT_FALSE(cell("S2", place).without.isEmpty());
  const GridPlace of_s4 = placeOf("speed", "medium", "nasal_cavity");
  ASSERT_EQ(*cell("S4", of_s4).word, 1U);
  lab.correctWord(expertCalled("S4"), of_s4, 2);
  ASSERT_TRUE(comesTrue([&] { return cell("S4", of_s4).word == 2U && !lab.work().isBusy(); }));
  EXPECT_TRUE(cell("S4", of_s4).corrected);
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  const auto file = tests::lookInto(path);
  const auto rules = store::rules(file, {{}, {}, true});
  EXPECT_EQ(rules->size(), 46U);  // 45 and the correction
}

TEST_F(RulesLabTest, EachWordOfTheChosenCellSaysWhatItMoves) {
  const GridPlace place = placeOf("lubrication", "poor", "esophagus");
  lab.choose(place);
  ASSERT_TRUE(comesTrue([this] { return lab.influenceOf(0).has_value(); }));
  double moved = 0;
  for (std::size_t e = 0; e < 4; ++e) {
    ASSERT_TRUE(lab.influenceOf(e));
    moved = std::max(moved, lab.influenceOf(e)->difference.largest_n);
  }
  EXPECT_GT(moved, 0);
  EXPECT_FALSE(lab.influenceOf(4));
}

// 24 px of the block's head, 90 of the columns' heads, two gaps of 8 and nine rows of 26 px: 364 px.
TEST(GridPlaces, HigherRoomGivesHigherCellsAsFarAsTheyStayCells) {
  const auto placesIn = [](int height_px) { return GridPlaces(9, 6, 4, {3, 6}, 100, 90, {1200, height_px}); };
  EXPECT_EQ(placesIn(200).height(), 364);
  EXPECT_EQ(placesIn(454).height(), 364 + 9 * 10);
  EXPECT_EQ(placesIn(454).leastHeight(), 364);
  EXPECT_EQ(placesIn(2000).cell(0, {0, 0}, 0).height(), 40);
}

TEST_F(RulesLabTest, AgreementLeadsWithTheOrdinalAlphaAndItsInterval) {
  ASSERT_EQ(lab.agreement().size(), 2U);
  const AgreementRow& judged = lab.agreement()[0];
  // elicitation.md 4, Table 2: ordinal .5515.
  EXPECT_NEAR(*judged.measures.alpha_ordinal, 0.5515, 5e-5);
  ASSERT_TRUE(judged.interval);
  EXPECT_LT(judged.interval->low, 0.5515);
  EXPECT_GT(judged.interval->high, 0.5515);
  EXPECT_EQ(lab.agreement()[1].raters, 3U);
  EXPECT_EQ(lab.agreement()[1].units, 45U);
  // Table 3 as printed, for a study without answers.
  ASSERT_EQ(lab.usability().size(), 6U);
  EXPECT_EQ(lab.usability()[0].here.n, 0U);
  EXPECT_DOUBLE_EQ(lab.usability()[0].published.mean, 5.78);
}

}  // namespace
}  // namespace tactus::workbench
