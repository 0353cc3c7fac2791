// The nurse's controls: sizes on the screen, touches that roll, what is chosen, what a screen reader says.
#include <QAccessible>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pages.h"
#include "app/workbench/participant/screens/device_screens.h"
#include "app/workbench/participant/screens/page_screen.h"
#include "app/workbench/participant/screens/question_screens.h"

namespace tactus::workbench::nurse {
namespace {

// Contrast of two colors, WCAG 2.1.
double contrastOf(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& color) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
  };
  const double one = luminance(a);
  const double other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

TEST(NurseColors, TextHasSevenToOneAndEdgesThreeToOne) {
  for (const QColor& ground : {colors::kGround, colors::kCard}) {
    EXPECT_GE(contrastOf(colors::kInk, ground), 7);
    EXPECT_GE(contrastOf(colors::kMutedInk, ground), 7);
    EXPECT_GE(contrastOf(colors::kEdge, ground), 3);
  }
  EXPECT_GE(contrastOf(colors::kInk, colors::kChosen), 7);
  EXPECT_GE(contrastOf(colors::kInk, colors::kWaiting), 7);
  EXPECT_GE(contrastOf(Qt::white, colors::kAccent), 7);
  EXPECT_GE(contrastOf(Qt::white, colors::kForceOff), 7);
}

TEST(NurseLook, TextIs22PointsOnTheScreenTimesTheChosenSize) {
  Look look;
  look.setScreen(96, {1920, 1080});
  EXPECT_EQ(look.textPx(), 29);  // 22 / 72 * 96 = 29.3
  look.setTextPercent(150);
  EXPECT_EQ(look.textPx(), 44);
  look.setScreen(144, {2560, 1440});
  look.setTextPercent(100);
  EXPECT_EQ(look.textPx(), 44);
  look.setScreen(20, {1920, 1080});  // a television that states nonsense: 80
  EXPECT_EQ(look.textPx(), 24);
}

TEST(NurseLook, EverythingShrinksWithASmallWindowOfADenseScreen) {
  Look look;
  look.setScreen(220, {1280, 720});
  EXPECT_EQ(look.mm(180), 720);
  EXPECT_EQ(look.textPx(), 40);  // 720 / 18
}

class NurseKit : public testing::Test {
 protected:
  NurseKit() { look.setScreen(96, {1280, 720}); }

  static QString spoken(QWidget* widget) {
    return QAccessible::queryAccessibleInterface(widget)->text(QAccessible::Name);
  }

