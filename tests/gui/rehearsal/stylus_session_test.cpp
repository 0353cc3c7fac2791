// Whole sessions with a stylus whose button must be pressed: killed at each screen, and resumed on the next day in
// another language.
#include <QFile>
#include <QLabel>
#include <algorithm>
#include <set>

#include "app/session/study_view.h"
#include "app/session/trials.h"
#include "core/store/sessions.h"

#include "tests/gui/rehearsal/take_part_session.h"
#include "tests/gui/stylus.h"

namespace tactus::workbench {
namespace {

using Screen = ParticipantScreen;
using tests::comesTrue;

struct Way {
  const char* name;
  const char* language;  ///< of the first day
  QSize size;
  int text_percent;
  session::Grip grip;
};

const Way kWays[] = {{"EnglishSmall", "en", {1280, 720}, 100, session::Grip::kHeld},
                     {"TraditionalLarge", "zh-Hant", {1920, 1080}, 100, session::Grip::kLatch},
                     {"SimplifiedLargestText", "zh-Hans", {1280, 720}, 150, session::Grip::kHeld}};

class StylusSession : public TakePartTest, public testing::WithParamInterface<Way> {
 protected:
  void SetUp() override {
    device = std::make_unique<DeviceSession>(stylus.access(time));
    plan.device = QStringLiteral("hid:test-stylus");
    plan.settings.grip = GetParam().grip;
    plan.settings.force.ladder_catches = 1;
    largest_n = 0.8;
    ASSERT_NO_FATAL_FAILURE(begin());
    part->course().setTextPercent(GetParam().text_percent);
    part->course().setLanguage(QString::fromLatin1(GetParam().language));
    ASSERT_NO_FATAL_FAILURE(resize());
  }

  // The window fills a screen of the tests that has another size.
  void resize() {
    part->window().showNormal();
    part->window().resize(GetParam().size);
    ASSERT_TRUE(comesTrue([this] { return window()->size() == GetParam().size; }));
  }
  void click(const QAbstractButton& on) {
    QTest::mouseClick(window(), Qt::LeftButton, {}, on.mapTo(&part->window(), on.rect().center()));
  }
  void choose(const QString& text, Qt::Key /*key*/) override {
    const QAbstractButton* card = button(text);
    ASSERT_NE(card, nullptr) << text.toStdString();
    click(*card);
  }
  void goOn() override {
    for (const char* id :
         {"code.new", "con.agree", "nav.confirm", "for.sure_yes", "nav.seal", "nav.continue", "nav.next", "thx.done"}) {
      if (const QAbstractButton* found = button(say(id))) return click(*found);
    }
    FAIL() << static_cast<int>(at().screen);
  }
  bool isLatched() const { return GetParam().grip == session::Grip::kLatch; }
  // Takes hold of the tube, or lets it go.
  void hold(bool held) {
    if (!isLatched()) return stylus.press(held);
    stylus.press(true);
    pass(120);
    stylus.press(false);
  }
  void push(bool until_still) override {
    stylus.moveTo(0);
    pass(400);
    hold(true);
    pass(until_still ? 1300 : 300);
    for (int mm = 4; mm <= 60; mm += 4) {
      stylus.moveTo(mm);
      pass(48);
    }
    pass(900);
    hold(false);
    pass(100);
    stylus.moveTo(0);
    pass(400);
  }
  // As a power cut leaves the file; the next day begins with another language.
  void cutAndComeBack() {
    const QString code = at().code;
    const QString copy = folder.filePath(QStringLiteral("day_%1.tactus").arg(++days));
    for (const char* end : {"", "-wal"}) {
      const QLatin1String ending(end);
      ASSERT_TRUE(!QFile::exists(path + ending) || QFile::copy(path + ending, copy + ending));
    }
    TearDown();
    path = copy;
    time.pass(24 * 3600 * 1000);
    study = std::make_unique<StudyConnection>();
    study->open(path);
    ASSERT_TRUE(comesTrue([this] { return study->isOpen(); }));
    stylus.moveTo(0);
    stylus.press(false);
    device = std::make_unique<DeviceSession>(stylus.access(time));
    part = std::make_unique<TakePart>(*study, *device, plan, [this] { return now(); });
    QObject::connect(part.get(), &TakePart::finished, [this] { finished = true; });
    part->begin(*QGuiApplication::primaryScreen());
    ASSERT_TRUE(QTest::qWaitForWindowActive(&part->window()));
    ASSERT_NO_FATAL_FAILURE(resize());
    settle();
    const char* const languages[] = {"en", "zh-Hant", "zh-Hans"};
    part->course().setLanguage(QString::fromLatin1(languages[days % 3]));
    part->course().setTextPercent(GetParam().text_percent);
    settle();
    part->course().enterCode(code);
    ASSERT_TRUE(comesTrue([&] { return at().code == code; }));
    settle();
    goOn();
    settle();
    ASSERT_NE(at().screen, Screen::kWelcome);
  }

