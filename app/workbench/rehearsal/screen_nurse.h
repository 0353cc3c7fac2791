// A simulated nurse in front of the screens: she reads them, thinks for a while, presses what a nurse would press and
// moves the virtual hand. She knows what the screens show and what the hand feels, and nothing else.
#pragma once

#include <QPointF>
#include <QString>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/session/simulated_nurse.h"
#include "app/session/simulated_strokes.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "core/base/random.h"
#include "core/haptics/servo/sample.h"

class QAbstractButton;

namespace tactus::workbench {

// Eyes and hands of a simulated nurse in front of the screens: she sees the buttons that can be pressed, and everything
// that she does arrives at the window as events of a mouse.

class ParticipantWindow;

/// Thread: gui.
class ScreenHands {
 public:
  /// Both outlive this.
  ScreenHands(ParticipantWindow& window, const nurse::Look& look) : window_(window), look_(look) {}

  /// Clicks the button or card that says this (`id`: of the word book). False: none can be pressed, as it is not
  /// visible, waits or is covered.
  bool press(const char* id) const;
  bool press(const QString& id) const;
  bool press(const nurse::Phrase& text) const;
  /// Clicks the cell of this item in the review. False: it is not on the page.
  bool pressCell(int item) const;

  /// Takes the handle of the virtual device: a press on the free area, which lasts until `letGo`.
  void takeHold();
  /// Moves the handle along its axis, mm from where it was taken.
  void moveTo(double position_mm) const;
  void letGo();
  bool holds() const { return holds_; }

 private:
  QAbstractButton* button(const nurse::Phrase& text) const;
  QAbstractButton* buttonThat(const std::function<bool(const QAbstractButton&)>& is_it) const;
  void click(const QAbstractButton& button) const;
  QPointF freePlace() const;

  ParticipantWindow& window_;
  const nurse::Look& look_;
  bool holds_ = false;
  QPointF held_at_;  ///< in the window
};

/// What the nurse has done, as she remembers it.
struct NurseMemory {
  QString code;
  std::map<QString, int> strokes;   ///< insertions that were asked for, by the term id of the speed
  std::vector<QString> judgements;  ///< words of the forces, in order; also those asked again
  std::map<int, QString> replies;   ///< the last word of each item
  std::vector<std::pair<QString, QString>> own_regions;  ///< region, comparison
  int marks = 0;
  int ratings = 0;  ///< of parts, with effort and comfort
  bool sealed = false;
};

/// Thread: gui.
class ScreenNurse {
 public:
  /// `hands` outlives this. The same `seed` gives the same session.
  ScreenNurse(ScreenHands& hands, session::NurseTraits traits, std::uint64_t seed);

  /// What is new on the screens; before `live` of the same moment.
  void notice(const ParticipantState& state, double now_s);
  /// One moment. `now_s`: her time, which never goes back; call it at least 50 times a second of it.
  void live(const ParticipantState& state, const haptics::Sample& felt, double now_s);

  /// She has pressed the last button of the last screen.
  bool isDone() const { return done_; }
  /// The screens led her away from a whole session.
  bool isSentAway() const { return sent_away_; }
  const NurseMemory& memory() const { return memory_; }

 private:
  void act(const ParticipantState& state);
  bool moveHand(const haptics::Sample& felt);
  void beginStroke(session::Recording path);
  void wait(double least_s, double most_s);
  void passPage(const PageState& page);
  void atWelcome(const WelcomeState& welcome);
  void tellAboutHerself(const AboutYouState& about);
  void checkDevice(DeviceStep step);
  void insert(const ParticipantState& state);
  void feel();
  void judge(const ForceState& force, bool practice);
  void answer(const QuestionState& question);
  void rate(const PageState& page);
  void review(const ReviewState& shown);
  void feelOwnModel(const OwnModelState& own);
  QString wordFor(double felt_n);
  QString replyTo(int item) const;
  QString besides(const QString& word) const;

  ScreenHands& hands_;
  session::NurseTraits traits_;
  session::SimulatedResponder responder_;
  base::Random random_;
  NurseMemory memory_;
  double now_s_ = 0;
  double busy_until_s_ = 0;
  session::Recording path_;  ///< of the hand, while it holds
  double path_since_s_ = 0;
  double percept_n_ = 0;                          ///< of the force that was judged last
  double felt_n_ = 0;                             ///< the largest force since the hand took the handle
  std::uint64_t serial_ = 0;                      ///< of the state before
  std::optional<QString> said_;                   ///< a word that she has just confirmed
  bool said_rating_ = false;                      ///< the last point of a rating, likewise
  std::map<std::pair<QString, int>, int> tries_;  ///< of each insertion
  std::map<int, QString> regrets_;                ///< items that she will correct, and the right word
  bool again_ = false;                            ///< the same force once more: this time she moves
  std::optional<int> felt_region_;                ///< the region of the own model that she has felt
  bool marked_ = false;
  bool done_ = false;
  bool sent_away_ = false;
};

}  // namespace tactus::workbench
