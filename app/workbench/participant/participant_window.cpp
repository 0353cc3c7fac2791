#include "app/workbench/participant/participant_window.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QPainter>
#include <QScreen>
#include <utility>

#include "app/workbench/participant/force_off_keys.h"
#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/colors.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench {

ParticipantWindow::ParticipantWindow(nurse::Look& look, std::function<void()> force_off)
    : look_(look),
      force_off_(std::move(force_off)),
      keys_(new ForceOffKeys(this)),
      force_off_button_(
          new nurse::Button(look, nurse::ButtonKind::kForceOff, nurse::phrase(QStringLiteral("off.button")), this)),
      leave_button_(
          new nurse::Button(look, nurse::ButtonKind::kPlain, nurse::phrase(QStringLiteral("leave.button")), this)) {
  setWindowTitle(QStringLiteral("Tactus"));
  setWindowFlag(Qt::FramelessWindowHint);
  // The force ends with the press; who presses does not wait for the release.
  connect(force_off_button_, &nurse::Button::pressed, this, [this] { takeForceAway(ForceOffCause::kButton); });
  leave_button_->keepOneLine();
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
}

QWidget* ParticipantWindow::top() const {
  if (question_ != nullptr) return question_;
  return cover_ != nullptr ? cover_ : screen_;
}

void ParticipantWindow::giveFocus() {
  if (QWidget* const layer = top()) layer->setFocus(Qt::OtherFocusReason);
}

}  // namespace tactus::workbench
