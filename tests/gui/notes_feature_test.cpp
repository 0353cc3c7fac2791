// What the window says about a study: what happened to it, its data, and the build of its model.

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/session/study_import.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/study/study_notice_strip.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/workbench.h"
#include "core/base/check.h"
#include "core/store/persons.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/plain_sql.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"
#include "tests/support/table_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class NotesFeatureTest : public testing::Test {
 protected:
  void SetUp() override {
    window.resize(2000, 1000);  // there is room for each button in the heading
    window.show();
  }

  bool open() {
    bench.files.open(path);
    return comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); });
  }
  bool build() {
    bench.study_models.buildModel();
    const bool built = comesTrue([this] { return bench.study_models.keepsModel() && !bench.study.isBusy(); });
    window.enter(Stage::kTune);
    return built;
  }
  void close() {
    bench.study.close();
    ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  }
  bool reviewed() {
    return comesTrue([this] { return !bench.study_models.isReviewing(); });
  }
  // A study of three simulated nurses, `spoil`ed before it is imported.
  void makeNurses(const std::function<void(study::Study&)>& spoil) {
    study::Study nurses = support::tableStudy(3, {.nurses = 3});
    spoil(nurses);
    tests::makeStudyFile(path, [&](store::StudyFile& file, study::RecordIds&) {
      TACTUS_CHECK(session::importTables(nurses, file).has_value());
    });
  }
  static void oneWordOfN2(study::Study& nurses) {
    for (auto& judgement : nurses.judgements) {
      if (judgement.participant == "N2" && !judgement.term.empty()) judgement.term = "small";
    }
  }
  // The button of the heading whose text begins so, where it is shown.
  NotesButton* headButton(const QString& start) {
    for (auto* button : window.header().findChildren<NotesButton*>()) {
      if (!button->isHidden() && button->text().startsWith(start)) return button;
    }
    return nullptr;
  }
  QAction* action(const QString& text) {
    for (QAction* one : bench.window.menus().menu(MenuSlot::kStudyOpen).actions()) {
      if (one->text().remove(QLatin1Char('&')) == text) return one;
    }
    return nullptr;
  }
  StudyNoticeStrip& strip() { return *window.findChild<StudyNoticeStrip*>(); }
  QAbstractButton* stripButton(const QString& text) {
    for (auto* button : strip().findChildren<QAbstractButton*>()) {
      if (button->text() == text && button->isVisible()) return button;
    }
    return nullptr;
  }
  static bool anyContains(const QStringList& sentences, const QString& words) {
    return std::any_of(sentences.begin(), sentences.end(), [&](const QString& one) { return one.contains(words); });
  }
  // What the list over the window says; it is closed.
  static QStringList popupSays() {
    QWidget* popup = QApplication::activePopupWidget();
    if (popup == nullptr) return {};
    QStringList said;
    for (const QLabel* label : popup->findChildren<QLabel*>()) said << label->text();
    popup->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return said;
  }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("sample.tactus"));
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
  MainWindow& window = bench.window;
};

TEST_F(NotesFeatureTest, WhatIsOddInTheDataAndWhatTheBuildSaysIsReadableAfterReopening) {
  makeNurses(oneWordOfN2);
  ASSERT_TRUE(open());
  ASSERT_TRUE(build());
  const BuildNotes built = bench.study_models.notes();
  ASSERT_EQ(built.data.size(), 1U);
  EXPECT_TRUE(built.data[0].sentence.contains(QStringLiteral("N2"))) << built.data[0].sentence.toStdString();
  EXPECT_EQ(built.data[0].subject, "force");
  EXPECT_FALSE(built.build.empty());
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isBusy(); }));

  // The model is a version of the study now; what is said is computed anew, and the window does not wait for it.
  close();
  EXPECT_TRUE(bench.study_models.notes().isEmpty());
  EXPECT_EQ(headButton(QStringLiteral("Look")), nullptr);
  ASSERT_TRUE(open());
  ASSERT_TRUE(reviewed());
  EXPECT_EQ(bench.study_models.notes(), built);
}

