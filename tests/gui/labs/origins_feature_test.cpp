// From a number in the window to the records behind it, and to the lab that shows them.
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "app/workbench/base/display_text.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/features/features.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/labs/force/judgement_grid.h"
#include "app/workbench/labs/force/judgement_view.h"
#include "app/workbench/labs/force/votes_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/origins/origin_window.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/labs/speed/trace_row.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "app/workbench/workbench.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

constexpr int kBuildMs = 60'000;  // a second or two on a quiet machine

class OriginsFeatureTest : public testing::Test {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
    bench.files.open(path);
    ASSERT_TRUE(comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); }));
  }
  /// Puts the study's model on the bench.
  bool built() {
    bench.study_models.buildModel();
    return QTest::qWaitFor([this] { return bench.models.current() != nullptr; }, kBuildMs);
  }
  bool answered() {
    return QTest::qWaitFor([this] { return bench.labs.origins.origin() != nullptr; }, kBuildMs);
  }
  const Origin& origin() { return *bench.labs.origins.origin(); }
  /// The rows stand by their effect, as far as it is known.
  static QModelIndex rowOf(OriginWindow& view, const OriginRecord& record) {
    const QAbstractItemModel& rows = *view.table().model();
    for (int row = 0; row < rows.rowCount(); ++row) {
      if (rows.index(row, 0).data() == record.participant && rows.index(row, 1).data() == record.what)
        return rows.index(row, 1);
    }
    ADD_FAILURE() << "no row of " << record.what.toStdString();
    return {};
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.filePath(QStringLiteral("autosave"))};
};

// The vertex is one click, "Where from?" the second: the raw trace of the first stroke is on the screen then.
TEST_F(OriginsFeatureTest, AVertexOfTheBenchLeadsToTheRawStrokes) {
  ASSERT_TRUE(built());
  bench.window.enter(Stage::kTune);
  bench.terms.setVariable("speed");
  emit bench.views.membership_editor->originAsked("speed", "medium", 0);
  ASSERT_TRUE(answered());
  EXPECT_EQ(origin().records.size(), 48U);  // four nurses, three levels of four strokes
  OriginWindow& view = *bench.origins->view();
  EXPECT_TRUE(view.isVisible());
  ASSERT_NE(view.chosen(), nullptr);
  auto* const preview = view.findChild<StrokePreview*>();
  ASSERT_NE(preview, nullptr);
  EXPECT_TRUE(preview->isVisible());
  EXPECT_TRUE(comesTrue([&] { return preview->row().hasStrokes(); }));
  EXPECT_TRUE(QTest::qWaitFor([&] { return bench.labs.origins.influence(0).has_value(); }, kBuildMs));

  const elicitation::StrokeKey key = origin().records[5].stroke;
  const QModelIndex sixth = rowOf(view, origin().records[5]);
  view.table().setCurrentIndex(sixth);
  emit view.table().clicked(sixth);
  EXPECT_EQ(bench.window.stage(), Stage::kBuild);
  const StrokeInfluence& moves = bench.views.speed->strokes().influence();
  ASSERT_TRUE(QTest::qWaitFor([&] { return moves.asked() == key; }, kBuildMs));
  EXPECT_TRUE(QTest::qWaitFor([&] { return moves.sentence().contains(QStringLiteral(" rms")); }, kBuildMs));
}

// A header that hides asks for its columns again: the records are gone by then, and the table has to know it.
TEST_F(OriginsFeatureTest, TheWindowClosesAndAnswersTheNextQuestion) {
  bench.window.enter(Stage::kBuild);
  ForceLabView& lab = *bench.views.force;
  bench.views.labs->reveal(&lab);
  emit lab.votes().originAsked(0.9, "large");
  ASSERT_TRUE(answered());
  OriginWindow& view = *bench.origins->view();
  ASSERT_EQ(view.table().model()->rowCount(), 2);
  view.close();
  EXPECT_FALSE(view.isVisible());
  EXPECT_EQ(bench.labs.origins.origin(), nullptr);
  EXPECT_EQ(view.table().model()->rowCount(), 0);
  EXPECT_EQ(view.table().model()->headerData(0, Qt::Horizontal).toString(), QStringLiteral("Participant"));

  emit lab.votes().originAsked(0.1, "very_small");
  ASSERT_TRUE(answered());
  EXPECT_TRUE(view.isVisible());
  EXPECT_EQ(view.table().model()->rowCount(), 3);
}

