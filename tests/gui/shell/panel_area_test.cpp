#include "app/workbench/shell/panel_area.h"

#include <QLabel>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "tests/gui/patience.h"

namespace tactus::workbench {
namespace {

class PanelAreaTest : public testing::Test {
 protected:
  // Nothing but the address tells the two notes apart.
  PanelAreaTest() {
    area.setLayout(stageId(Stage::kTune),
                   {PanelPlace::first(plot), PanelPlace::right(notes, 40, plot), PanelPlace::behind(others, notes)});
    area.resize(1000, 600);
    area.show();
  }

  void enter() {
    area.enter(Stage::kTune);
    QCoreApplication::processEvents();
  }

  QTemporaryDir folder;
  QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
  PanelArea area{settings};
  Panel& plot = add("plot", "Plot");
  Panel& notes = add("notes", "Notes");
  Panel& others = add("others", "Notes");

 private:
  Panel& add(const char* id, const char* title) {
    auto* content = new QLabel(QString::fromLatin1(id));
    Panel& panel = area.addPanel(QString::fromLatin1(id), QString::fromLatin1(title), content);
    content->setObjectName(QStringLiteral("content"));
    return panel;
  }
};

TEST_F(PanelAreaTest, ALayoutSharesTheRoom) {
  enter();
  EXPECT_NEAR(notes.width(), 400, 20);  // a splitter takes some pixels
  EXPECT_NEAR(plot.width(), 600, 20);
  EXPECT_GE(notes.x(), plot.x() + plot.width());
}

TEST_F(PanelAreaTest, PanelsOfOneTitleAreTwoPanels) {
  const auto seen = [](const Panel& panel) { return panel.findChild<QLabel*>(QStringLiteral("content"))->isVisible(); };
  enter();
  EXPECT_TRUE(seen(notes));
  EXPECT_FALSE(seen(others));
  others.reveal();
  EXPECT_TRUE(QTest::qWaitFor([&] { return seen(others) && !seen(notes); }, tests::kPatience));
  // A double click on a tab takes its own panel out of the window.
  auto* tabs = area.findChild<QTabBar*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_EQ(tabs->count(), 2);
  emit tabs->tabBarDoubleClicked(0);
  EXPECT_TRUE(notes.isFloating());
  EXPECT_FALSE(others.isFloating());
}

TEST_F(PanelAreaTest, ALayoutOfTheSettingsComesBack) {
  enter();
  plot.close();
  area.storeLayout();
  EXPECT_EQ(settings.value(QStringLiteral("layout_panels/tune")).toStringList(),
            (QStringList{QStringLiteral("notes"), QStringLiteral("others"), QStringLiteral("plot")}));
  area.resetLayout();
  EXPECT_TRUE(plot.isVisible());
}

}  // namespace
}  // namespace tactus::workbench