  tests::Stylus stylus;
  int days = 0;
};

TEST_P(StylusSession, KilledAtEachScreenAndResumedOnTheNextDayInAnotherLanguage) {
  std::set<std::pair<Screen, bool>> seen;
  for (int steps = 0; steps < 400 && !finished; ++steps) {
    settle();
    // Before the consent nothing is kept.
    const bool known = at().screen != Screen::kWelcome && at().screen != Screen::kConsent;
    if (known && seen.insert({at().screen, at().feels_force}).second) {
      ASSERT_NO_FATAL_FAILURE(cutAndComeBack());
    }
    ASSERT_NO_FATAL_FAILURE(doIt()) << static_cast<int>(at().screen);
    ASSERT_NE(at().overlay, ForceOffOverlay::kForceOff);
  }
  ASSERT_TRUE(finished) << static_cast<int>(at().screen);
  // Not the usability form and the stop, and not what comes before the consent; the practice twice.
  EXPECT_GE(days, static_cast<int>(std::size(kScreenFacts)) - 3);
  settle();
  TearDown();
  study = std::make_unique<StudyConnection>();

  const auto file = tests::lookInto(path);
  const auto view = *session::studyForElicitation(file);
  const auto trials = *session::trials(file, view);
  ASSERT_EQ(view.study.participants.size(), 1U);
  EXPECT_EQ(store::sessions(file)->size(), 1U);
  std::map<session::Trial::Kind, int> counted;
  std::map<session::Trial::Kind, int> all;
  std::set<std::string> languages;
  for (const session::Trial& trial : trials) {
    ++all[trial.kind];
    if (trial.counts) ++counted[trial.kind];
    languages.insert(trial.under.language);
    EXPECT_EQ(trial.under.device, "hid:test-stylus");
    EXPECT_NE(trial.settings.find(isLatched() ? R"("grip":"latch")" : R"("grip":"held")"), std::string::npos);
  }
  using Kind = session::Trial::Kind;
  EXPECT_EQ(counted[Kind::kStroke], 2);
  EXPECT_EQ(counted[Kind::kJudgement], 4) << "without the practice and the blank";
  EXPECT_EQ(all[Kind::kJudgement], 6);
  EXPECT_EQ(counted[Kind::kAnswer], 45);
  EXPECT_EQ(store::ratings(file)->size(), 3U);
  EXPECT_EQ(languages, (std::set<std::string>{"en", "zh-Hans", "zh-Hant"}));
}

// What waits for the button says so, and then that the researcher is needed; a handle that is moved is no handle held.
TEST_P(StylusSession, NothingIsFeltUntilTheButtonIsPressed) {
  for (int steps = 0; steps < 20; ++steps) {
    settle();
    if (at().screen == Screen::kDeviceCheck) break;
    ASSERT_NO_FATAL_FAILURE(doIt());
  }
  ASSERT_EQ(at().screen, Screen::kDeviceCheck);
  const auto says = [this](const char* id) {
    const auto labels = part->window().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [this, id](const QLabel* label) { return label->isVisible() && label->text() == say(id); });
  };
  EXPECT_TRUE(says(isLatched() ? "dev.hold_latch" : "dev.hold"));
  for (int second = 0; second < 9; ++second) {
    stylus.moveTo(second % 2 == 0 ? 30 : 0);
    pass(1000);
  }
  EXPECT_EQ(at().device, DeviceStep::kHold);
  EXPECT_EQ(at().waits, HoldWait::kHint);
  EXPECT_TRUE(says("dev.hint"));
  pass(12000);
  EXPECT_EQ(at().waits, HoldWait::kStuck);
  EXPECT_TRUE(says("dev.stuck"));
  stylus.moveTo(0);
  pass(500);
  hold(true);
  pass(1300);
  EXPECT_EQ(at().device, DeviceStep::kPush);
  EXPECT_EQ(at().waits, HoldWait::kNot);
}

INSTANTIATE_TEST_SUITE_P(Ways, StylusSession, testing::ValuesIn(kWays),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace tactus::workbench