TEST_F(OriginsFeatureTest, AVoteLeadsToItsJudgements) {
  bench.window.enter(Stage::kBuild);
  ForceLabView& lab = *bench.views.force;
  bench.views.labs->reveal(&lab);
  emit lab.votes().originAsked(0.9, "large");
  ASSERT_TRUE(answered());
  ASSERT_EQ(origin().records.size(), 2U);  // S3 and S4 (elicitation.md 3)
  OriginWindow& view = *bench.origins->view();
  view.table().setCurrentIndex(rowOf(view, origin().records[1]));
  emit view.table().clicked(view.table().currentIndex());
  const JudgementGrid& grid = lab.judgements().grid();
  ASSERT_TRUE(QTest::qWaitFor([&] { return lab.judgements().table().currentIndex().column() == grid.columnOf(0.9); },
                              kBuildMs));
  EXPECT_EQ(grid.participant(lab.judgements().table().currentIndex().row()), "S4");
}

TEST_F(OriginsFeatureTest, WhatMovesTheForceMostStandsFirst) {
  bench.window.enter(Stage::kBuild);
  ForceLabView& lab = *bench.views.force;
  bench.views.labs->reveal(&lab);
  emit lab.votes().originAsked(0.4, {});
  ASSERT_TRUE(answered());
  const std::size_t count = origin().records.size();
  ASSERT_EQ(count, 4U);  // all four nurses judged 0.4 N
  std::vector<std::pair<double, QString>> by_effect;
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return bench.labs.origins.influence(i).has_value(); }, kBuildMs));
    ASSERT_TRUE(*bench.labs.origins.influence(i));
    by_effect.emplace_back(-(*bench.labs.origins.influence(i))->difference.largest_n, origin().records[i].participant);
  }
  std::stable_sort(by_effect.begin(), by_effect.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  ASSERT_LT(by_effect.front().first, 0);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(bench.origins->view()->table().model()->index(static_cast<int>(i), 0).data().toString(),
              by_effect[i].second);
  }
}

// From a rule in "Why here" to the nurse's answer, and on to all that she said, at that answer.
TEST_F(OriginsFeatureTest, ARuleLeadsToTheAnswerInTheRecordOfItsParticipant) {
  ASSERT_TRUE(built());
  const fuzzy::Expert& expert = bench.models.current()->model.experts[1];
  const fuzzy::Rule& rule = expert.rules[2];
  emit bench.views.why->answerAsked(expert.id, rule);
  ASSERT_TRUE(answered());
  ASSERT_EQ(origin().records.size(), 1U);
  OriginWindow& view = *bench.origins->view();
  const QString who = QString::fromStdString(expert.id);
  QPushButton* lead = nullptr;
  for (QPushButton* button : view.findChildren<QPushButton*>()) {
    if (button->isVisible() && button->text().contains(QStringLiteral("record of ") + who)) lead = button;
  }
  ASSERT_NE(lead, nullptr);
  lead->click();
  auto* const record = bench.window.findChild<RecordDialog*>();
  ASSERT_NE(record, nullptr);
  EXPECT_TRUE(record->windowTitle().contains(who));
  ASSERT_TRUE(comesTrue([&] { return record->chosen() >= 0; }));
  const RecordLine& line = record->lines()[static_cast<std::size_t>(record->chosen())];
  EXPECT_EQ(line.said, spelled(rule.then));
  EXPECT_TRUE(origin().records.front().what.startsWith(line.asked.section(QStringLiteral(" of "), 0, 0)));
}

TEST_F(OriginsFeatureTest, AModelThatWasNotBuiltFromTheStudySaysSo) {
  // A model without provenance is put into the study's place on the bench.
  ASSERT_TRUE(bench.files.makeFromTemplate());
  bench.terms.setVariable("speed");
  emit bench.views.membership_editor->originAsked("speed", "medium", 0);
  EXPECT_EQ(bench.labs.origins.origin(), nullptr);
  EXPECT_TRUE(bench.labs.origins.failure().contains(QStringLiteral("was not built from records")));
  EXPECT_TRUE(bench.origins->view() != nullptr && bench.origins->view()->isVisible());
}

}  // namespace
}  // namespace tactus::workbench
