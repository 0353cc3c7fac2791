#include "app/workbench/participant/participant_window.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <QWindow>
#include <algorithm>
#include <utility>

#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench {
namespace {

// As far as the virtual device reaches.
constexpr double kLeastMm = -10;
constexpr double kMostMm = 150;
constexpr double kKeyMm = 4;  // with a key that repeats 25 times a second: 100 mm/s, a fast insertion

}  // namespace

VirtualHand::VirtualHand(ParticipantWindow& window, const nurse::Look& look, DeviceSession& device)
    : window_(window), look_(look), device_(device) {
  QCoreApplication::instance()->installEventFilter(this);
}

void VirtualHand::setWanted(bool wanted) {
  if (wanted == wanted_) return;
  wanted_ = wanted;
  if (!wanted && !holds()) letGo();
}

bool VirtualHand::eventFilter(QObject* watched, QEvent* event) {
  auto* const widget = qobject_cast<QWidget*>(watched);
  if (holds() && window_.isCovered()) letGo();
  if (from_px_ && watched == window_.windowHandle()) follow(*event);
  const bool here = widget != nullptr && widget->window() == &window_ && !window_.isCovered();
  if (!here || !(wanted_ || holds()) || !device_.isHandLive()) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      // Buttons and cards take their presses; what reaches the window is meant for nothing else.
      if (wanted_ && watched == &window_ && press(static_cast<const QMouseEvent&>(*event))) return true;
      break;
    case QEvent::WindowDeactivate:
      if (holds()) letGo();
      break;
    case QEvent::KeyPress: return key(static_cast<const QKeyEvent&>(*event), true);
    case QEvent::KeyRelease: return key(static_cast<const QKeyEvent&>(*event), false);
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

bool VirtualHand::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  from_px_ = event.globalPosition().x();
  device_.setHeld(true);
  return true;
}

// At the window itself: what the press went to may be hidden meanwhile, and gets no more events.
void VirtualHand::follow(const QEvent& event) {
  if (event.type() == QEvent::MouseMove) drag(static_cast<const QMouseEvent&>(event));
  if (event.type() == QEvent::MouseButtonRelease) letGo();
}

void VirtualHand::drag(const QMouseEvent& event) {
  constexpr double kScaleMm = 100;
  moveTo((event.globalPosition().x() - *from_px_) / look_.mm(kScaleMm) * kScaleMm);
}

void VirtualHand::letGo() {
  from_px_.reset();
  space_ = false;
  device_.setHeld(false);
  moveTo(0);
}

bool VirtualHand::key(const QKeyEvent& event, bool down) {
  switch (event.key()) {
    case Qt::Key_Space:
      if (event.isAutoRepeat()) return true;
      if (!wanted_ && down) return false;
      space_ = down;
      device_.setHeld(down);
      if (!wanted_) letGo();
      return true;
    case Qt::Key_Right:
    case Qt::Key_Left:
      if (down) moveTo(device_.targetMm() + (event.key() == Qt::Key_Right ? kKeyMm : -kKeyMm));
      return true;
    default: return false;
  }
}

void VirtualHand::moveTo(double position_mm) { device_.setTarget(std::clamp(position_mm, kLeastMm, kMostMm)); }

using nurse::ButtonKind;
using nurse::phrase;
using nurse::TextRole;

LeavePanel::LeavePanel(const nurse::Look& look, QWidget* parent)
    : PanelCard(look, parent), passphrase_(new QLineEdit(this)) {
  addText(TextRole::kLead, phrase(QStringLiteral("leave.ask")));
  passphrase_->setEchoMode(QLineEdit::Password);
  addWidget(passphrase_);
  setFocusProxy(passphrase_);
  wrong_ = addText(TextRole::kBody, phrase(QStringLiteral("leave.wrong")));
  wrong_->hide();
  const nurse::Button* leave = addButton(ButtonKind::kPlain, phrase(QStringLiteral("leave.button")));
  const nurse::Button* stay_button = addButton(ButtonKind::kPrimary, phrase(QStringLiteral("nav.back")));
  const auto enter = [this] { emit entered(passphrase_->text()); };
  connect(passphrase_, &QLineEdit::returnPressed, this, enter);
  connect(passphrase_, &QLineEdit::textEdited, wrong_, &QWidget::hide);
  connect(leave, &QAbstractButton::clicked, this, enter);
  connect(stay_button, &QAbstractButton::clicked, this, &LeavePanel::stay);
  connect(&look, &nurse::Look::changed, this, &LeavePanel::followLook);
  followLook();
}

void LeavePanel::followLook() {
  constexpr double kFieldMm = 14;
  passphrase_->setFont(look().font());
  passphrase_->setMinimumHeight(look().mm(kFieldMm));
  passphrase_->setAccessibleName(look().say(phrase(QStringLiteral("leave.ask"))));
}

void LeavePanel::refuse() {
  passphrase_->clear();
  wrong_->show();
}

ForceOffKeys::ForceOffKeys(QObject* parent) : QObject(parent) {}

void ForceOffKeys::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (on) {
    QCoreApplication::instance()->installEventFilter(this);
  } else {
    QCoreApplication::instance()->removeEventFilter(this);
  }
}

bool ForceOffKeys::eventFilter(QObject* watched, QEvent* event) {
  const bool asks = event->type() == QEvent::ShortcutOverride;
  const bool press = event->type() == QEvent::KeyPress;
  if (!asks && !press && event->type() != QEvent::KeyRelease) return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() != Qt::Key_Escape) return QObject::eventFilter(watched, event);
  // Without an answer to this question a shortcut on Esc anywhere takes the key, and no press follows.
  event->accept();
  if (press && !key->isAutoRepeat()) emit pressed();
  return true;
}

