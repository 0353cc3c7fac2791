// Stages Build and Collect and the dialogs of the window, with the demo's study: at no size of the text is anything cut
// in a window of 1280 x 720 px, and what can be pressed says what it does.
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/collect/protocol_view.h"
#include "app/workbench/collect/withdrawal_dialog.h"
#include "app/workbench/deliver/link/link_dialog.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/shell/command_search.h"
#include "app/workbench/shell/menus.h"
#include "app/workbench/workbench.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"
#include "tests/gui/shown_bench.h"
#include "tests/gui/verb_check.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class LabTexts : public testing::Test {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
    bench.files.open(path);
    ASSERT_TRUE(comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); }));
    ASSERT_TRUE(comesTrue([this] { return bench.collect.isCurrent(); }));
    bench.window.banner().hide();
  }
  void TearDown() override { appearance::changeTextSize(*qApp, 100); }

  LabScreen& screen() { return *bench.views.labs; }
  static void expectNone(const QString& where, const QStringList& found) {
    EXPECT_TRUE(found.isEmpty()) << where.toStdString() << ":\n  " << found.join(QStringLiteral("\n  ")).toStdString();
  }
  static void expectWhole(const QString& where, QWidget& window) {
    tests::settle(window);
    const QByteArray pictures = qgetenv("TACTUS_PICTURES");
    if (!pictures.isEmpty()) {
      EXPECT_TRUE(
          window.grab().save(QString::fromLocal8Bit(pictures) + QLatin1Char('/') + where + QStringLiteral(".png")));
    }
    expectNone(where, tests::cutTexts(window));
  }
  /// Each lab and each page inside it comes to the front, complete.
  template <class Look>
  void showLabs(Look look) {
    bench.window.enter(Stage::kBuild);
    bench.views.depth->showExample();
    for (QWidget* const lab : screen().labs()) {
      screen().reveal(lab);
      auto* const pages = lab->findChild<QTabWidget*>();
      for (int page = 0; page < (pages == nullptr ? 1 : pages->count()); ++page) {
        if (pages != nullptr) pages->setCurrentIndex(page);
        ASSERT_TRUE(comesTrue([this] { return !screen().isBusy(); }));
        const QString name = pages == nullptr ? QString() : QLatin1Char('-') + pages->widget(page)->objectName();
        look(lab->objectName() + name);
      }
      if (pages != nullptr) pages->setCurrentIndex(0);
    }
  }
  template <class Look>
  void showCollect(Look look) {
    constexpr int kSections = 6;
    CollectView& view = *bench.views.collect;
    bench.window.enter(Stage::kCollect);
    view.showHome();
    look(QStringLiteral("collect"));
    view.showProtocol();
    for (int section = 0; section < kSections; ++section) {
      view.protocolPage().showSection(section);
      look(QStringLiteral("protocol-%1").arg(section));
    }
    view.showHome();
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.filePath(QStringLiteral("autosave"))};
};

TEST_F(LabTexts, NothingIsCutInTheLabsAtAnySize) {
  for (const int percent : appearance::kTextSizes) {
    appearance::changeTextSize(*qApp, percent);
    showLabs([&](const QString& lab) { expectWhole(QStringLiteral("%1-%2").arg(lab).arg(percent), bench.window); });
    ASSERT_EQ(bench.window.size(), QSize(1280, 720)) << percent;
  }
}

TEST_F(LabTexts, NothingIsCutInCollectAndItsDialogAtAnySize) {
  for (const int percent : appearance::kTextSizes) {
    appearance::changeTextSize(*qApp, percent);
    showCollect(
        [&](const QString& page) { expectWhole(QStringLiteral("%1-%2").arg(page).arg(percent), bench.window); });
    ASSERT_EQ(bench.window.size(), QSize(1280, 720)) << percent;
    WithdrawalDialog dialog(bench.collect, bench.collect.overview().rows.at(0).person, &bench.window);
    dialog.show();
    ASSERT_TRUE(comesTrue([&dialog] { return dialog.isCounted(); }));
    expectWhole(QStringLiteral("withdrawal-%1").arg(percent), dialog);
  }
}

TEST_F(LabTexts, NothingIsCutInTheDialogsAtAnySize) {
  for (const int percent : appearance::kTextSizes) {
    appearance::changeTextSize(*qApp, percent);
    bench.views.link->bringUp();
    expectWhole(QStringLiteral("link-%1").arg(percent), *bench.views.link);
    bench.views.link->hide();
    ShortcutSheet keys(*bench.window.menuBar(), &bench.window);
    keys.show();
    expectWhole(QStringLiteral("keys-%1").arg(percent), keys);
  }
}

TEST_F(LabTexts, LabsAndCollectSayWhatTheirButtonsDo) {
  const auto look = [this](const QString& where) {
    tests::settle(bench.window);
    QWidget& part = *bench.window.centralWidget();
    expectNone(where, tests::buttonsWithoutVerb(part));
    expectNone(where, tests::hintsWithoutVerb(part));
  };
  showLabs(look);
  showCollect(look);
}

}  // namespace
}  // namespace tactus::workbench
