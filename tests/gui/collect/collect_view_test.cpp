// Stage Collect in the window: its ways in and out, the keyboard, and what must never happen by accident.
#include "app/workbench/collect/collect_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/session/study_protocol.h"
#include "app/workbench/collect/monitor_window.h"
#include "app/workbench/collect/protocol_view.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/collect/withdrawal_dialog.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/session/take_part.h"
#include "app/workbench/shell/start_view.h"
#include "app/workbench/workbench.h"
#include "core/store/persons.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"
#include "tests/gui/shown_bench.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class CollectViewTest : public testing::Test {
 protected:
  void SetUp() override {
    window.resize(1280, 720);
    window.show();
  }
  void openStudy(const std::function<void(store::StudyFile&, study::RecordIds&)>& fill = {}) {
    tests::makeStudyFile(path, fill);
    bench.files.open(path);
    ASSERT_TRUE(comesTrue(
        [this] { return window.stage() == Stage::kCollect && collect().isCurrent() && bench.protocol.isReady(); }));
  }
  CollectController& collect() { return bench.collect; }
  StudyHome& home() { return bench.views.collect->home(); }
  template <class Button = QPushButton>
  Button* button(QWidget& in, const char* text) {
    for (Button* each : in.findChildren<Button*>()) {
      if (each->isVisible() && each->text().remove(QLatin1Char('&')) == QString::fromUtf8(text)) return each;
    }
    return nullptr;
  }
  bool canEnter(Stage stage) { return window.canEnter(stage); }

  tests::ModelFolder folder;
  tests::SteppedFeel time;
  QString path = folder.path(QStringLiteral("ward.tactus"));
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave")), time.settings()};
  MainWindow& window = bench.window;
};

TEST_F(CollectViewTest, AStudyWithoutAModelLeadsHereAndBackToTheStart) {
  EXPECT_FALSE(canEnter(Stage::kCollect));
  openStudy();
  EXPECT_TRUE(home().isVisible());
  EXPECT_TRUE(canEnter(Stage::kCollect));
  EXPECT_FALSE(canEnter(Stage::kTune));
  EXPECT_TRUE(button(home(), "Add the first participant"));
  bench.study.close();
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  EXPECT_TRUE(window.findChild<StartView*>()->isVisible());
  EXPECT_FALSE(window.stage());
}

TEST_F(CollectViewTest, AModelBesideTheStudyOpensItsStagesAndKeepsThemWithoutIt) {
  openStudy();
  bench.files.open(folder.write(tests::twoExperts()));
  EXPECT_TRUE(canEnter(Stage::kTune));
  EXPECT_EQ(window.stage(), Stage::kCollect);
  bench.study.close();
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  EXPECT_EQ(window.stage(), Stage::kTune);
  EXPECT_FALSE(canEnter(Stage::kCollect));
}

TEST_F(CollectViewTest, AStudyThatCannotBeOpenedIsASentenceAndTheStartStays) {
  QFile damaged(path);
  ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
  damaged.write("no study");
  damaged.close();
  bench.files.open(path);
  ASSERT_TRUE(comesTrue([this] { return window.banner().isVisible(); }));
  EXPECT_TRUE(window.banner().message().contains(QStringLiteral("ward.tactus")));
  EXPECT_TRUE(window.findChild<StartView*>()->isVisible());

  const QString other = folder.path(QStringLiteral("other.tactus"));
  tests::makeStudyFile(other);
  const auto held = store::StudyFile::open(other.toStdString());
  ASSERT_TRUE(held);
  bench.files.open(other);
  ASSERT_TRUE(comesTrue([this] { return window.banner().message().contains(QStringLiteral("other.tactus")); }));
  EXPECT_FALSE(bench.study.isOpen());
}

TEST_F(CollectViewTest, ParticipantsAreAddedAndChosenWithTheKeyboard) {
  openStudy();
  auto* add = button(home(), "Add participant");
  ASSERT_NE(add, nullptr);
  add->setFocus();
  QTest::keyClick(add, Qt::Key_Space);
  auto* table = home().findChild<QTableView*>();
  ASSERT_TRUE(comesTrue([&] { return table->isVisible() && table->model()->rowCount() == 1; }));
  ASSERT_TRUE(comesTrue([this] { return home().selected().has_value(); }));
  const QString code = collect().overview().rows.front().code;
  EXPECT_NE(button<PrimaryButton>(home(), ("Start with " + code.toStdString()).c_str()), nullptr);
  // The code is said until the researcher has written it down.
  const auto labels = home().findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
    return label->isVisible() &&
           label->text().contains(QStringLiteral("The new participant has the code %1").arg(code));
  }));
}