TEST_F(NotesFeatureTest, NotesOfAnotherBuildThanThatOfTheModelSaySo) {
  makeNurses([](study::Study&) {});
  ASSERT_TRUE(open());
  ASSERT_TRUE(build());
  const BuildNotes built = bench.study_models.notes();
  EXPECT_TRUE(built.data.empty());
  bench.models.open(folder.write(tests::twoExperts()));
  bench.study_models.putModel();
  ASSERT_TRUE(reviewed());
  const BuildNotes& notes = bench.study_models.notes();
  ASSERT_EQ(notes.build.size(), built.build.size() + 1);
  EXPECT_TRUE(notes.build[0].sentence.startsWith(QStringLiteral("These notes are of a build from the answers")));
}

TEST_F(NotesFeatureTest, TheyStandBesideTheHeadingAndAtTheNumberTheyBelongTo) {
  makeNurses(oneWordOfN2);
  ASSERT_TRUE(open());
  ASSERT_TRUE(build());
  NotesButton* data = headButton(QStringLiteral("Look at the data first: 1"));
  ASSERT_NE(data, nullptr);
  data->click();
  const QStringList said = popupSays();
  ASSERT_EQ(said.size(), 2);
  EXPECT_EQ(said[0], QStringLiteral("Look at the data first"));
  EXPECT_EQ(said[1], bench.study_models.notes().data[0].sentence);
  NotesButton* notes =
      headButton(NotesButton::counted(static_cast<qsizetype>(bench.study_models.notes().build.size())));
  ASSERT_NE(notes, nullptr);
  notes->click();
  EXPECT_EQ(popupSays().size(), static_cast<qsizetype>(bench.study_models.notes().build.size()) + 1);
  // The same from the menu, with the keyboard alone.
  action(QStringLiteral("Look at the data first"))->trigger();
  EXPECT_EQ(popupSays(), said);

  auto* at_terms = bench.views.membership_editor->findChild<NotesButton*>();
  bench.terms.setVariable("force");
  ASSERT_FALSE(at_terms->isHidden());
  EXPECT_EQ(at_terms->notes().value(0).sentences, said.mid(1));
  EXPECT_TRUE(at_terms->toolTip().startsWith(QStringLiteral("Look at the data first")))
      << at_terms->toolTip().toStdString();
  bench.terms.setVariable("lubrication");
  EXPECT_TRUE(at_terms->isHidden());

  // Those of another model than the study's are not said of this one.
  bench.models.open(folder.write(tests::twoExperts()));
  bench.terms.setVariable("force");
  EXPECT_TRUE(at_terms->isHidden());
  EXPECT_EQ(headButton(NotesButton::counted(static_cast<qsizetype>(bench.study_models.notes().build.size()))), nullptr);
  EXPECT_NE(headButton(QStringLiteral("Look at the data first: 1")), nullptr);
}

TEST_F(NotesFeatureTest, OneButtonStandsForAllWhereThereIsNoRoom) {
  makeNurses(oneWordOfN2);
  ASSERT_TRUE(open());
  ASSERT_TRUE(build());
  const auto notes = static_cast<qsizetype>(bench.study_models.notes().build.size());
  ASSERT_NE(headButton(NotesButton::counted(notes)), nullptr);
  window.header().setMaximumWidth(300);
  ASSERT_TRUE(comesTrue([this] { return headButton(QStringLiteral("Look at the data first: 1")) == nullptr; }));
  EXPECT_EQ(headButton(NotesButton::counted(notes)), nullptr);
  NotesButton* all = headButton(NotesButton::counted(notes + 1));
  ASSERT_NE(all, nullptr);
  all->click();
  EXPECT_EQ(popupSays().size(), notes + 1 + 2);
  window.header().setMaximumWidth(QWIDGETSIZE_MAX);
  ASSERT_TRUE(comesTrue([&] { return all->isHidden(); }));
  EXPECT_NE(headButton(QStringLiteral("Look at the data first: 1")), nullptr);
}

TEST_F(NotesFeatureTest, DataThatCannotBeMeantAreRefusedAndListed) {
  makeNurses([](study::Study& nurses) {
    for (auto& judgement : nurses.judgements) judgement.force_n *= 1000;  // mN
  });
  ASSERT_TRUE(open());
  QSignalSpy failed(&bench.study_models, &StudyModels::failed);
  bench.study_models.buildModel();
  ASSERT_TRUE(comesTrue([&] { return failed.count() == 1; }));
  EXPECT_EQ(bench.models.current(), nullptr);
  EXPECT_EQ(window.banner().message(), failed[0][1].toString());
  EXPECT_FALSE(window.banner().message().isEmpty());
  ASSERT_TRUE(reviewed());
  // There is no heading yet.
  ASSERT_TRUE(action(QStringLiteral("Look at the data first"))->isEnabled());
  action(QStringLiteral("Look at the data first"))->trigger();
  EXPECT_TRUE(anyContains(popupSays(), QStringLiteral("No model is built of this: ")));
}

