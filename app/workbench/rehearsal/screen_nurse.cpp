#include "app/workbench/rehearsal/screen_nurse.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QLineEdit>
#include <QMouseEvent>
#include <QWindow>
#include <algorithm>
#include <cmath>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/review_screen.h"
#include "experiments/published_tables.h"

namespace tactus::workbench {
namespace {

/// Through the window, as a mouse does it: what lies on top gets the event.
void send(const ParticipantWindow& window, QEvent::Type type, const QPointF& at) {
  const bool moves = type == QEvent::MouseMove;
  const bool released = type == QEvent::MouseButtonRelease;
  QMouseEvent event(type, at, window.mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                    released ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.windowHandle(), &event);
}

/// The widget itself, or what it is part of.
template <class Kind>
Kind* around(QWidget* widget) {
  for (QWidget* at = widget; at != nullptr; at = at->parentWidget()) {
    if (auto* found = qobject_cast<Kind*>(at)) return found;
  }
  return nullptr;
}

}  // namespace

bool ScreenHands::press(const char* id) const { return press(QString::fromLatin1(id)); }

bool ScreenHands::press(const QString& id) const { return press(nurse::phrase(id)); }

bool ScreenHands::press(const nurse::Phrase& text) const {
  const QAbstractButton* found = button(text);
  if (found != nullptr) click(*found);
  return found != nullptr;
}

bool ScreenHands::pressCell(int item) const {
  const QAbstractButton* found = buttonThat([item](const QAbstractButton& each) {
    const auto* cell = qobject_cast<const nurse::ReviewCell*>(&each);
    return cell != nullptr && cell->item() == item;
  });
  if (found != nullptr) click(*found);
  return found != nullptr;
}

QAbstractButton* ScreenHands::button(const nurse::Phrase& text) const {
  const QString wanted = look_.say(text);
  return buttonThat([&wanted](const QAbstractButton& each) { return each.text() == wanted; });
}

QAbstractButton* ScreenHands::buttonThat(const std::function<bool(const QAbstractButton&)>& is_it) const {
  for (QAbstractButton* each : window_.findChildren<QAbstractButton*>()) {
    if (!each->isVisible() || !each->isEnabled() || !is_it(*each)) continue;
    const QPoint middle = each->mapTo(&window_, each->rect().center());
    if (around<QAbstractButton>(window_.childAt(middle)) == each) return each;
  }
  return nullptr;
}

void ScreenHands::click(const QAbstractButton& button) const {
  const QPointF middle = button.mapTo(&window_, button.rect().center());
  send(window_, QEvent::MouseButtonPress, middle);
  send(window_, QEvent::MouseButtonRelease, middle);
}

void ScreenHands::takeHold() {
  held_at_ = freePlace();
  holds_ = true;
  send(window_, QEvent::MouseButtonPress, held_at_);
}

void ScreenHands::moveTo(double position_mm) const {
  constexpr double kScaleMm = 100;  // whole pixels of a long way
  if (holds_) send(window_, QEvent::MouseMove, held_at_ + QPointF(position_mm * look_.mm(kScaleMm) / kScaleMm, 0));
}

void ScreenHands::letGo() {
  if (!holds_) return;
  holds_ = false;
  send(window_, QEvent::MouseButtonRelease, held_at_);
}

QPointF ScreenHands::freePlace() const {
  constexpr int kStepPx = 16;
  for (int y = window_.height() / 2; y < window_.height(); y += kStepPx) {
    for (int x = window_.width() / 8; x < window_.width() / 2; x += kStepPx) {
      QWidget* const there = window_.childAt(x, y);
      if (around<QAbstractButton>(there) == nullptr && around<QLineEdit>(there) == nullptr) return {x * 1.0, y * 1.0};
    }
  }
  return QPointF(1, 1);
}

namespace {

using Screen = ParticipantScreen;
using session::Recording;

constexpr double kHandRateHz = 100;  // of a path made here

/// Holds still for `still_s`, moves to `to_mm` with `speed_mm_s`, and rests for `rest_s`.
Recording pathOf(double still_s, double to_mm, double speed_mm_s, double rest_s) {
  Recording out;
  const double moves_s = std::abs(to_mm) / speed_mm_s;
  const int samples = static_cast<int>((still_s + moves_s + rest_s) * kHandRateHz);
  for (int i = 0; i <= samples; ++i) {
    const double time_s = i / kHandRateHz;
    out.time_s.push_back(time_s);
    out.depth_mm.push_back(to_mm * std::clamp((time_s - still_s) / moves_s, 0.0, 1.0));
  }
  return out;
}

/// Where the path is at `time_s`: its last sample before.
double placeAt(const Recording& path, double time_s) {
  const auto after = std::upper_bound(path.time_s.begin(), path.time_s.end(), time_s);
  if (after == path.time_s.begin()) return path.depth_mm.front();
  return path.depth_mm[static_cast<std::size_t>(after - path.time_s.begin()) - 1];
}

QString wordId(const QString& answer) {
  return QStringLiteral("w.") + (answer == QLatin1String("beyond_practice") ? QStringLiteral("beyond") : answer);
}

}  // namespace

ScreenNurse::ScreenNurse(ScreenHands& hands, session::NurseTraits traits, std::uint64_t seed)
    : hands_(hands),
      traits_(std::move(traits)),
      responder_(traits_.responder, experiments::publishedVoteTerms()),
      random_(seed) {}

void ScreenNurse::live(const ParticipantState& state, const haptics::Sample& felt, double now_s) {
  notice(state, now_s);
  if (moveHand(felt) || now_s_ < busy_until_s_) return;
  const ParticipantState seen = state;  // a press may change it
  act(seen);
}

// What the screens show of what she did: an answer counts for her once they went on.
void ScreenNurse::notice(const ParticipantState& state, double now_s) {
  now_s_ = now_s;
  if (!state.code.isEmpty()) memory_.code = state.code;
  // A level has all of its dots before the next one is shown.
  if (state.screen == Screen::kSpeed) memory_.strokes[state.speed.level] = state.speed.wanted;
  if (state.serial == serial_) return;
  serial_ = state.serial;
  if (state.overlay != ForceOffOverlay::kNone) {
    said_.reset();
    said_rating_ = false;
    hands_.letGo();
  }
  if (std::exchange(said_rating_, false)) ++memory_.ratings;
  if (state.force.sure) said_.reset();  // asked whether she is sure: nothing is said yet
  if (said_) memory_.judgements.push_back(*std::exchange(said_, std::nullopt));
  wait(0.6, 1.2);  // she looks at what is new
}

void ScreenNurse::act(const ParticipantState& state) {
  if (state.overlay != ForceOffOverlay::kNone) {
    hands_.press("nav.continue");
    return wait(1, 2);
  }
  if (state.paused || state.failed) return wait(1, 1);
  switch (state.screen) {
    case Screen::kWelcome: return atWelcome(state.welcome);
    case Screen::kConsent:
      if (!hands_.press("con.agree")) hands_.press("nav.next");
      return wait(4, 8);
    case Screen::kAboutYou: return tellAboutHerself(state.about);
    case Screen::kDeviceCheck: return checkDevice(state.device);
    case Screen::kPractice:
    case Screen::kForce:
      if (!state.feels_force) return insert(state);
      if (state.force.phase == ForceState::Phase::kFeel) {
        again_ = state.force.again;
        return feel();
      }
      return judge(state.force, state.screen == Screen::kPractice);
    case Screen::kSpeed: return insert(state);
    case Screen::kRest:
      wait(15, 40);
      hands_.press("nav.continue");
      return;
    case Screen::kRating: return rate(state.page);
    case Screen::kScale:
      sent_away_ = true;  // of clinical teachers
      return;
    case Screen::kQuestion: return answer(state.question);
    case Screen::kReview: return review(state.review);
    case Screen::kOwnModel: return feelOwnModel(state.own);
    case Screen::kThanks: done_ = hands_.press("thx.done"); return wait(1, 1);
    case Screen::kStopped: sent_away_ = true; return;
    default: return passPage(state.page);
  }
}

// Of text and cards, or of text alone: the first card, then on.
void ScreenNurse::passPage(const PageState& page) {
  const bool asks = !page.cards.empty() && page.chosen.isEmpty();
  hands_.press(asks ? page.cards.front().word : page.primary);
  wait(3, 6);
}

/// One moment of a hand that holds the handle. False: it does not.
bool ScreenNurse::moveHand(const haptics::Sample& felt) {
  if (!hands_.holds()) return false;
  felt_n_ = std::max(felt_n_, felt.force_n);
  const double time_s = now_s_ - path_since_s_;
  if (time_s <= path_.time_s.back()) {
    hands_.moveTo(placeAt(path_, time_s));
  } else {
    hands_.letGo();
    wait(0.5, 1);
  }
  return true;
}

void ScreenNurse::beginStroke(Recording path) {
  path_ = std::move(path);
  path_since_s_ = now_s_;
  felt_n_ = 0;
  hands_.takeHold();
}

void ScreenNurse::wait(double least_s, double most_s) {
  busy_until_s_ = std::max(busy_until_s_, now_s_ + random_.uniform(least_s, most_s));
}

void ScreenNurse::atWelcome(const WelcomeState& welcome) {
  if (done_) return;
  hands_.press(welcome.step == WelcomeState::Step::kStart ? "code.new" : "nav.next");
  wait(2, 4);
}

void ScreenNurse::tellAboutHerself(const AboutYouState& about) {
  using Question = AboutYouState::Question;
  if (!about.chosen.isEmpty()) {
    hands_.press("nav.next");
    return wait(1, 2);
  }
  switch (about.question) {
    case Question::kYears: hands_.press("you.years_3"); break;
    case Question::kHand:
      hands_.press(QStringLiteral("you.hand_") + QString::fromStdString(traits_.profile.handedness));
      break;
    case Question::kHaptic: hands_.press("you.haptic_0"); break;
    case Question::kGloves:
    case Question::kComfort: hands_.press("you.yes"); break;
  }
  wait(2, 5);
}

void ScreenNurse::checkDevice(DeviceStep step) {
  switch (step) {
    case DeviceStep::kReady: hands_.press("nav.next"); return wait(1, 2);
    case DeviceStep::kWrong:
    case DeviceStep::kLost: hands_.press("nav.repeat"); return wait(2, 4);
    case DeviceStep::kHold: return beginStroke(pathOf(1.5, 30, 60, 0.3));
    default: return wait(0.2, 0.4);
  }
}

void ScreenNurse::insert(const ParticipantState& state) {
  const auto level = traits_.levels.find(state.speed.level.toStdString());
  if (level == traits_.levels.end()) {
    sent_away_ = true;
    return;
  }
  const bool practice = state.screen == Screen::kPractice;
  int& tries = tries_[{state.speed.level, practice ? -1 - state.speed.recorded : state.speed.recorded}];
  const bool too_short = tries++ == 0 && random_.uniform() < traits_.stops_early;
  const auto& good = practice ? level->second.practice : level->second.strokes;
  beginStroke(too_short ? level->second.too_short : good[static_cast<std::size_t>(state.speed.recorded) % good.size()]);
}

void ScreenNurse::feel() {
  const bool still = !again_ && random_.uniform() < traits_.holds_still;
  beginStroke(pathOf(0.4, still ? 0.1 : random_.uniform(35, 55), random_.uniform(30, 80), 0.3));
}

void ScreenNurse::judge(const ForceState& force, bool practice) {
  if (force.phase != ForceState::Phase::kAnswer) return wait(0.1, 0.2);
  if (force.chosen.isEmpty()) {
    hands_.press(wordId(wordFor(felt_n_)));
    return wait(0.5, 1);
  }
  if (force.asks_stop && force.stops != (percept_n_ >= traits_.responder.stop_from_n)) {
    hands_.press("for.stop");
    return wait(0.3, 0.6);
  }
  if (hands_.press(force.sure ? "for.sure_yes" : "nav.confirm") && !practice) said_ = force.chosen;
  wait(0.8, 1.2);
}

QString ScreenNurse::wordFor(double felt_n) {
  const session::Response response = responder_.judge(felt_n, random_);
  percept_n_ = response.percept_n;
  using Kind = study::ForceJudgement::Kind;
  if (response.kind == Kind::kNotFelt) return QStringLiteral("not_felt");
  if (response.kind == Kind::kBeyondPractice) return QStringLiteral("beyond_practice");
  return QString::fromStdString(response.term);
}

QString ScreenNurse::replyTo(int item) const {
  for (const study::Answer& answer : traits_.answers) {
    if (answer.item == item && answer.status == study::Answer::Status::kAnswered) {
      return QString::fromStdString(answer.term);
    }
  }
  return QStringLiteral("cant_tell");
}

QString ScreenNurse::besides(const QString& word) const {
  const auto words = experiments::publishedVoteTerms();
  const auto at = std::find(words.begin(), words.end(), word.toStdString());
  if (at == words.end()) return word;
  return QString::fromStdString(at == words.begin() ? words[1] : *std::prev(at));
}

void ScreenNurse::answer(const QuestionState& question) {
  const QString right = replyTo(question.item);
  if (question.from_review) regrets_.erase(question.item);
  const auto regret = regrets_.find(question.item);
  QString word = regret == regrets_.end() ? right : besides(right);
  const bool first = memory_.replies.find(question.item) == memory_.replies.end();
  if (first && regret == regrets_.end() && random_.uniform() < traits_.second_thoughts) {
    regrets_[question.item] = right;
    word = besides(right);
  }
  if (question.chosen != word) {
    hands_.press(wordId(word));
    memory_.replies[question.item] = word;
    return wait(0.5, 1);
  }
  hands_.press("nav.confirm");
  wait(1.5, 7);
}

void ScreenNurse::rate(const PageState& page) {
  const bool effort = page.sentence.id == QLatin1String("rate.effort");
  wait(1, 3);
  if (page.chosen.isEmpty()) {
    hands_.press(nurse::plain(QString::number(effort ? 2 : 6)));
  } else if (hands_.press(page.primary) && !effort) {
    said_rating_ = true;
  }
}

void ScreenNurse::review(const ReviewState& shown) {
  wait(1, 3);
  if (shown.sealed) {
    hands_.press("nav.next");
    return;
  }
  for (const auto& [item, right] : regrets_) {
    if (hands_.pressCell(item)) return;
  }
  if (hands_.press("nav.next")) return;
  if (!regrets_.empty()) {
    hands_.press("nav.back");
    return;
  }
  if (hands_.press("nav.seal")) memory_.sealed = true;
}

void ScreenNurse::feelOwnModel(const OwnModelState& own) {
  wait(0.5, 1);
  if (!own.unavailable.isEmpty()) {
    hands_.press("nav.next");
    return;
  }
  if (!own.ready) return;
  if (felt_region_ != own.number) {
    felt_region_ = own.number;
    marked_ = false;
    return beginStroke(pathOf(0.3, 40, 40, 0.3));
  }
  constexpr int kMarkedRegion = 2;
  if (own.number == kMarkedRegion && !marked_) {
    marked_ = hands_.press("own.mark");
    if (marked_) ++memory_.marks;
    return;
  }
  const QString word = own.number == 1 ? QStringLiteral("lighter") : QStringLiteral("right");
  if (own.chosen != word) {
    hands_.press(QStringLiteral("own.") + word);
    return;
  }
  if (hands_.press("nav.next")) {
    const std::pair<QString, QString> said(own.region, word);
    if (memory_.own_regions.empty() || memory_.own_regions.back() != said) memory_.own_regions.push_back(said);
  }
}

}  // namespace tactus::workbench
