#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QUrl>
#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/features/features.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/recordings/recordings_card.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "app/workbench/workbench.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"
#include "tests/support/as_nobody.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

using tests::kNearShoulder;

class StudyFeatureTest : public testing::Test {
 protected:
  void SetUp() override {
    window.show();
    tests::makeStudyFile(path);
  }
  bool open() {
    bench.files.open(path);
    return comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); });
  }
  QAction* action(const QString& start) {
    for (QAction* menu : window.menuBar()->actions()) {
      for (QAction* one : menu->menu()->actions()) {
        if (one->text().remove(QLatin1Char('&')).startsWith(start)) return one;
      }
    }
    return nullptr;
  }
  bool stripSays(const QString& text) {
    for (const QLabel* label : window.strip().findChildren<QLabel*>()) {
      if (label->text() == text) return true;
    }
    return false;
  }

  // Does `work` and gives `answer` to every question that comes up; returns how many did.
  static int answerQuestions(QMessageBox::StandardButton answer, const std::function<void()>& work) {
    int asked = 0;
    QTimer look;
    look.setInterval(5);
    QObject::connect(&look, &QTimer::timeout, [&] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      ++asked;
      box->button(answer)->click();
    });
    look.start();
    work();
    return asked;
  }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("sample.tactus"));
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
  MainWindow& window = bench.window;
};

TEST_F(StudyFeatureTest, AStudyIsOpenedAndTakesTheModelIn) {
  EXPECT_FALSE(action("Put the open model")->isEnabled());
  ASSERT_TRUE(open());
  EXPECT_TRUE(window.banner().message().contains(QStringLiteral("holds neither a model")));
  EXPECT_EQ(bench.recent.paths().value(0), path);
  EXPECT_TRUE(action("Close the study")->isEnabled());

  bench.files.open(folder.write(tests::twoExperts()));
  EXPECT_TRUE(stripSays(QStringLiteral("Saved")));
  action("Put the open model")->trigger();
  EXPECT_TRUE(stripSays(QStringLiteral("Stored in sample.tactus")));
  EXPECT_FALSE(action("Put the open model")->isEnabled());
  EXPECT_TRUE(window.windowTitle().contains(QStringLiteral("sample.tactus")));
}

TEST_F(StudyFeatureTest, AModelOfTheAnswersIsOfferedAndNotStoredUnasked) {
  QFile::remove(path);
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    study::RuleRecord rule;
    rule.entry.id = ids.next();
    rule.entry.session = tests::addVisit(file, ids, "velvet-otter", true);
    rule.rule.conditions = {{"speed", "fast"}, {"lubrication", "poor"}};
    rule.rule.then = "large";
    ASSERT_TRUE(store::append(file, rule));
  });
  ASSERT_TRUE(open());
  EXPECT_EQ(window.stage(), Stage::kCollect);
  EXPECT_EQ(bench.models.current(), nullptr);
  QPushButton* build = nullptr;
  for (auto* button : window.banner().findChildren<QPushButton*>()) {
    if (button->isVisible() && button->text() == QStringLiteral("Build the averaged model")) build = button;
  }
  ASSERT_NE(build, nullptr) << window.banner().message().toStdString();
  build->click();
  ASSERT_TRUE(comesTrue([this] { return bench.models.current() != nullptr && !bench.study.isBusy(); }));
  EXPECT_TRUE(window.banner().message().startsWith(QStringLiteral("Built from the answers in sample.tactus")));
  EXPECT_TRUE(window.canEnter(Stage::kTune));

  // What was tuned is offered again when the model is built anew.
  fuzzy::ForceModel tuned = bench.edits.model();
  tuned.created_utc = "2025-11-21T08:00:00Z";  // of the day before, not of this second
  ASSERT_TRUE(bench.edits.apply(editing::finished(tuned, "Built earlier")));
  tuned.default_force_n = 0.125;
  ASSERT_TRUE(bench.edits.apply(editing::finished(tuned, "Another force")));
  bench.edits.snapshot(QStringLiteral("my tuned version"));
  bench.study_models.buildModel();
  const auto button = [this](const QString& text) -> QPushButton* {
    for (auto* one : window.banner().findChildren<QPushButton*>()) {
      if (one->isVisible() && one->text() == text) return one;
    }
    return nullptr;
  };
  ASSERT_TRUE(comesTrue([&] { return button(QStringLiteral("Carry them over…")) != nullptr; }));
  EXPECT_TRUE(window.banner().message().contains(QStringLiteral("1 edit of yours is in “my tuned version”")))
      << window.banner().message().toStdString();
  EXPECT_NE(button(QStringLiteral("Back to my tuned version")), nullptr);
  button(QStringLiteral("Carry them over…"))->click();
  EXPECT_TRUE(bench.carry.isActive());
  ASSERT_TRUE(comesTrue([this] { return bench.carry.rows().size() == 1 && !bench.carry.list().isBusy(); }));
  ASSERT_TRUE(bench.carry.carry());
  EXPECT_EQ(bench.edits.model().default_force_n, 0.125);
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isBusy(); }));
  bench.study.close();
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  EXPECT_EQ(store::modelVersions(tests::lookInto(path))->size(), 6U);
}

