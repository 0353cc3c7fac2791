#include "app/workbench/shell/main_window.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFile>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QUrl>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/start_view.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/curves/reading_model.h"
#include "app/workbench/workbench.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

class MainWindowTest : public testing::Test {
 protected:
  void SetUp() override {
    window.resize(1280, 720);
    window.show();
    QCoreApplication::processEvents();
  }

  void openSample() {
    bench.models.open(folder.write(tests::twoExperts()));
    QCoreApplication::processEvents();
  }

  template <class Widget>
  Widget* ofVariable(const QString& label) {
    const QList<Widget*> all = window.findChildren<Widget*>();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Widget* w) { return w->accessibleName() == label; });
    return found == all.end() ? nullptr : *found;
  }

  StartEntry* startEntry(const QString& name) {
    for (auto* entry : window.findChild<StartView*>()->findChildren<StartEntry*>()) {
      if (entry->text() == name) return entry;
    }
    return nullptr;
  }

  QImage curves() {
    tests::settle(window);
    return window.findChild<CurvePlot*>()->grab().toImage();
  }

  bool drop(const QUrl& url) {
    QMimeData data;
    data.setUrls({url});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QCoreApplication::sendEvent(&window, &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &drop);
    QCoreApplication::processEvents();
    return true;
  }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
  MainWindow& window = bench.window;
};

TEST_F(MainWindowTest, StartsFriendlyAndEmpty) {
  EXPECT_TRUE(window.findChild<StartView*>()->isVisible());
  EXPECT_FALSE(window.findChild<BenchView*>()->isVisible());
  EXPECT_FALSE(window.findChild<MessageBanner*>()->isVisible());
}

TEST_F(MainWindowTest, ShowsAModelAndRemembersItsFile) {
  openSample();
  EXPECT_TRUE(window.findChild<BenchView*>()->isVisible());
  EXPECT_EQ(window.windowTitle(), QStringLiteral("Two experts – sample.tactus.json[*]"));
  EXPECT_EQ(bench.recent.paths(), QStringList{folder.path(QStringLiteral("sample.tactus.json"))});
}

TEST_F(MainWindowTest, ARecentFileOpensWithAClick) {
  bench.recent.add(folder.write(tests::twoExperts()));
  StartEntry* entry = startEntry(QStringLiteral("sample.tactus.json"));
  ASSERT_NE(entry, nullptr);
  QTest::mouseClick(entry, Qt::LeftButton);
  QCoreApplication::processEvents();
  EXPECT_TRUE(window.findChild<BenchView*>()->isVisible());
}

TEST_F(MainWindowTest, TheSliderMovesTheCurves) {
  openSample();
  const QImage before = curves();
  auto* slider = ofVariable<QSlider>(QStringLiteral("Speed"));
  ASSERT_NE(slider, nullptr);
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(bench.scene.value(0), 51);
  EXPECT_NE(curves(), before);
  QTest::keyClick(slider, Qt::Key_Left);
  EXPECT_EQ(curves(), before);
}

TEST_F(MainWindowTest, AnExactValueCanBeTyped) {
  openSample();
  auto* number = ofVariable<QDoubleSpinBox>(QStringLiteral("Speed"));
  ASSERT_NE(number, nullptr);
  number->selectAll();
  QTest::keyClicks(number, QStringLiteral("12.34"));
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(bench.scene.value(0), 12.34);
  EXPECT_EQ(number->text(), QStringLiteral("12.34 mm/s"));
  EXPECT_EQ(ofVariable<QSlider>(QStringLiteral("Speed"))->value(), 12);
}

