#include "app/workbench/labs/data/corrections.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/settings_price.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "elicitation/model/method_study.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class CorrectionsTest : public testing::Test {
 protected:
  void SetUp() override {
    study.open(path);
    data.hold(lab);
    ASSERT_TRUE(comesTrue([this] { return data.study() != nullptr; }));
  }
  /// Until what `act` orders is stored and the study is read again after that: not the end of an earlier reading.
  void readAgainAfter(const std::function<void()>& act) {
    std::shared_ptr<const LabStudy> before;
    const auto stored = QObject::connect(&corrections, &Corrections::stored, &lab, [&] { before = data.study(); });
    act();
    EXPECT_TRUE(comesTrue([&] { return before != nullptr && data.study() != before && !data.isReading(); }));
    QObject::disconnect(stored);
  }
  study::StrokeRecord strokeOf(const std::string& level, int number) const {
    for (const auto& one : data.study()->strokes) {
      if (!one.practice && one.verdict == "accepted" && one.level == level && one.number == number) return one;
    }
    ADD_FAILURE() << "no stroke";
    return {};
  }
  /// Sorted, because a corrected record comes last in its session.
  std::vector<double> speeds() const {
    std::vector<double> out;
    for (const auto& sample : data.study()->study.speeds) out.push_back(sample.speed_mm_s);
    std::sort(out.begin(), out.end());
    return out;
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  QObject lab;
  StudyConnection study;
  LabData data{study};
  Corrections corrections{data};
};

// Settings are taken back in the same list as corrections; the moves of a slider are one step.
TEST_F(CorrectionsTest, SettingsHaveAnUndo) {
  const auto set_alpha = [this](double alpha) {
    auto settings = data.settings();
    settings.speed.alpha = alpha;
    data.setSettings(settings);
  };
  EXPECT_FALSE(corrections.canUndo());
  for (const double alpha : {0.93, 0.9, 0.85, 0.8}) set_alpha(alpha);
  EXPECT_EQ(corrections.undoText(), QStringLiteral("α 0.95 → 0.8"));
  auto settings = data.settings();
  settings.speed.fcm.m = 1.5;
  data.setSettings(settings);
  EXPECT_EQ(corrections.undoText(), QStringLiteral("m 2 → 1.5"));
  corrections.undo();
  EXPECT_EQ(data.settings().speed.fcm.m, 2);
  EXPECT_EQ(data.settings().speed.alpha, 0.8);
  corrections.undo();
  EXPECT_EQ(data.settings().speed.alpha, 0.95);
  EXPECT_FALSE(corrections.canUndo());
  corrections.redo();
  corrections.redo();
  EXPECT_EQ(data.settings().speed.fcm.m, 1.5);
  EXPECT_EQ(data.settings().speed.alpha, 0.8);
  EXPECT_FALSE(corrections.canRedo());
  EXPECT_EQ(settingsChange({}, data.settings()), QStringLiteral("α 0.95 → 0.8, m 2 → 1.5"));
}

// The price of a setting is the difference of the two models, over the points of the method study.
TEST_F(CorrectionsTest, ASettingSaysWhatItDoesToTheForce) {
  SettingsPrice price(data);
  price.setSeen(true);
  EXPECT_EQ(price.sentence(), QString());
  const elicitation::BuildSettings before = data.settings();
  auto after = before;
  after.speed.alpha = 0.8;
  data.setSettings(after);
  ASSERT_TRUE(comesTrue([&] { return price.sentence().contains(QStringLiteral("at most")); }))
      << price.sentence().toStdString();
  const LabStudy& of = *data.study();
  const auto first = elicitation::buildModel(of.study, of.forms, before);
  const auto second = elicitation::buildModel(of.study, of.forms, after);
  ASSERT_TRUE(first && second);
  const auto moved = elicitation::methodDifference(first->model, second->model);
  ASSERT_TRUE(moved);
  ASSERT_GT(moved->largest_n, 0.001);
  EXPECT_TRUE(price.sentence().startsWith(QStringLiteral("α 0.95 → 0.8: ")));
  EXPECT_NE(price.sentence().indexOf(quantityText(moved->largest_n, "N", 3)), -1) << price.sentence().toStdString();
  // The terms of before, until the change is taken back.
  const fuzzy::Variable& speed = first->model.inputs[fuzzy::rateOf(first->model.inputs).value()];
  EXPECT_EQ(price.formerTerms(speed.id), speed.terms);
  EXPECT_EQ(price.formerTerms(first->model.output.id), first->model.output.terms);
  EXPECT_EQ(price.formerTerms("no such variable"), std::vector<fuzzy::Term>());
  // Back where it was: nothing to say.
  data.setSettings(before);
  EXPECT_EQ(price.sentence(), QString());
  EXPECT_EQ(price.formerTerms(speed.id), std::vector<fuzzy::Term>());
}