TEST_F(StudyFeatureTest, AStudyIsDroppedOnTheWindow) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &drop);
  EXPECT_TRUE(comesTrue([this] { return bench.study.isOpen(); }));
}

TEST_F(StudyFeatureTest, AFailureIsOneSentenceInTheBanner) {
  bench.files.open(folder.path(QStringLiteral("nowhere.tactus")));
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpening(); }));
  EXPECT_TRUE(window.banner().message().contains(QStringLiteral("nowhere.tactus")));
  EXPECT_FALSE(bench.study.isOpen());
}

TEST_F(StudyFeatureTest, AStudyThatMayNotBeWrittenIsShownLockedAndACopyTakesChanges) {
  ASSERT_TRUE(open());
  bench.files.open(folder.write(tests::twoExperts()));
  bench.study_models.putModel();
  bench.study.close();
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  const auto look = QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther;
  const auto enter = QFile::ExeOwner | QFile::ExeGroup | QFile::ExeOther;
  const auto write = QFile::WriteOwner | QFile::WriteGroup | QFile::WriteOther;
  const QString open_to_all = folder.path(QStringLiteral("documents"));
  ASSERT_TRUE(QDir().mkpath(open_to_all));
  ASSERT_TRUE(QFile::setPermissions(open_to_all, look | enter | write));
  ASSERT_TRUE(QFile::setPermissions(path, look));
  ASSERT_TRUE(QFile::setPermissions(folder.path({}), look | enter));
  {
    const support::AsNobody nobody;
    ASSERT_TRUE(open());
    const auto button = [](const QWidget& place, const QString& words) {
      const QList<QPushButton*> all = place.findChildren<QPushButton*>();
      const auto found = std::find_if(all.begin(), all.end(), [&](const auto* one) { return one->text() == words; });
      return found == all.end() ? nullptr : *found;
    };
    const QLabel* lock = nullptr;
    for (const QLabel* label : window.header().findChildren<QLabel*>()) {
      if (label->accessibleName() == QLatin1String("Read-only")) lock = label;
    }
    ASSERT_NE(lock, nullptr);
    EXPECT_TRUE(lock->isVisible());
    EXPECT_TRUE(lock->toolTip().contains(bench.study.readOnlyReason()));
    EXPECT_TRUE(window.windowTitle().contains(QStringLiteral("(read-only)")));
    EXPECT_TRUE(window.banner().message().contains(bench.study.readOnlyReason()));
    ASSERT_NE(button(window.banner(), QStringLiteral("Save a copy…")), nullptr);
    EXPECT_TRUE(button(window.banner(), QStringLiteral("Save a copy…"))->isVisible());
    // What would be stored is not offered, and the reason stands beside it.
    EXPECT_FALSE(action("Put the open model")->isEnabled());
    EXPECT_TRUE(action("Put the open model")->statusTip().contains(QStringLiteral("reading only")));
    EXPECT_TRUE(action("Save a copy of the study")->isEnabled());
    for (const QPushButton* one : window.findChild<StudyHome*>()->findChildren<QPushButton*>()) {
      if (!one->text().contains(QLatin1String("usability"))) continue;
      // Collect reads the study for itself.
      EXPECT_TRUE(comesTrue([&] { return one->toolTip().contains(bench.study.readOnlyReason()); }))
          << one->toolTip().toStdString();
      EXPECT_FALSE(one->isEnabled());
    }
    const auto* recordings = window.findChild<RecordingsCard*>();
    EXPECT_FALSE(button(*recordings, QStringLiteral("Record"))->isEnabled());
    const QList<QLabel*> said = recordings->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(said.begin(), said.end(),
                            [](const QLabel* label) { return label->text().contains(QLatin1String("reading only")); }));
    // Why the force is what it is can be read all the same.
    window.enter(Stage::kUnderstand);
    bench.scene.goTo({0, 0});
    ASSERT_TRUE(comesTrue([this] { return !window.findChild<WhyView*>()->words().empty(); }));

    const QString copy = open_to_all + QStringLiteral("/copy.tactus");
    bench.study.saveCopy(copy);
    ASSERT_TRUE(comesTrue([&] { return bench.study.isOpen() && bench.study.path() == copy; }));
    EXPECT_FALSE(bench.study.isReadOnly());
    EXPECT_FALSE(lock->isVisible());
    bench.study.close();
    ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  }
  ASSERT_TRUE(QFile::setPermissions(folder.path({}), look | enter | QFile::WriteOwner));
}