TEST_F(MainWindowTest, UndoBelongsToTheModelUnlessSomebodyTypes) {
  openSample();
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune}) {
    window.enter(stage);
    QCoreApplication::processEvents();
    for (QWidget* field : window.findChildren<QWidget*>()) {
      const bool is_field = qobject_cast<QAbstractSpinBox*>(field) || qobject_cast<QLineEdit*>(field);
      if (!is_field || !field->isVisible() || !field->isEnabled() || field->focusPolicy() == Qt::NoFocus) continue;
      const fuzzy::ForceModel before = bench.edits.model();
      ASSERT_TRUE(bench.edits.apply(editing::moveVertex(before, {{"depth", ""}, "near", 2}, 3)));
      field->setFocus();
      QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
      EXPECT_EQ(bench.edits.model(), before) << field->accessibleName().toStdString();
      QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
      EXPECT_NE(bench.edits.model(), before) << field->accessibleName().toStdString();
      bench.edits.undo();
    }
  }
  // What is being typed is taken back before the model is.
  auto* number = ofVariable<QDoubleSpinBox>(QStringLiteral("Speed of the operating point"));
  ASSERT_NE(number, nullptr);
  const QString shown = number->text();
  ASSERT_TRUE(bench.edits.apply(editing::moveVertex(bench.edits.model(), {{"depth", ""}, "near", 2}, 3)));
  const fuzzy::ForceModel edited = bench.edits.model();
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, QStringLiteral("7"));
  QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(bench.edits.model(), edited);
  EXPECT_EQ(number->text(), shown);
  QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(bench.edits.model(), edited);
}

TEST_F(MainWindowTest, ClosingTheWindowEndsTheForce) {
  openSample();
  bench.feel.start(QStringLiteral("virtual"));
  ASSERT_TRUE(bench.feel.isRunning());
  window.close();
  EXPECT_FALSE(bench.feel.isRunning());
}

TEST_F(MainWindowTest, ALongNameOfAStudyLeavesRoomInTheStrip) {
  openSample();
  const QString name = QStringLiteral("the-study-of-nasogastric-tube-placement-with-a-very-long-name.tactus");
  window.strip().showStored(QStringLiteral("Stored in ") + name, false);
  const QList<QLabel*> labels = window.strip().findChildren<QLabel*>();
  const auto saved = std::find_if(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text().startsWith(QLatin1String("Stored"));
  });
  ASSERT_NE(saved, labels.end());
  EXPECT_LT((*saved)->fontMetrics().horizontalAdvance((*saved)->text()), window.width() / 4);
  EXPECT_TRUE((*saved)->text().endsWith(QLatin1String("name.tactus")));
  EXPECT_TRUE((*saved)->toolTip().contains(name));
}

TEST_F(MainWindowTest, TheMouseReadsTheCurves) {
  openSample();
  auto* plot = window.findChild<CurvePlot*>();
  emit plot->hovered(8);
  const auto* readings = bench.features.findChild<ReadingModel*>();
  const auto force = [readings](int row) { return readings->index(row, ReadingModel::kForce).data().toString(); };
  EXPECT_EQ(force(ReadingModel::kMeanRow), QStringLiteral("0.500 N"));
  EXPECT_EQ(force(1), QStringLiteral("0.750 N"));
  EXPECT_EQ(force(2), QStringLiteral("0.250 N"));
  emit plot->hovered(2);
  EXPECT_EQ(force(2), QStringLiteral("no rule fires"));
}

TEST_F(MainWindowTest, ALineCanBeHidden) {
  openSample();
  const QImage before = curves();
  auto* readings = bench.features.findChild<ReadingModel*>();
  ASSERT_TRUE(readings->setData(readings->index(1, ReadingModel::kWho), Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_NE(curves(), before);
}

TEST_F(MainWindowTest, ABrokenFileGivesASentenceAndKeepsTheModel) {
  openSample();
  bench.models.open(folder.path(QStringLiteral("missing.json")));
  const auto* banner = window.findChild<MessageBanner*>();
  EXPECT_TRUE(banner->isVisible());
  EXPECT_TRUE(banner->message().contains(QStringLiteral("missing.json")));
  EXPECT_TRUE(window.findChild<BenchView*>()->isVisible());
  openSample();
  EXPECT_FALSE(banner->isVisible());
}

TEST_F(MainWindowTest, SimulatedDataAreLabelled) {
  const auto badge_visible = [this] {
    const QList<QLabel*> labels = window.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text() == QStringLiteral("Contains simulated data");
    });
  };
  openSample();
  EXPECT_FALSE(badge_visible());
  fuzzy::ForceModel model = tests::twoExperts();
  model.provenance = fuzzy::Provenance{"", {}, {}, "All answers are simulated."};
  bench.models.open(folder.write(model, QStringLiteral("simulated.json")));
  EXPECT_TRUE(badge_visible());
}