TEST_F(CollectViewTest, AWithdrawalNeedsTheCodeTyped) {
  openStudy([](store::StudyFile& file, study::RecordIds& ids) {
    ASSERT_TRUE(store::append(file, study::Person{ids.next(), "amber-crow", false}));
    ASSERT_TRUE(store::append(file, study::Person{ids.next(), "blue-fox", false}));
  });
  ASSERT_TRUE(comesTrue([this] { return collect().overview().rows.size() == 2; }));
  home().select(collect().overview().rows.front().person);
  QTest::mouseClick(button(home(), "Withdraw…"), Qt::LeftButton);
  auto* dialog = window.findChild<WithdrawalDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(comesTrue([&] { return dialog->isCounted(); }));
  auto* withdraw = button(*dialog, "Withdraw and delete");
  EXPECT_FALSE(withdraw->isEnabled());
  auto* typed = dialog->findChild<QLineEdit*>();
  QTest::keyClicks(typed, QStringLiteral("blue-fox"));
  EXPECT_FALSE(withdraw->isEnabled());
  typed->clear();
  QTest::keyClicks(typed, QStringLiteral("Amber Crow"));
  ASSERT_TRUE(withdraw->isEnabled());
  QTest::mouseClick(withdraw, Qt::LeftButton);
  ASSERT_TRUE(comesTrue([this] { return collect().overview().rows.size() == 1; }));
  EXPECT_TRUE(window.banner().message().contains(QStringLiteral("amber-crow")));
}

TEST_F(CollectViewTest, TheProtocolIsStoredFromItsPage) {
  openStudy();
  QTest::mouseClick(button(home(), "Open the protocol…"), Qt::LeftButton);
  ProtocolView& page = bench.views.collect->protocolPage();
  ASSERT_TRUE(page.isVisible());
  auto* store = button<PrimaryButton>(page, "Store");
  ASSERT_NE(store, nullptr);
  EXPECT_FALSE(store->isEnabled());  // there is no consent text yet
  bench.protocol.set("consent.en", QStringLiteral("Please read."));
  ASSERT_TRUE(store->isEnabled());
  QTest::mouseClick(store, Qt::LeftButton);
  ASSERT_TRUE(comesTrue([this] { return bench.protocol.version() == 1; }));
  EXPECT_FALSE(store->isEnabled());
  QTest::mouseClick(button(page, "‹ Participants"), Qt::LeftButton);
  EXPECT_TRUE(home().isVisible());
  EXPECT_TRUE(comesTrue([this] { return collect().overview().protocol.version == 1; }));
}