// The data of a real person change only with a name and a reason, once a day; the demo's are simulated.
TEST_F(CorrectionsTest, DataOfARealPersonAreCorrectedUnderANameAndAReason) {
  const study::StrokeRecord simulated = strokeOf("fast", 2);
  const auto person = std::find_if(data.study()->persons.begin(), data.study()->persons.end(), [&](const auto& one) {
    return one.code == data.study()->codeOf(simulated.entry.session);
  });
  ASSERT_NE(person, data.study()->persons.end());
  QString asked;
  QObject::connect(&corrections, &Corrections::signatureAsked, [&asked](const QString& what) { asked = what; });
  // A real person beside them, with a stroke of the same values.
  study::StrokeRecord real;
  bool added = false;
  study.order(
      [&real, simulated](store::StudyFile& file, study::RecordIds& ids) -> base::Result<void> {
        const study::Person someone{ids.next(), "real-person", false};
        TACTUS_TRY(auto sessions, store::sessions(file));
        auto session = sessions.front();
        session.id = ids.next();
        session.person = someone.id;
        session.protocol.reset();
        TACTUS_TRY(auto recording, store::recordingOf(file, simulated.entry.id));
        real = simulated;
        real.entry.id = ids.next();
        real.entry.session = session.id;
        real.recording = recording;
        return store::append(file, someone).and_then([&] { return store::append(file, session); }).and_then([&] {
          return store::append(file, real);
        });
      },
      [&added] { added = true; }, [](const QString& sentence) { FAIL() << sentence.toStdString(); });
  ASSERT_TRUE(comesTrue([&added] { return added; }));
  const auto is_read = [this, &real] {
    const auto& all = data.study()->strokes;
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.entry.id == real.entry.id; });
  };
  data.refresh();
  ASSERT_TRUE(comesTrue([&] { return data.study() != nullptr && !data.isReading() && is_read(); }));
  real.recording = {};
  study::StrokeRecord shorter = real;
  shorter.first += 40;
  corrections.correct(real, shorter, QStringLiteral("marks"));
  EXPECT_EQ(asked, QStringLiteral("marks"));
  EXPECT_FALSE(corrections.isBusy());
  corrections.dropUnsigned();
  corrections.sign(QStringLiteral("Ann Lee"), QStringLiteral("heard the recording"));
  EXPECT_FALSE(corrections.isBusy()) << "what was dropped is not stored";
  asked.clear();
  readAgainAfter(
      [&] { corrections.correct(real, shorter, QStringLiteral("marks"), QStringLiteral("marks_corrected")); });
  EXPECT_TRUE(asked.isEmpty()) << "once a day";
  const auto& strokes = data.study()->strokes;
  const auto stored = std::find_if(strokes.begin(), strokes.end(),
                                   [&](const auto& one) { return one.entry.supersedes == real.entry.id; });
  ASSERT_NE(stored, strokes.end());
  EXPECT_EQ(stored->entry.reason, "marks_corrected; Ann Lee: heard the recording");
}

