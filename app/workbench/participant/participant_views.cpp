#include "app/workbench/participant/participant_views.h"

#include <QApplication>
#include <QGuiApplication>
#include <QInputDevice>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <QWidget>
#include <QWindow>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/arrival_screens.h"
#include "app/workbench/participant/screens/device_screens.h"
#include "app/workbench/participant/screens/page_screen.h"
#include "app/workbench/participant/screens/panels.h"
#include "app/workbench/participant/screens/question_screens.h"
#include "app/workbench/participant/screens/review_screen.h"
#include "app/workbench/participant/screens/thanks_screen.h"

namespace tactus::workbench {

namespace {

/// The screen of the course whose widget shows `state`: the practice is done on the screens that it is for.
ParticipantScreen shownAs(const ParticipantState& state) {
  if (state.screen != ParticipantScreen::kPractice) return state.screen;
  return state.feels_force ? ParticipantScreen::kForce : ParticipantScreen::kSpeed;
}

/// What covers the screen: the id of its sentence, or empty.
QString coverOf(const ParticipantState& state) {
  switch (state.overlay) {
    case ForceOffOverlay::kForceOff:
    case ForceOffOverlay::kCalled: return QStringLiteral("off.done");
    case ForceOffOverlay::kWithdraw: return QStringLiteral("off.withdraw");
    case ForceOffOverlay::kLeaving: return QStringLiteral("nav.wait");
    case ForceOffOverlay::kNone: break;
  }
  if (state.failed) return QStringLiteral("err.save");
  return state.paused ? QStringLiteral("err.paused") : QString();
}

}  // namespace

ParticipantViews::ParticipantViews(ParticipantController& course, nurse::Look& look, ParticipantWindow& window)
    : course_(course), look_(look), window_(window) {
  qApp->installEventFilter(this);
  connect(&course_, &ParticipantController::changed, this, &ParticipantViews::show);
  show();
}

void ParticipantViews::show() {
  const ParticipantState& state = course_.state();
  look_.setAbout(state.procedure, state.form);
  look_.setLanguage(nurse::Language{state.language});
  look_.setTextPercent(state.text_percent);
  if (shown_ == nullptr || shows_ != shownAs(state)) {
    shows_ = shownAs(state);
    shown_ = made(state);
    connect(shown_, &nurse::ScreenFrame::picked, &course_, &ParticipantController::choose);
    connect(shown_, &nurse::ScreenFrame::back, &course_, &ParticipantController::back);
    window_.setScreen(shown_);
  }
  shown_->setState(state);
  window_.setArmed(state.armed);
  showOverlay();
  if (state.serial != painted_) window_.update();
}

nurse::ScreenFrame* ParticipantViews::made(const ParticipantState& state) {
  using Screen = ParticipantScreen;
  // Back and the cards go to the course from every screen; the primary button too, but at the end.
  const auto goesOn = [this](auto* screen) {
    connect(screen, &nurse::ScreenFrame::primary, &course_, &ParticipantController::next);
    return screen;
  };
  const auto ends = [this](auto* screen) {
    connect(screen, &nurse::ScreenFrame::primary, this, &ParticipantViews::end);
    return screen;
  };
  switch (shownAs(state)) {
    case Screen::kWelcome: {
      auto* welcome = goesOn(new nurse::WelcomeScreen(look_));
      connect(welcome, &nurse::WelcomeScreen::languagePicked, &course_, &ParticipantController::setLanguage);
      connect(welcome, &nurse::WelcomeScreen::textSizePicked, &course_, &ParticipantController::setTextPercent);
      connect(welcome, &nurse::WelcomeScreen::newHere, &course_, &ParticipantController::newHere);
      connect(welcome, &nurse::WelcomeScreen::teacherHere, &course_, &ParticipantController::teacherHere);
      connect(welcome, &nurse::WelcomeScreen::codeEntered, &course_, &ParticipantController::enterCode);
      return welcome;
    }
    case Screen::kConsent: {
      auto* consent = goesOn(new nurse::ConsentScreen(look_));
      connect(consent, &nurse::ConsentScreen::declined, &course_, &ParticipantController::decline);
      return consent;
    }
    case Screen::kDeviceCheck: return goesOn(new nurse::DeviceCheckScreen(look_));
    case Screen::kPractice:
    case Screen::kSpeed: {
      auto* strokes = goesOn(new nurse::StrokeScreen(look_));
      connect(&course_, &ParticipantController::handMoved, strokes, &nurse::StrokeScreen::setDepth);
      return strokes;
    }
    case Screen::kForce: {
      auto* force = goesOn(new nurse::ForceScreen(look_));
      connect(force, &nurse::ForceScreen::feelAgain, &course_, &ParticipantController::feelAgain);
      return force;
    }
    case Screen::kGlossary: return goesOn(new nurse::GlossaryScreen(look_));
    case Screen::kQuestion: return goesOn(new nurse::QuestionScreen(look_));
    case Screen::kReview: {
      auto* review = goesOn(new nurse::ReviewScreen(look_));
      review->setPage(review_page_);
      connect(review, &nurse::ReviewScreen::cellPicked, this, [this, review](int item) {
        review_page_ = review->page();
        course_.changeItem(item);
      });
      return review;
    }
    case Screen::kOwnModel: {
      auto* own = goesOn(new nurse::OwnModelScreen(look_));
      connect(own, &nurse::OwnModelScreen::marked, &course_, &ParticipantController::mark);
      connect(&course_, &ParticipantController::handMoved, own,
              [this, own](double position_mm) { own->setDepth(course_.state().own.from_mm + position_mm); });
      return own;
    }
    case Screen::kThanks: return ends(new nurse::ThanksScreen(look_));
    default: break;  // text and cards
  }
  auto* const page = new nurse::PageScreen(look_);
  return state.page.is_end ? ends(page) : goesOn(page);
}

void ParticipantViews::end() {
  review_page_ = 0;
  course_.next();
  emit finished();
}

void ParticipantViews::showOverlay() {
  const QString cover = coverOf(course_.state());
  if (cover == cover_) return;
  cover_ = cover;
  if (cover.isEmpty()) {
    window_.uncover();
  } else if (cover == QLatin1String("off.done")) {
    auto* panel = new nurse::ForceOffPanel(look_, course_.state().languages);
    connect(panel, &nurse::ForceOffPanel::languagePicked, &course_, &ParticipantController::setLanguage);
    connect(panel, &nurse::ForceOffPanel::textSizePicked, &course_, &ParticipantController::setTextPercent);
    connect(panel, &nurse::ForceOffPanel::goOn, &course_, &ParticipantController::resume);
    connect(panel, &nurse::ForceOffPanel::callResearcher, this, [this] {
      course_.callResearcher();
      QApplication::beep();
    });
    connect(panel, &nurse::ForceOffPanel::stopForToday, &course_, &ParticipantController::stopForToday);
    connect(panel, &nurse::ForceOffPanel::withdraw, &course_, &ParticipantController::askWithdraw);
    connect(&course_, &ParticipantController::changed, panel, [this, panel] { panel->setState(course_.state()); });
    panel->setState(course_.state());
    window_.cover(panel);
  } else if (cover == QLatin1String("off.withdraw")) {
    auto* panel = new nurse::WithdrawPanel(look_);
    connect(panel, &nurse::WithdrawPanel::keep, &course_, &ParticipantController::keepData);
    connect(panel, &nurse::WithdrawPanel::withdraw, &course_, &ParticipantController::withdraw);
    window_.cover(panel);
  } else {
    window_.cover(new nurse::NoticePanel(look_, nurse::phrase(cover)));
  }
}

// A finger that nothing takes as a touch comes as a mouse.
void ParticipantViews::tellMeans(const QEvent& event) {
  using session::InputMeans;
  if (event.type() == QEvent::KeyPress) {
    course_.usesMeans(InputMeans::kKeyboard);
  } else if (event.type() == QEvent::TouchBegin) {
    course_.usesMeans(InputMeans::kTouch);
  } else if (event.type() == QEvent::MouseButtonPress) {
    const auto& press = static_cast<const QMouseEvent&>(event);
    const bool touch = press.deviceType() == QInputDevice::DeviceType::TouchScreen;
    course_.usesMeans(touch ? InputMeans::kTouch : InputMeans::kMouse);
  }
}

// The researcher's monitor is a window of the same program.
bool ParticipantViews::isHers(const QObject& watched) const {
  if (window_.windowHandle() != nullptr && &watched == static_cast<const QObject*>(window_.windowHandle())) return true;
  const auto* widget = qobject_cast<const QWidget*>(&watched);
  while (widget != nullptr && widget != &window_) widget = widget->parentWidget();
  return widget != nullptr;
}

bool ParticipantViews::eventFilter(QObject* watched, QEvent* event) {
  const bool input = dynamic_cast<const QInputEvent*>(event) != nullptr;
  // A release ends a press wherever it comes.
  if (input && event->type() != QEvent::KeyRelease && !isHers(*watched)) return QObject::eventFilter(watched, event);
  tellMeans(*event);
  switch (event->type()) {
    case QEvent::Paint:
      if (watched == &window_ && painted_ != course_.state().serial && !frame_pending_) {
        // The frame is on the screen once its events are through.
        frame_pending_ = true;
        QTimer::singleShot(0, this, &ParticipantViews::frameWasPainted);
      }
      break;
    case QEvent::KeyPress:
      keys_.insert(static_cast<QKeyEvent*>(event)->key());
      tellHeld();
      break;
    case QEvent::KeyRelease:
      if (!static_cast<QKeyEvent*>(event)->isAutoRepeat()) keys_.remove(static_cast<QKeyEvent*>(event)->key());
      tellHeld();
      break;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::TouchBegin:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel: tellHeld(); break;
    case QEvent::ApplicationStateChange:
      keys_.clear();  // releases go elsewhere
      break;
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

void ParticipantViews::tellHeld() {
  course_.setInputHeld(!keys_.isEmpty() || QGuiApplication::mouseButtons() != Qt::NoButton);
}

void ParticipantViews::frameWasPainted() {
  frame_pending_ = false;
  painted_ = course_.state().serial;
  course_.painted(painted_);
}

}  // namespace tactus::workbench
