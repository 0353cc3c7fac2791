#include "app/workbench/shell/command_search.h"

#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/features/features.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/feel_status.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/workbench.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

QStringList textsOf(const QList<SearchEntry>& entries) {
  QStringList texts;
  for (const SearchEntry& entry : entries) texts << entry.text;
  return texts;
}

TEST(FoundEntries, HoldEachWordAndBeginWithTheFirstWhereTheyCan) {
  const QList<SearchEntry> all{{QStringLiteral("Save as"), QStringLiteral("File"), {}},
                               {QStringLiteral("Open"), QStringLiteral("File"), {}},
                               {QStringLiteral("Reopen"), QStringLiteral("File"), {}}};
  EXPECT_EQ(textsOf(foundEntries(all, {})), textsOf(all));
  EXPECT_EQ(textsOf(foundEntries(all, QStringLiteral("open"))),
            (QStringList{QStringLiteral("Open"), QStringLiteral("Reopen")}));
  EXPECT_EQ(textsOf(foundEntries(all, QStringLiteral("reo FILE"))), QStringList{QStringLiteral("Reopen")});
  EXPECT_EQ(textsOf(foundEntries(all, QStringLiteral("file as"))), QStringList{QStringLiteral("Save as")});
  EXPECT_TRUE(foundEntries(all, QStringLiteral("open as")).isEmpty());
}

// Who types another word for the same thing finds it too, after what has the word itself.
TEST(FoundEntries, OtherWordsForTheSameThingAreFound) {
  const QList<SearchEntry> all{{QStringLiteral("Write tables to share…"), QStringLiteral("Study"), {}},
                               {QStringLiteral("Why here"), QStringLiteral("Panel"), {}},
                               {QStringLiteral("Export the bundle"), QStringLiteral("Deliver"), {}}};
  EXPECT_EQ(textsOf(foundEntries(all, QStringLiteral("export"))),
            (QStringList{QStringLiteral("Export the bundle"), QStringLiteral("Write tables to share…")}));
  EXPECT_EQ(textsOf(foundEntries(all, QStringLiteral("reason"))), QStringList{QStringLiteral("Why here")});
  EXPECT_TRUE(foundEntries(all, QStringLiteral("zzz")).isEmpty());
}

class SearchTest : public tests::ShownBench {
 protected:
  SearchTest() : ShownBench(Stage::kUnderstand) {}
  // Types into the search and takes the first that is found.
  void searchFor(const QString& typed) {
    CommandSearch search(
        bench.search->sources(), [this](const QString& words) { return bench.search->placesIn(words); }, &bench.window);
    search.show();
    auto* line = search.findChild<QLineEdit*>();
    QTest::keyClicks(line, typed);
    ASSERT_GT(search.findChild<QListWidget*>()->count(), 0) << typed.toStdString();
    QTest::keyClick(line, Qt::Key_Return);
    QCoreApplication::processEvents();
  }
};

TEST_F(SearchTest, LeadsToCommandsPanelsTermsAndExperts) {
  searchFor(QStringLiteral("findings panel"));
  EXPECT_TRUE(bench.panels.findings->isVisible());
  searchFor(QStringLiteral("near"));
  EXPECT_EQ(bench.window.stage(), Stage::kTune);
  EXPECT_EQ(bench.terms.variable().id, "depth");
  const auto& expert = bench.models.current()->model.experts.back();
  searchFor(labelOf(expert) + QStringLiteral(" expert"));
  EXPECT_EQ(bench.rules.expert().id, expert.id);
  searchFor(QStringLiteral("feel layout"));
  EXPECT_EQ(bench.window.layoutBeside(), feelLayout());
}

// The sentence of a hole says that no rule fires; who looks for one types "hole".
TEST_F(SearchTest, AFindingIsFoundByItsKind) {
  ASSERT_TRUE(QTest::qWaitFor([this] { return !bench.findings.findings().empty(); }, tests::kPatience));
  searchFor(QStringLiteral("hole"));
  ASSERT_TRUE(bench.findings.chosen());
  EXPECT_EQ(bench.findings.findings()[*bench.findings.chosen()].kind, QStringLiteral("Hole"));
  EXPECT_TRUE(bench.panels.findings->isVisible());
}

TEST_F(SearchTest, APlaceLeadsToTheForceThere) {
  bench.window.enter(Stage::kTune);
  searchFor(QStringLiteral("8 mm speed 20"));
  EXPECT_EQ(bench.window.stage(), Stage::kUnderstand);
  EXPECT_EQ(bench.scene.value(0), 20);
  EXPECT_EQ(bench.scene.value(1), 8);
  EXPECT_TRUE(bench.panels.rules_here->isVisible());
  // A says 0.75 N, B 0.25 N.
  EXPECT_NEAR(bench.scene.reading().mean.force_n, 0.5, 1e-12);
}

TEST_F(SearchTest, F6GoesThroughThePartsOfTheWindowAndBack) {
  QList<QWidget*> visited;
  const auto partOf = [&](QWidget* widget) -> QWidget* {
    for (QWidget* at = widget; at != nullptr; at = at->parentWidget()) {
      if (qobject_cast<Panel*>(at) != nullptr || at == &bench.window.strip()) return at;
    }
    return nullptr;
  };
  for (int i = 0; i < 12; ++i) {
    bench.window.focusNextPart(true);
    QWidget* part = partOf(bench.window.focusWidget());
    if (part != nullptr && !visited.contains(part)) visited << part;
  }
  EXPECT_TRUE(visited.contains(&bench.window.strip()));
  EXPECT_TRUE(visited.contains(bench.panels.curves));
  EXPECT_GE(visited.size(), 4);
  QWidget* here = bench.window.focusWidget();
  bench.window.focusNextPart(true);
  EXPECT_NE(bench.window.focusWidget(), here);
  bench.window.focusNextPart(false);
  EXPECT_EQ(partOf(bench.window.focusWidget()), partOf(here));
}

TEST_F(SearchTest, TheFeelLayoutIsForFeelingAloneAndLeadsBack) {
  bench.window.enterLayout(feelLayout());
  settle();
  for (const Panel* panel : bench.window.panels().panels()) {
    EXPECT_EQ(panel->isVisible(), panel == bench.panels.feel) << panel->objectName().toStdString();
  }
  const auto* picture = bench.views.feel->findChild<anatomy::BodyView*>();
  ASSERT_NE(picture, nullptr);
  EXPECT_GE(picture->height(), 320);
  // All of it is on the screen.
  EXPECT_TRUE(
      bench.views.feel->rect().contains(QRect(picture->mapTo(bench.views.feel, QPoint(0, 0)), picture->size())));
  EXPECT_EQ(bench.window.stage(), Stage::kUnderstand);
  bench.window.leaveLayout();
  EXPECT_TRUE(bench.panels.curves->isVisible());
  EXPECT_TRUE(bench.window.layoutBeside().isEmpty());
}

TEST_F(SearchTest, ForceOffIsRedInTheCornerWhileADeviceGivesForces) {
  auto* off = bench.window.findChild<ForceOffButton*>();
  ASSERT_NE(off, nullptr);
  EXPECT_FALSE(off->isVisible());
  bench.feel.start(QStringLiteral("virtual"));
  ASSERT_TRUE(bench.feel.isRunning());
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune, Stage::kDeliver}) {
    bench.window.enter(stage);
    EXPECT_TRUE(off->isVisible());
  }
  QTest::mousePress(off, Qt::LeftButton);
  EXPECT_FALSE(bench.feel.isRunning());
  EXPECT_FALSE(off->isVisible());
}

}  // namespace
}  // namespace tactus::workbench