TEST_F(MainWindowTest, AModelFileCanBeDropped) {
  EXPECT_TRUE(drop(QUrl::fromLocalFile(folder.write(tests::twoExperts()))));
  EXPECT_NE(bench.models.current(), nullptr);
  EXPECT_FALSE(drop(QUrl::fromLocalFile(folder.path(QStringLiteral("picture.png")))));
  EXPECT_FALSE(drop(QUrl(QStringLiteral("https://example.org/model.json"))));
}

// A panel that was closed by chance is one click away, in its place.
TEST_F(MainWindowTest, AClosedPanelOffersItselfAgain) {
  openSample();
  window.enter(Stage::kTune);
  Panel& curves = *bench.panels.curves;
  ASSERT_TRUE(curves.isVisible());
  curves.close();
  EXPECT_EQ(window.banner().message(),
            QStringLiteral("The panel Force curves is closed and stays closed in this stage."));
  for (QPushButton* const button : window.banner().findChildren<QPushButton*>()) {
    if (button->text() == QStringLiteral("Show it again")) button->click();
  }
  EXPECT_TRUE(curves.isVisible());
}

const QByteArray kOther =
    "Engine: pump\nInputVariable: depth\n  range: 0 10\n  term: low Ramp 10 0\n  term: odd Bell 5 2 3\n"
    "InputVariable: speed\n  range: 0 10\n  term: low Ramp 10 0\n"
    "OutputVariable: force\n  range: 0 8\n  aggregation: Maximum\n  defuzzifier: Centroid 100\n"
    "  term: small Triangle 1 2 3\nRuleBlock:\n  implication: Minimum\n  rule: if depth is low then force is small\n";

TEST_F(MainWindowTest, AModelOfAnotherProgramIsOpenedWithoutAFile) {
  const QString path = folder.writeText(kOther, QStringLiteral("pump.fll"));
  EXPECT_TRUE(drop(QUrl::fromLocalFile(path)));
  ASSERT_NE(bench.models.current(), nullptr);
  EXPECT_EQ(bench.models.current()->model.name, "pump");
  EXPECT_EQ(bench.models.current()->path, folder.path(QStringLiteral("pump.tactus.json")));
  EXPECT_TRUE(bench.models.isModified());
  EXPECT_FALSE(QFile::exists(bench.models.current()->path));
  // The first sentence is in the banner; all of them stay in the menu, after edits and after saving too.
  EXPECT_TRUE(window.banner().message().contains(QStringLiteral("pump.fll: line 5, column 9: term 'odd' of 'depth'")))
      << window.banner().message().toStdString();
  EXPECT_TRUE(window.banner().message().contains(QStringLiteral("lists 1 more")));
  const auto named = [this](const char* start) {
    for (QAction* action : window.findChildren<QAction*>()) {
      if (action->text().remove(QLatin1Char('&')).startsWith(QLatin1String(start))) return action;
    }
    return static_cast<QAction*>(nullptr);
  };
  EXPECT_FALSE(named("Reopen")->isEnabled());
  bench.models.saveAs(folder.path(QStringLiteral("mine.tactus.json")));
  EXPECT_FALSE(bench.models.isModified());
  EXPECT_TRUE(named("Reopen")->isEnabled());
  EXPECT_TRUE(named("Show the notes of the file")->isEnabled());
  EXPECT_EQ(bench.models.current()->warnings.size(), 2);
}

TEST_F(MainWindowTest, AModelThatCannotBeImportedLeavesTheOpenOne) {
  openSample();
  QByteArray hedged = kOther;
  hedged.replace("is low then", "is very low then");
  bench.files.open(folder.writeText(hedged, QStringLiteral("hedged.txt")));
  EXPECT_EQ(window.banner().message(),
            QStringLiteral("hedged.txt: line 16, column 21: found the hedge 'very', wanted terms without hedges, which "
                           "Tactus lacks"));
  EXPECT_NE(bench.models.current()->model.name, "pump");
}