  Look look;
};

TEST_F(NurseKit, ControlsAreLargeEnoughForAFinger) {
  const double dots = 96 / 25.4;
  for (Answer& answer : forceWords(look)) {
    const bool apart = answer.apart;
    const AnswerCard card(look, std::move(answer), 1, 5);
    EXPECT_GE(card.sizeHint().width(), 30 * dots - 1);
    EXPECT_GE(card.sizeHint().height(), (apart ? 20 : 25) * dots - 1);
  }
  const Button next(look, ButtonKind::kPrimary, phrase(QStringLiteral("nav.next")));
  EXPECT_GE(next.sizeHint().height(), 20 * dots - 1);
  const Button off(look, ButtonKind::kForceOff, phrase(QStringLiteral("off.button")));
  EXPECT_GE(off.sizeHint().height(), 25 * dots - 1);
  EXPECT_GE(off.sizeHint().width(), 25 * dots - 1);
}

TEST_F(NurseKit, ATouchThatRollsCountsWhereItBegan) {
  Button button(look, ButtonKind::kPlain, phrase(QStringLiteral("nav.next")));
  button.resize(button.sizeHint());
  button.show();
  QSignalSpy clicks(&button, &QAbstractButton::clicked);
  const QPoint inside = button.rect().center();
  const QPoint near(button.width() + look.mm(9), inside.y());
  const QPoint far(button.width() + look.mm(12), inside.y());

  QTest::mousePress(&button, Qt::LeftButton, {}, inside);
  EXPECT_TRUE(button.isDown());
  QTest::mouseMove(&button, near);
  QTest::mouseRelease(&button, Qt::LeftButton, {}, near);
  EXPECT_EQ(clicks.count(), 1);

  QTest::mousePress(&button, Qt::LeftButton, {}, inside);
  QTest::mouseRelease(&button, Qt::LeftButton, {}, far);
  EXPECT_EQ(clicks.count(), 1);

  QTest::mousePress(&button, Qt::LeftButton, {}, near);  // began outside
  QTest::mouseRelease(&button, Qt::LeftButton, {}, near);
  EXPECT_EQ(clicks.count(), 1);
}

TEST_F(NurseKit, NothingIsChosenAtTheStartAndAChoiceCanBeTakenBack) {
  Choices choices(look);
  choices.setAnswers(forceWords(look));
  EXPECT_EQ(choices.chosen(), QString());
  choices.choose(QStringLiteral("large"));
  EXPECT_EQ(choices.chosen(), "large");
  choices.choose(QStringLiteral("not_felt"));
  EXPECT_EQ(choices.chosen(), "not_felt");
  choices.choose({});
  EXPECT_EQ(choices.chosen(), QString());
  EXPECT_EQ(choices.onScale(1), "very_small");
  EXPECT_EQ(choices.onScale(5), "very_large");
  EXPECT_EQ(choices.onScale(6), QString());
}

TEST_F(NurseKit, CardsSayTheirWordTheirPlaceAndWhetherTheyAreChosen) {
  AnswerCard card(look, {QStringLiteral("large"), phrase(QStringLiteral("w.large"))}, 4, 5);
  EXPECT_EQ(spoken(&card), "Large, 4 of 5");
  card.setChecked(true);
  EXPECT_EQ(spoken(&card), "Large, 4 of 5, chosen");
  look.setLanguage(Language::kSimplifiedChinese);
  EXPECT_EQ(spoken(&card), QStringLiteral("大，第 4 项，共 5 项，已选"));
}

TEST_F(NurseKit, TheChoiceStaysWhenTheLanguageChanges) {
  QuestionScreen screen(look);
  ParticipantState state;
  state.question.item = 43;
  state.question.conditions = {{"speed", "fast"}};
  state.question.region = QStringLiteral("oropharynx");
  state.question.chosen = QStringLiteral("small");
  screen.setState(state);
  QSignalSpy picks(&screen, &ScreenFrame::picked);
  look.setLanguage(Language::kTraditionalChinese);
  EXPECT_EQ(screen.findChild<Choices*>()->chosen(), "small");
  EXPECT_EQ(picks.count(), 0);
}

TEST_F(NurseKit, KeysOfBothRowsAnswerInTheOrderOfTheCards) {
  ForceScreen screen(look);
  ParticipantState state;
  state.force.phase = ForceState::Phase::kAnswer;
  screen.setState(state);
  screen.show();
  QSignalSpy picks(&screen, &ScreenFrame::picked);
  QSignalSpy confirms(&screen, &ScreenFrame::primary);
  QTest::keyClick(&screen, Qt::Key_1);
  QTest::keyClick(&screen, Qt::Key_5, Qt::KeypadModifier);
  QTest::keyClick(&screen, Qt::Key_0);
  QTest::keyClick(&screen, Qt::Key_9);
  ASSERT_EQ(picks.count(), 4);
  EXPECT_EQ(picks[0][0], "very_small");
  EXPECT_EQ(picks[1][0], "very_large");
  EXPECT_EQ(picks[2][0], "not_felt");
  EXPECT_EQ(picks[3][0], "beyond_practice");
  QTest::keyClick(&screen, Qt::Key_Return);
  EXPECT_EQ(confirms.count(), 0) << "nothing is chosen";
  state.force.chosen = QStringLiteral("small");
  screen.setState(state);
  QTest::keyClick(&screen, Qt::Key_Return);
  EXPECT_EQ(confirms.count(), 1);
  state.force.phase = ForceState::Phase::kFeel;
  screen.setState(state);
  QTest::keyClick(&screen, Qt::Key_2);
  QTest::keyClick(&screen, Qt::Key_Return);
  EXPECT_EQ(picks.count(), 4);
  EXPECT_EQ(confirms.count(), 1);
}

/// The pixels of the answers of `screen` in `state`, on a screen that nobody has touched.
template <class Screen>
QImage untouched(const Look& look, const ParticipantState& state) {
  Screen screen(look);
  screen.resize(1280, 720);
  screen.setState(state);
  screen.setVisible(true);
  return screen.grab().toImage();
}

Button* buttonOf(const QWidget& screen, const QString& text) {
  for (auto* button : screen.findChildren<Button*>()) {
    if (button->text() == text) return button;
  }
  return nullptr;
}

AnswerCard* cardOf(QWidget& screen, const char* id) {
  for (auto* card : screen.findChildren<AnswerCard*>()) {
    if (card->id() == QLatin1String(id)) return card;
  }
  return nullptr;
}

/// What the controller does: the answer is shown, and confirming brings the next question, without one.
template <class Screen>
class AnsweredScreen {
 public:
  AnsweredScreen(const Look& look, const ParticipantState& first, const ParticipantState& next)
      : screen(look), now_(first) {
    QObject::connect(&screen, &ScreenFrame::picked, &screen, [this](const QString& id) {
      now_.question.chosen = now_.page.chosen = id;
      screen.setState(now_);
    });
    QObject::connect(&screen, &ScreenFrame::primary, &screen, [this, next] {
      now_ = next;
      screen.setState(now_);
    });
    screen.resize(1280, 720);
    screen.setState(now_);
    screen.setVisible(true);
    screen.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&screen));
  }

  Screen screen;

 private:
  ParticipantState now_;
};

