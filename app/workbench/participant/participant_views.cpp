#include "app/workbench/participant/participant_views.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QInputDevice>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPrinter>
#include <QPrinterInfo>
#include <QTimer>
#include <QWidget>
#include <QWindow>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/closing_screens.h"
#include "app/workbench/participant/screens/force_curve.h"
#include "app/workbench/participant/screens/glossary_screen.h"
#include "app/workbench/participant/screens/panels.h"
#include "app/workbench/participant/shown_state.h"

namespace tactus::workbench {

// Prints the force–depth curve of one participant on the default printer, without a dialog.

bool canPrint();
/// A page with the curve; nothing without a printer.
void printCurve(const nurse::ForceCurve& curve);

namespace {

constexpr double kHeightShare = 0.6;  // of the width of the page
constexpr double kTextShare = 0.018;

}  // namespace

bool canPrint() { return !QPrinterInfo::defaultPrinterName().isEmpty(); }

void printCurve(const nurse::ForceCurve& curve) {
  if (!canPrint()) return;
  QPrinter printer(QPrinterInfo::defaultPrinter(), QPrinter::HighResolution);
  printer.setPageOrientation(QPageLayout::Landscape);
  QPainter painter;
  if (!painter.begin(&printer)) return;
  const QRectF page(QPointF(), printer.pageRect(QPrinter::DevicePixel).size());
  QFont font = curve.font();
  font.setPixelSize(static_cast<int>(page.width() * kTextShare));
  painter.setFont(font);
  curve.draw(painter, QRectF(0, 0, page.width(), page.width() * kHeightShare));
}

ParticipantViews::ParticipantViews(ParticipantController& course, nurse::Look& look, ParticipantWindow& window)
    : course_(course), look_(look), window_(window) {
  qApp->installEventFilter(this);
  connect(&course_, &ParticipantController::changed, this, &ParticipantViews::show);
  connect(&course_, &ParticipantController::handMoved, this, [this](double position_mm) {
    if (auto* strokes = qobject_cast<nurse::StrokeScreen*>(shown_)) strokes->setDepth(position_mm);
    if (auto* own = qobject_cast<nurse::OwnModelScreen*>(shown_))
      own->setDepth(course_.state().own.from_mm + position_mm);
  });
  show();
}

void ParticipantViews::show() {
  const ParticipantState& state = course_.state();
  if (const auto language = nurse::languageWithId(state.language)) look_.setLanguage(*language);
  look_.setTextPercent(state.text_percent);
  switch (state.screen) {
    case ParticipantScreen::kWelcome: showWelcome(); break;
    case ParticipantScreen::kConsent: showConsent(); break;
    case ParticipantScreen::kAboutYou: showAboutYou(); break;
    case ParticipantScreen::kDeviceCheck: showDeviceCheck(); break;
    case ParticipantScreen::kPractice: state.feels_force ? showForce() : showStrokes(); break;
    case ParticipantScreen::kSpeed: showStrokes(); break;
    case ParticipantScreen::kForce: showForce(); break;
    case ParticipantScreen::kRest: showRest(); break;
    case ParticipantScreen::kGlossary: showGlossary(); break;
    case ParticipantScreen::kQuestion: showQuestion(); break;
    case ParticipantScreen::kRating:
    case ParticipantScreen::kScale: showScale(); break;
    case ParticipantScreen::kReview: showReview(); break;
    case ParticipantScreen::kOwnModel: showOwnModel(); break;
    case ParticipantScreen::kThanks: showThanks(); break;
    case ParticipantScreen::kStopped: showStopped(); break;
  }
  if (state.screen != ParticipantScreen::kWelcome) {
    entering_code_ = false;
    shown_->setMayGoBack(state.can_go_back);
  }
  showOverlay();
  if (state.serial != painted_) window_.update();
}

template <class Screen>
Screen* ParticipantViews::screen(const std::function<void(Screen&)>& made) {
  if (auto* same = qobject_cast<Screen*>(shown_)) return same;
  auto* fresh = new Screen(look_);
  // Screens of several pages say `left` where others say `back`.
  if constexpr (requires { &Screen::left; }) {
    connect(fresh, &Screen::left, &course_, &ParticipantController::back);
  } else {
    connect(fresh, &nurse::ScreenFrame::back, &course_, &ParticipantController::back);
  }
  if constexpr (requires { &Screen::picked; })
    connect(fresh, &Screen::picked, &course_, &ParticipantController::choose);
  made(*fresh);
  shown_ = fresh;
  window_.setScreen(fresh);
  return fresh;
}

void ParticipantViews::showWelcome() {
  auto* welcome = screen<nurse::WelcomeScreen>([this](nurse::WelcomeScreen& made) {
    connect(&made, &nurse::WelcomeScreen::languagePicked, &course_,
            [this](nurse::Language language) { course_.setLanguage(nurse::idOf(language)); });
    connect(&made, &nurse::WelcomeScreen::textSizePicked, &course_, &ParticipantController::setTextPercent);
    connect(&made, &nurse::WelcomeScreen::newHere, &course_, &ParticipantController::newHere);
    connect(&made, &nurse::WelcomeScreen::teacherHere, &course_, &ParticipantController::teacherHere);
    connect(&made, &nurse::WelcomeScreen::codeEntered, &course_, &ParticipantController::enterCode);
    connect(&made, &nurse::WelcomeScreen::goOn, &course_, &ParticipantController::next);
    const auto enter = [this](bool entering) {
      entering_code_ = entering;
      show();
    };
    connect(&made, &nurse::WelcomeScreen::haveCode, this, [enter] { enter(true); });
    connect(&made, &nurse::ScreenFrame::back, this, [enter] { enter(false); });
  });
  welcome->setState(shownWelcome(course_.state(), entering_code_));
}

void ParticipantViews::showConsent() {
  auto* consent = screen<nurse::ConsentScreen>([this](nurse::ConsentScreen& made) {
    connect(&made, &nurse::ConsentScreen::agreed, &course_, &ParticipantController::next);
    connect(&made, &nurse::ConsentScreen::declined, &course_, &ParticipantController::decline);
  });
  consent->setState(shownConsent(course_.state()));
}

void ParticipantViews::showAboutYou() {
  auto* about = screen<nurse::AboutYouScreen>([this](nurse::AboutYouScreen& made) {
    connect(&made, &nurse::AboutYouScreen::confirmed, &course_, &ParticipantController::next);
  });
  about->setState(shownAboutYou(course_.state()));
}

void ParticipantViews::showDeviceCheck() {
  auto* check = screen<nurse::DeviceCheckScreen>([this](nurse::DeviceCheckScreen& made) { goOnWith(made); });
  check->setState(shownDeviceCheck(course_.state()));
}

void ParticipantViews::showStrokes() {
  auto* strokes = screen<nurse::StrokeScreen>([this](nurse::StrokeScreen& made) { goOnWith(made); });
  strokes->setState(shownStrokes(course_.state()));
}

void ParticipantViews::showForce() {
  auto* force = screen<nurse::ForceScreen>([this](nurse::ForceScreen& made) {
    connect(&made, &nurse::ForceScreen::confirmed, &course_, &ParticipantController::next);
    connect(&made, &nurse::ForceScreen::feelAgain, &course_, &ParticipantController::feelAgain);
  });
  force->setState(shownForce(course_.state()));
}

void ParticipantViews::showRest() {
  screen<nurse::RestScreen>([this](nurse::RestScreen& made) {
    goOnWith(made);
  })->setSimulated(course_.state().simulated);
}

void ParticipantViews::showGlossary() {
  auto* glossary = screen<nurse::GlossaryScreen>([this](nurse::GlossaryScreen& made) {
    connect(&made, &nurse::GlossaryScreen::finished, &course_, &ParticipantController::next);
  });
  glossary->setSimulated(course_.state().simulated);
}

void ParticipantViews::showQuestion() {
  auto* question = screen<nurse::QuestionScreen>([this](nurse::QuestionScreen& made) {
    connect(&made, &nurse::QuestionScreen::confirmed, &course_, &ParticipantController::next);
  });
  question->setState(shownQuestion(course_.state()));
}

void ParticipantViews::showReview() {
  auto* review = screen<nurse::ReviewScreen>([this](nurse::ReviewScreen& made) {
    made.setPage(review_page_);
    connect(&made, &nurse::ReviewScreen::seal, &course_, &ParticipantController::next);
    connect(&made, &nurse::ReviewScreen::goOn, &course_, &ParticipantController::next);
    connect(&made, &nurse::ReviewScreen::cellPicked, this, [this, shown = &made](int item) {
      review_page_ = shown->page();
      course_.changeItem(item);
    });
  });
  review->setState(shownReview(course_.state()));
}

void ParticipantViews::showScale() {
  auto* scale = screen<nurse::ScaleScreen>([this](nurse::ScaleScreen& made) {
    connect(&made, &nurse::ScaleScreen::confirmed, &course_, &ParticipantController::next);
  });
  scale->setState(shownScale(course_.state()));
}

void ParticipantViews::showOwnModel() {
  auto* own = screen<nurse::OwnModelScreen>([this](nurse::OwnModelScreen& made) {
    connect(&made, &nurse::OwnModelScreen::marked, &course_, &ParticipantController::mark);
    connect(&made, &nurse::OwnModelScreen::confirmed, &course_, &ParticipantController::next);
  });
  own->setState(shownOwnModel(course_.state()));
}

void ParticipantViews::showThanks() {
  auto* thanks = screen<nurse::ThanksScreen>([this](nurse::ThanksScreen& made) {
    connect(&made, &nurse::ThanksScreen::print, this, [shown = &made] { printCurve(shown->curve()); });
    connect(&made, &nurse::ThanksScreen::done, this, &ParticipantViews::end);
  });
  thanks->setState({course_.state().thanks.curve, canPrint(), course_.state().simulated});
}

void ParticipantViews::showStopped() {
  auto* stopped = screen<nurse::StoppedScreen>([this](nurse::StoppedScreen& made) {
    connect(&made, &nurse::ScreenFrame::primary, this, &ParticipantViews::end);
  });
  stopped->setState(shownStopped(course_.state()));
}

void ParticipantViews::goOnWith(nurse::ScreenFrame& made) {
  connect(&made, &nurse::ScreenFrame::primary, &course_, &ParticipantController::next);
}

void ParticipantViews::end() {
  review_page_ = 0;
  course_.next();
  emit finished();
}

void ParticipantViews::showOverlay() {
  const QString cover = shownCover(course_.state());
  if (cover == cover_) return;
  cover_ = cover;
  if (cover.isEmpty()) {
    window_.uncover();
  } else if (cover == QLatin1String("off.done")) {
    auto* panel = new nurse::ForceOffPanel(look_);
    connect(panel, &nurse::ForceOffPanel::goOn, &course_, &ParticipantController::resume);
    connect(panel, &nurse::ForceOffPanel::callResearcher, &course_, &ParticipantController::callResearcher);
    connect(panel, &nurse::ForceOffPanel::stopForToday, &course_, &ParticipantController::stopForToday);
    connect(panel, &nurse::ForceOffPanel::withdraw, &course_, &ParticipantController::askWithdraw);
    const auto call = [this, panel] { panel->setCalled(course_.state().overlay == ForceOffOverlay::kCalled); };
    connect(&course_, &ParticipantController::changed, panel, call);
    call();
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