TEST_F(NotesFeatureTest, AMissingJournalIsSaidAndStaysReadable) {
  tests::makeStudyFile(folder.path(QStringLiteral("open.tactus")), [&](store::StudyFile& file, study::RecordIds& ids) {
    tests::addVisit(file, ids, "calm-fox", true);
    ASSERT_TRUE(QFile::copy(QString::fromStdString(file.path()), path));  // as it lies there, without its journal
  });
  EXPECT_TRUE(strip().isHidden());
  ASSERT_TRUE(open());
  ASSERT_TRUE(strip().isVisible());
  ASSERT_EQ(strip().sentences().size(), 1);
  const QString sentence = strip().sentences()[0];
  EXPECT_TRUE(
      sentence.startsWith(QStringLiteral("sample.tactus: the journal of a study that was not closed was missing")))
      << sentence.toStdString();
  EXPECT_TRUE(sentence.endsWith(QStringLiteral("look for them in a backup or an export of the study.")));
  // Closed, it is shown again from the menu.
  ASSERT_NE(stripButton(QStringLiteral("✕")), nullptr);
  stripButton(QStringLiteral("✕"))->click();
  EXPECT_TRUE(strip().isHidden());
  QAction* again = action(QStringLiteral("Show what happened to the study"));
  ASSERT_TRUE(again->isEnabled());
  again->trigger();
  EXPECT_EQ(strip().sentences(), QStringList{sentence});

  // The next opening has nothing new to say, and what was found stays readable.
  close();
  EXPECT_TRUE(strip().isHidden());
  EXPECT_FALSE(again->isEnabled());
  ASSERT_TRUE(open());
  EXPECT_TRUE(strip().isHidden());
  ASSERT_TRUE(again->isEnabled());
  again->trigger();
  EXPECT_TRUE(anyContains(popupSays(), QStringLiteral("the journal of a study that was not closed was missing")));
}

TEST_F(NotesFeatureTest, AnInterruptedErasureIsFinishedWithAButton) {
  study::RecordId person;
  tests::makeStudyFile(path, [&](store::StudyFile& file, study::RecordIds& ids) {
    person = ids.next();
    ASSERT_TRUE(store::append(file, study::Person{person, "calm-fox", false}));
    ASSERT_TRUE(store::withdraw(file, person, 10));
  });
  ASSERT_EQ(store::PlainSql(path.toStdString())
                .complaint("INSERT INTO erasure VALUES (x'" + study::toText(person) + "', 10)"),
            "");
  bench.models.open(folder.write(tests::twoExperts()));
  ASSERT_TRUE(open());
  ASSERT_EQ(strip().sentences().size(), 1);
  EXPECT_EQ(strip().sentences()[0], QStringLiteral("sample.tactus: the erasure of a participant who withdrew was "
                                                   "interrupted. Traces of the data can still be in the file."));
  NotesButton* notice = headButton(QStringLiteral("1 notice"));
  ASSERT_NE(notice, nullptr);
  ASSERT_NE(stripButton(QStringLiteral("Finish the erasure")), nullptr);
  stripButton(QStringLiteral("Finish the erasure"))->click();
  ASSERT_NE(stripButton(QStringLiteral("Erasing…")), nullptr);
  EXPECT_FALSE(stripButton(QStringLiteral("Erasing…"))->isEnabled());
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isErasing(); }));
  EXPECT_TRUE(strip().isHidden());
  EXPECT_TRUE(notice->isHidden());
  EXPECT_TRUE(window.banner().message().startsWith(QStringLiteral("The erasure is finished")))
      << window.banner().message().toStdString();
  close();
  EXPECT_TRUE(store::unfinishedErasures(tests::lookInto(path))->empty());
}

}  // namespace
}  // namespace tactus::workbench