ParticipantState item(int number) {
  ParticipantState state;
  state.part = state.parts = 3;
  state.question.position = number;
  state.question.count = 45;
  state.question.item = 3;
  state.question.conditions = {{"lubrication", "poor"}};
  state.question.region = QStringLiteral("oropharynx");
  return state;
}

TEST_F(NurseKit, AfterAnAnswerByMouseNoCardOfTheNextQuestionStandsOut) {
  AnsweredScreen<QuestionScreen> question(look, item(7), item(8));
  QTest::mouseClick(cardOf(question.screen, "large"), Qt::LeftButton);
  EXPECT_NE(question.screen.grab().toImage(), (untouched<QuestionScreen>(look, item(7)))) << "the choice is seen";
  QTest::mouseClick(buttonOf(question.screen, QStringLiteral("Confirm")), Qt::LeftButton);
  EXPECT_EQ(question.screen.grab().toImage(), (untouched<QuestionScreen>(look, item(8))));

  ParticipantState first;
  first.page = statementPage(1, 1, 6, {});
  ParticipantState second;
  second.page = statementPage(2, 2, 6, {});
  AnsweredScreen<PageScreen> scale(look, first, second);
  QTest::mouseClick(cardOf(scale.screen, "6"), Qt::LeftButton);
  QTest::mouseClick(buttonOf(scale.screen, QStringLiteral("Confirm")), Qt::LeftButton);
  EXPECT_EQ(scale.screen.grab().toImage(), (untouched<PageScreen>(look, second)));

  ParticipantState years;
  years.page = aboutYouPage({});
  ParticipantState hand;
  hand.page = aboutYouPage({AboutYouState::Question::kHand, {}, false});
  AnsweredScreen<PageScreen> about(look, years, hand);
  QTest::mouseClick(cardOf(about.screen, "years_2"), Qt::LeftButton);
  QTest::mouseClick(buttonOf(about.screen, QStringLiteral("Next")), Qt::LeftButton);
  EXPECT_EQ(about.screen.grab().toImage(), (untouched<PageScreen>(look, hand)));
}

TEST_F(NurseKit, WhoMovesByKeysSeesTheRingAndTheNextQuestionBeginsWithoutIt) {
  AnsweredScreen<QuestionScreen> question(look, item(7), item(8));
  AnswerCard* const card = cardOf(question.screen, "very_small");
  for (int presses = 0; !card->hasFocus() && presses < 10; ++presses) {
    QTest::keyClick(question.screen.window()->focusWidget(), Qt::Key_Tab);
  }
  ASSERT_TRUE(card->hasFocus());
  EXPECT_NE(question.screen.grab().toImage(), (untouched<QuestionScreen>(look, item(7)))) << "the ring is seen";
  QTest::keyClick(card, Qt::Key_Space);
  QTest::keyClick(card, Qt::Key_Return);
  EXPECT_EQ(question.screen.grab().toImage(), (untouched<QuestionScreen>(look, item(8))));
}

}  // namespace
}  // namespace tactus::workbench::nurse