TEST_F(MainWindowTest, OneOfSeveralOutputsIsAskedFor) {
  QByteArray two = kOther;
  two.replace("RuleBlock:", "OutputVariable: heat\n  range: 0 1\n  term: some Triangle 0 1 2\nRuleBlock:");
  const QString path = folder.writeText(two, QStringLiteral("two.fll"));
  QTimer::singleShot(0, &window, [] {
    auto* question = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(question, nullptr);
    EXPECT_EQ(question->comboBoxItems(), QStringList({QStringLiteral("force"), QStringLiteral("heat")}));
    question->accept();
  });
  bench.files.open(path);
  ASSERT_NE(bench.models.current(), nullptr);
  EXPECT_EQ(bench.models.current()->model.output.id, "force");
}

TEST_F(MainWindowTest, AFileThatIsDroppedOnAFieldIsOpened) {
  openSample();
  auto* field = ofVariable<QDoubleSpinBox>(QStringLiteral("Speed of the operating point"))->findChild<QLineEdit*>();
  const QString shown = field->text();
  fuzzy::ForceModel other = tests::twoExperts();
  other.name = "Dropped";
  const QUrl url = QUrl::fromLocalFile(folder.write(other, QStringLiteral("dropped.tactus.json")));
  QMimeData data;
  data.setUrls({url});
  data.setText(url.toLocalFile());  // as file managers give it too
  QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QCoreApplication::sendEvent(field, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(field, &drop);
  QCoreApplication::processEvents();
  EXPECT_EQ(bench.models.current()->model.name, "Dropped");
  EXPECT_EQ(ofVariable<QDoubleSpinBox>(QStringLiteral("Speed of the operating point"))->text(), shown);
}

TEST_F(MainWindowTest, SavesPicturesByTheirEnding) {
  openSample();
  const QImage before = curves();
  const std::pair<const char*, const char*> kinds[] = {{"a.png", "\x89PNG"}, {"a.svg", "<?xml"}, {"a.pdf", "%PDF"}};
  for (const auto& [name, start] : kinds) {
    ASSERT_TRUE(bench.views.curves->plotMenu().savePicture(folder.path(QString::fromLatin1(name))));
    QFile file(folder.path(QString::fromLatin1(name)));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().startsWith(start)) << name;
  }
  const auto refused = bench.views.curves->plotMenu().savePicture(folder.path(QStringLiteral("a.bmp")));
  ASSERT_FALSE(refused);
  EXPECT_FALSE(QFile::exists(folder.path(QStringLiteral("a.bmp"))));
  // The caption of the picture leaves no trace in the window.
  EXPECT_EQ(curves(), before);
}

TEST_F(MainWindowTest, TheLookChangesAtOnce) {
  openSample();
  const QImage light = curves();
  const auto choose = [this](const QString& name) {
    for (QAction* action : window.findChildren<QAction*>()) {
      if (action->text() == name) action->trigger();
    }
  };
  const QList<QLabel*> labels = window.strip().findChildren<QLabel*>();
  const QLabel* head = *std::find_if(labels.begin(), labels.end(),
                                     [](const QLabel* label) { return label->text() == QStringLiteral("Speed"); });
  const QColor muted = head->palette().color(QPalette::WindowText);
  choose(QStringLiteral("&Dark"));
  EXPECT_TRUE(theme::isDark());
  const QImage dark = curves();
  EXPECT_EQ(dark.pixelColor(1, 1), theme::card());
  EXPECT_NE(light.pixelColor(1, 1), theme::card());
  EXPECT_EQ(head->palette().color(QPalette::WindowText), theme::mutedInk());
  choose(QStringLiteral("&Light"));
  EXPECT_EQ(head->palette().color(QPalette::WindowText), muted);
  EXPECT_EQ(curves(), light);
}

TEST_F(MainWindowTest, AnotherInputCanBeTheAxis) {
  openSample();
  const QImage before = curves();
  bench.scene.setXInput(0);
  EXPECT_NE(curves(), before);
}

}  // namespace
}  // namespace tactus::workbench