TEST_F(StudyFeatureTest, ALockedStudyWithoutAModelOffersItsCopyAndSaysWhatItHolds) {
  const auto look = QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther;
  const auto enter = QFile::ExeOwner | QFile::ExeGroup | QFile::ExeOther;
  ASSERT_TRUE(QFile::setPermissions(path, look));
  ASSERT_TRUE(QFile::setPermissions(folder.path({}), look | enter));
  {
    const support::AsNobody nobody;
    ASSERT_TRUE(open());
    const QString said = window.banner().message();
    EXPECT_TRUE(said.contains(bench.study.readOnlyReason())) << said.toStdString();
    EXPECT_TRUE(said.contains(QStringLiteral("sample.tactus holds "))) << said.toStdString();
    QStringList acts;
    for (const QPushButton* one : window.banner().findChildren<QPushButton*>()) {
      if (one->isVisible()) acts << one->text();
    }
    EXPECT_TRUE(acts.contains(QStringLiteral("Save a copy…"))) << acts.join(QLatin1Char('|')).toStdString();
    bench.study.close();
    ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  }
  ASSERT_TRUE(QFile::setPermissions(folder.path({}), look | enter | QFile::WriteOwner));
}

TEST_F(StudyFeatureTest, TheWindowStaysUntilEverythingIsWritten) {
  ASSERT_TRUE(open());
  bench.files.open(folder.write(tests::twoExperts()));
  bench.study_models.putModel();
  ASSERT_TRUE(bench.edits.apply(editing::moveVertex(bench.edits.model(), kNearShoulder, 2)));
  window.close();
  ASSERT_TRUE(comesTrue([this] { return !window.isVisible(); }));
  EXPECT_FALSE(bench.study.isBusy());
  bench.study.close();
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  EXPECT_EQ(store::modelVersions(tests::lookInto(path))->size(), 2U);
}

TEST_F(StudyFeatureTest, AWindowThatIsKeptOpenIsNotClosedByTheNextWrite) {
  ASSERT_TRUE(open());
  bench.files.open(folder.write(tests::twoExperts()));
  // In a file of its own, beside the study.
  ASSERT_TRUE(bench.edits.apply(editing::moveVertex(bench.edits.model(), kNearShoulder, 2)));
  int asked = 0;
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!question) return;
    ++asked;
    question->button(QMessageBox::Cancel)->click();
  });
  answer.start(10);
  const auto write = [this] {
    bench.study.order([](store::StudyFile&, study::RecordIds&) { return base::Result<void>(); });
  };
  write();
  window.close();
  ASSERT_TRUE(comesTrue([&] { return asked == 1; }));
  EXPECT_TRUE(window.isVisible());
  write();
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isBusy(); }));
  QCoreApplication::processEvents();
  EXPECT_EQ(asked, 1);
}