TEST_F(CollectViewTest, ThePartsOfTheProtocolAreLeftOutAndMovedWithTheKeyboard) {
  openStudy();
  ProtocolController& protocol = bench.protocol;
  bench.views.collect->showProtocol();
  const auto arrow = [this](const char* name) {
    for (auto* each : bench.views.collect->protocolPage().findChildren<QToolButton*>()) {
      if (each->accessibleName() == QString::fromLatin1(name)) return each;
    }
    return static_cast<QToolButton*>(nullptr);
  };
  ASSERT_NE(arrow("Move earlier: Questions: the force in each situation"), nullptr);
  EXPECT_FALSE(arrow("Move earlier: Speed: insertions at a named speed")->isEnabled());
  EXPECT_FALSE(arrow("Move later: Questions: the force in each situation")->isEnabled());
  arrow("Move earlier: Questions: the force in each situation")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_EQ(protocol.value("blocks"), QStringLiteral("speed,form,force"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_EQ(protocol.value("blocks"), QStringLiteral("form,speed,force"));
  // It cannot come earlier; Space leaves it out, and again puts it where the published experiment has it.
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_EQ(protocol.value("blocks"), QStringLiteral("speed,force"));
  QTest::mouseClick(button<QCheckBox>(*bench.views.collect, "Questions: the force in each situation"), Qt::LeftButton);
  EXPECT_EQ(protocol.value("blocks"), QStringLiteral("speed,force,form"));
}

TEST_F(CollectViewTest, WithoutATextOfTheStudyNoPersonSitsDownAndTheProtocolIsOneClickAway) {
  openStudy([](store::StudyFile& file, study::RecordIds& ids) {
    ASSERT_TRUE(store::append(file, study::Person{ids.next(), "amber-crow", false}));
  });
  ASSERT_TRUE(comesTrue([this] { return collect().overview().rows.size() == 1; }));
  home().select(collect().overview().rows.front().person);
  QTest::mouseClick(button<PrimaryButton>(home(), "Start with amber-crow"), Qt::LeftButton);
  ASSERT_TRUE(comesTrue([this] { return window.banner().message().contains(QStringLiteral("no protocol")); }));
  EXPECT_EQ(bench.run.takePart(), nullptr);
  EXPECT_TRUE(window.isVisible());
  QTest::mouseClick(button(window.banner(), "Edit the protocol"), Qt::LeftButton);
  EXPECT_TRUE(bench.views.collect->protocolPage().isVisible());
}

/// A person, and what a session needs of a protocol.
void readyForASession(store::StudyFile& file, study::RecordIds& ids) {
  ASSERT_TRUE(store::append(file, study::Person{ids.next(), "amber-crow", false}));
  session::StudyProtocol protocol;
  protocol.consent_version = "1";
  protocol.consent = {{"en", "A study of a test."}};
  protocol.contact = "Nobody";
  session::SessionTools tools{[] { return study::Moment{}; }, study::RecordIds()};
  ASSERT_TRUE(session::setProtocol(file, protocol, "Test", "", tools));
}

TEST_F(CollectViewTest, AStudyClosedWhileTheDeviceIsLookedForHoldsNothingBack) {
  openStudy(readyForASession);
  const QString other = folder.path(QStringLiteral("other.tactus"));
  tests::makeStudyFile(other, readyForASession);
  SessionRun& run = bench.run;
  for (const bool opens_another : {false, true}) {
    ASSERT_TRUE(comesTrue([this] { return collect().overview().rows.size() == 1 && collect().isCurrent(); }));
    run.start(QStringLiteral("amber-crow"));
    EXPECT_TRUE(run.isRunning());
    opens_another ? bench.study.open(other) : bench.study.close();
    ASSERT_TRUE(comesTrue([&] { return !run.isRunning(); }));
    EXPECT_EQ(run.takePart(), nullptr) << "no session begins in a study that it was not asked for";
    EXPECT_TRUE(window.banner().message().contains(QStringLiteral("No session has begun")))
        << window.banner().message().toStdString();
    if (!opens_another) bench.files.open(path);
  }
  ASSERT_TRUE(comesTrue([&] { return bench.study.path() == other && !bench.study.isOpening(); }));
  EXPECT_TRUE(bench.study.takesOrders());
}

TEST_F(CollectViewTest, ASessionTakesTheParticipantsScreensAndComesBack) {
  openStudy(readyForASession);
  ASSERT_TRUE(comesTrue([this] { return collect().overview().rows.size() == 1; }));
  home().select(collect().overview().rows.front().person);
  SessionRun& run = bench.run;
  QTest::mouseClick(button<PrimaryButton>(home(), "Start with amber-crow"), Qt::LeftButton);
  ASSERT_TRUE(comesTrue([&] { return run.takePart() != nullptr; }));
  EXPECT_FALSE(window.isVisible());
  EXPECT_TRUE(run.takePart()->window().isVisible());
  EXPECT_FALSE(run.monitorWindow()->isVisible());  // with one screen it would cover hers
  ParticipantController& course = run.takePart()->course();
  ASSERT_TRUE(comesTrue([&] { return course.state().code == QStringLiteral("amber-crow"); }));
  EXPECT_EQ(course.state().welcome.step, WelcomeState::Step::kNewCode);
  EXPECT_EQ(run.monitor()->nurse().code, QStringLiteral("amber-crow"));
  EXPECT_FALSE(home().findChild<PrimaryButton*>()->isEnabled());

  run.takePart()->window().leave();
  emit run.takePart()->left();
  ASSERT_TRUE(comesTrue([&] { return !run.isRunning(); }));
  EXPECT_TRUE(window.isVisible());
  EXPECT_TRUE(comesTrue([this] { return collect().isCurrent(); }));
}

TEST_F(CollectViewTest, AnEmptyStudyIsFilledWithSimulatedNurses) {
  openStudy();
  QPushButton* const fill = button(home(), "Fill with simulated nurses…");
  ASSERT_NE(fill, nullptr);
  QTimer::singleShot(0, &window, [] {
    auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QSpinBox*>()->setValue(2);
    dialog->accept();
  });
  fill->click();
  EXPECT_TRUE(collect().isFilling());
  ASSERT_TRUE(comesTrue([this] { return !collect().isFilling() && collect().overview().rows.size() == 2; }));
  for (const ParticipantRow& row : collect().overview().rows) EXPECT_TRUE(row.simulated) << row.code.toStdString();
}

}  // namespace
}  // namespace tactus::workbench