ParticipantWindow::ParticipantWindow(nurse::Look& look, std::function<void()> force_off)
    : look_(look),
      force_off_(std::move(force_off)),
      keys_(new ForceOffKeys(this)),
      force_off_button_(
          new nurse::Button(look, nurse::ButtonKind::kForceOff, nurse::phrase(QStringLiteral("off.button")), this)),
      pause_button_(
          new nurse::Button(look, nurse::ButtonKind::kPlain, nurse::phrase(QStringLiteral("off.pause")), this)),
      leave_button_(
          new nurse::Button(look, nurse::ButtonKind::kQuiet, nurse::phrase(QStringLiteral("leave.button")), this)) {
  setWindowTitle(QStringLiteral("Tactus"));
  setWindowFlag(Qt::FramelessWindowHint);
  // The force ends with the press; who presses does not wait for the release.
  connect(force_off_button_, &nurse::Button::pressed, this, [this] { takeForceAway(ForceOffCause::kButton); });
  connect(pause_button_, &nurse::Button::clicked, this, &ParticipantWindow::pauseAsked);
  pause_button_->keepOneLine();
  leave_button_->hide();
  connect(leave_button_, &nurse::Button::clicked, this, &ParticipantWindow::leaveAsked);
  connect(keys_, &ForceOffKeys::pressed, this, [this] { takeForceAway(ForceOffCause::kEscape); });
  connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
    if (isVisible() && state != Qt::ApplicationActive) takeForceAway(ForceOffCause::kDeactivated);
  });
  connect(qGuiApp, &QGuiApplication::screenRemoved, this, [this] {
    if (isVisible()) takeForceAway(ForceOffCause::kScreenGone);
  });
  connect(&look_, &nurse::Look::changed, this, &ParticipantWindow::arrange);
}

ParticipantWindow::~ParticipantWindow() { force_off_(); }

void ParticipantWindow::showOn(QScreen& screen) {
  look_.setScreen(screen);
  // Without a window manager a full screen keeps the size of its layout.
  setGeometry(screen.geometry());
  showFullScreen();
  activateWindow();
  keys_->setOn(true);
  giveFocus();
}

void ParticipantWindow::leave() {
  force_off_();
  keys_->setOn(false);
  leaving_ = true;
  close();
  leaving_ = false;
}

void ParticipantWindow::setScreen(QWidget* screen) { put(screen_, screen); }

void ParticipantWindow::cover(QWidget* cover) { put(cover_, cover); }

void ParticipantWindow::uncover() { put(cover_, nullptr); }

void ParticipantWindow::askResearcher(QWidget* question) { put(question_, question); }

void ParticipantWindow::endQuestion() { put(question_, nullptr); }

void ParticipantWindow::put(QWidget*& place, QWidget* widget) {
  if (widget == place) return;
  if (place != nullptr) {
    place->hide();
    place->deleteLater();  // it may be in the middle of its own signal
  }
  place = widget;
  if (widget != nullptr) {
    widget->setParent(this);
    widget->show();
  }
  arrange();
  giveFocus();
}

void ParticipantWindow::takeForceAway(ForceOffCause cause) {
  force_off_();
  if (!leaving_) emit forceOff(cause);
}

bool ParticipantWindow::event(QEvent* event) {
  if (event->type() == QEvent::WindowDeactivate && isVisible()) takeForceAway(ForceOffCause::kDeactivated);
  return QWidget::event(event);
}

void ParticipantWindow::closeEvent(QCloseEvent* event) {
  if (leaving_) return;
  event->ignore();
  takeForceAway(ForceOffCause::kClosing);
}

void ParticipantWindow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void ParticipantWindow::paintEvent(QPaintEvent* /*event*/) { QPainter(this).fillRect(rect(), nurse::colors::kGround); }

void ParticipantWindow::arrange() {
  const QSize corner = nurse::forceOffCorner(look_);
  const int margin = nurse::frameMargin(look_);
  for (QWidget* layer : {screen_, cover_, question_}) {
    if (layer == nullptr) continue;
    layer->setGeometry(rect());
    layer->raise();
    layer->setEnabled(layer == top());
  }
  // In the corner, where it is not pressed by accident.
  const QSize leave = leave_button_->sizeHint();
  leave_button_->setGeometry(QRect(QPoint(margin, height() - margin - leave.height()), leave));
  leave_button_->setVisible(cover_ != nullptr && question_ == nullptr);
  leave_button_->raise();
  force_off_button_->setGeometry(QRect(QPoint(width() - margin - corner.width(), margin), corner));
  force_off_button_->raise();
  force_off_button_->setVisible(armed_);
  const QSize pause = pause_button_->sizeHint();
  pause_button_->setGeometry(QRect(QPoint(width() - margin - pause.width(), margin), pause));
  pause_button_->setVisible(!armed_ && cover_ == nullptr && question_ == nullptr);
  pause_button_->raise();
}

void ParticipantWindow::setArmed(bool armed) {
  if (std::exchange(armed_, armed) != armed) arrange();
}

QWidget* ParticipantWindow::top() const {
  if (question_ != nullptr) return question_;
  return cover_ != nullptr ? cover_ : screen_;
}

void ParticipantWindow::giveFocus() {
  if (QWidget* const layer = top()) layer->setFocus(Qt::OtherFocusReason);
}

}  // namespace tactus::workbench