TEST_F(StudyFeatureTest, ChangesThatAreNotSavedAreAskedFor) {
  ASSERT_TRUE(open());
  bench.files.open(folder.write(tests::twoExperts()));
  bench.study_models.putModel();
  bench.files.open(folder.write(tests::twoExperts(), QStringLiteral("beside.tactus.json")));
  ASSERT_TRUE(bench.edits.apply(editing::moveVertex(bench.edits.model(), kNearShoulder, 2)));
  ASSERT_TRUE(bench.models.isModified());
  for (const char* start : {"Show the study", "Build the averaged"}) {
    const int asked = answerQuestions(QMessageBox::Cancel, [&] { action(QLatin1String(start))->trigger(); });
    EXPECT_EQ(asked, 1) << start;
    EXPECT_FALSE(bench.study.isOpening()) << start;
  }
  EXPECT_TRUE(bench.models.isModified());
}

TEST_F(StudyFeatureTest, TheRecordingsStandInTheFeelPanel) {
  auto* card = window.findChild<RecordingsCard*>();
  ASSERT_NE(card, nullptr);
  const auto shown = [&](const auto* widget) { return widget->isVisibleTo(card); };
  EXPECT_FALSE(shown(card->findChild<QComboBox*>()));
  ASSERT_TRUE(open());
  ASSERT_TRUE(comesTrue([&] { return shown(card->findChild<QComboBox*>()); }));
  EXPECT_EQ(card->findChild<QComboBox*>()->itemText(0), QStringLiteral("Researcher"));
  for (const QPushButton* button : card->findChildren<QPushButton*>()) {
    if (!shown(button)) continue;
    EXPECT_EQ(button->isEnabled(), button->text() == QStringLiteral("Record")) << button->text().toStdString();
  }
}

TEST_F(StudyFeatureTest, WhichStudyIsOpenIsSaidWhereItMatters) {
  EXPECT_FALSE(window.windowTitle().contains(QStringLiteral("sample.tactus")));
  ASSERT_TRUE(open());
  EXPECT_TRUE(window.windowTitle().contains(QStringLiteral("study sample.tactus")))
      << window.windowTitle().toStdString();
  const auto says = [](const QWidget& part, const QString& words) {
    const auto labels = part.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->isVisibleTo(&part) && label->text() == words; });
  };
  EXPECT_TRUE(says(*window.findChild<RecordingsCard*>(), QStringLiteral("Into the study sample.tactus")));
  auto* header = window.findChild<ModelHeader*>();
  ASSERT_NE(header, nullptr);
  const auto labels = header->findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return !label->isHidden() && label->toolTip().startsWith(QStringLiteral("The study that is open"));
  }));
  bench.study.close();
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  EXPECT_FALSE(window.windowTitle().contains(QStringLiteral("sample.tactus")));
}

// Stopped, a recording waits for Start, and says so on the button and on the pad.
TEST_F(StudyFeatureTest, RecordWhileStoppedSaysThatItIsArmed) {
  bench.models.open(folder.write(tests::twoExperts()));
  ASSERT_TRUE(open());
  window.enter(Stage::kTune);
  auto* card = window.findChild<RecordingsCard*>();
  auto* pad = window.findChild<TubePad*>();
  ASSERT_NE(pad, nullptr);
  QPushButton* record = nullptr;
  for (auto* button : card->findChildren<QPushButton*>()) {
    if (button->text() == QStringLiteral("Record")) record = button;
  }
  ASSERT_NE(record, nullptr);
  ASSERT_TRUE(comesTrue([&] { return record->isEnabled(); }));
  EXPECT_TRUE(record->icon().isNull());
  record->click();
  EXPECT_EQ(record->text(), QStringLiteral("Armed"));
  EXPECT_FALSE(record->icon().isNull());
  EXPECT_TRUE(record->toolTip().contains(QStringLiteral("begins with Start")));
  EXPECT_EQ(pad->toolTip(), QStringLiteral("Armed: the recording begins with Start."));
  record->click();
  EXPECT_EQ(record->text(), QStringLiteral("Record"));
  EXPECT_NE(pad->toolTip(), QStringLiteral("Armed: the recording begins with Start."));
}

}  // namespace
}  // namespace tactus::workbench