TEST_F(CorrectionsTest, MarksOfAStrokeAreANewRecordAndUndoBringsTheOldOnesBack) {
  const auto before = speeds();
  const study::StrokeRecord stroke = strokeOf("fast", 2);
  study::StrokeRecord shorter = stroke;
  shorter.first += 40;
  shorter.last -= 25;
  readAgainAfter([&] { corrections.correct(stroke, shorter, QStringLiteral("marks"), QStringLiteral("hesitated")); });
  EXPECT_EQ(speeds().size(), before.size() - 65);  // the recordings have 1000 samples a second
  EXPECT_EQ(strokeOf("fast", 2).entry.supersedes, stroke.entry.id);
  EXPECT_EQ(strokeOf("fast", 2).entry.reason, "hesitated");
  EXPECT_EQ(strokeOf("fast", 2).entry.entered_by, study::EnteredBy::kResearcher);
  EXPECT_EQ(corrections.undoText(), QStringLiteral("marks"));

  readAgainAfter([&] { corrections.undo(); });
  EXPECT_EQ(speeds(), before);
  EXPECT_FALSE(corrections.canUndo());
  readAgainAfter([&] { corrections.redo(); });
  EXPECT_EQ(speeds().size(), before.size() - 65);

  // A correction of the correction: the chain goes on.
  const study::StrokeRecord second = strokeOf("fast", 2);
  study::StrokeRecord rejected = second;
  rejected.verdict = "rejected";
  readAgainAfter([&] { corrections.correct(second, rejected, QStringLiteral("rejected")); });
  readAgainAfter([&] { corrections.undo(); });
  readAgainAfter([&] { corrections.undo(); });
  EXPECT_EQ(speeds(), before);

  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  const auto file = tests::lookInto(path);
  const auto all = store::strokes(file, {.history = true}, store::Recordings::kLeaveOut);
  const auto current = store::strokes(file, {}, store::Recordings::kLeaveOut);
  ASSERT_TRUE(all && current);
  EXPECT_EQ(all->size(), current->size() + 6);  // two corrections, three undone, one redone: none is lost
}

TEST_F(CorrectionsTest, AJudgementIsCorrectedInTheSameWay) {
  const auto found = std::find_if(data.study()->judgements.begin(), data.study()->judgements.end(),
                                  [](const auto& one) { return one.term == "very_small"; });
  ASSERT_NE(found, data.study()->judgements.end());
  const study::JudgementRecord before = *found;
  study::JudgementRecord wanted = before;
  wanted.term = "small";
  const auto votes = [this] {
    return std::count_if(data.study()->study.judgements.begin(), data.study()->study.judgements.end(),
                         [](const auto& one) { return one.term == "small"; });
  };
  const auto small = votes();
  readAgainAfter([&] { corrections.correct(before, wanted, QStringLiteral("judgement")); });
  EXPECT_EQ(votes(), small + 1);
  readAgainAfter([&] { corrections.undo(); });
  EXPECT_EQ(votes(), small);
}

TEST_F(CorrectionsTest, WithoutAChangeNothingIsWrittenAndWhatTheFileRefusesIsSaid) {
  const study::StrokeRecord stroke = strokeOf("slow", 1);
  corrections.correct(stroke, stroke, QStringLiteral("marks"));
  EXPECT_FALSE(corrections.isBusy());
  study::StrokeRecord wrong = stroke;
  wrong.level.clear();
  QSignalSpy refused(&corrections, &Corrections::refused);
  corrections.correct(stroke, wrong, QStringLiteral("level"));
  ASSERT_TRUE(comesTrue([&] { return refused.size() == 1; }));
  EXPECT_FALSE(corrections.canUndo());
  // What is offered does the same again.
  EXPECT_TRUE(refused.at(0).at(0).toString().startsWith(QStringLiteral("Not stored: level. ")));
  const auto act = refused.at(0).at(1).value<MessageAct>();
  EXPECT_EQ(act.text, QStringLiteral("Try again"));
  act.run();
  ASSERT_TRUE(comesTrue([&] { return refused.size() == 2; }));
}

}  // namespace
}  // namespace tactus::workbench
