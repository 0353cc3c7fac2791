#include "app/workbench/feel/feel_status.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QWidget>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_controller.h"

namespace tactus::workbench {
namespace {

constexpr auto kStopKey = Qt::Key_F12;

// Space is a letter there, or chooses something. In a number there is no space.
bool wantsSpace() {
  const QWidget* focus = QApplication::focusWidget();
  return QApplication::activePopupWidget() || QApplication::activeModalWidget() ||
         (focus && (focus->inherits("QLineEdit") || focus->inherits("QTextEdit")));
}

}  // namespace

FeelKeys::FeelKeys(FeelController& feel, QObject* parent) : QObject(parent), feel_(feel) {}

void FeelKeys::setOn(bool on) {
  if (std::exchange(on_, on) == on) return;
  if (on) {
    qApp->installEventFilter(this);
  } else {
    qApp->removeEventFilter(this);
  }
}

bool FeelKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ApplicationDeactivate && !feel_.session().grip().latch) feel_.session().setHeld(false);
  const bool asks = event->type() == QEvent::ShortcutOverride;
  const bool press = event->type() == QEvent::KeyPress || asks;
  if (asking_ || (!press && event->type() != QEvent::KeyRelease)) return QObject::eventFilter(watched, event);
  auto* key = static_cast<QKeyEvent*>(event);
  if (press && key->key() == kStopKey) {
    feel_.stop();
    event->accept();
    return true;
  }
  if (press && key->key() == Qt::Key_Escape) return escape(*watched, *key, asks);
  if (key->key() != Qt::Key_Space) return QObject::eventFilter(watched, event);
  // Whatever has opened since the press, the hand lets go.
  if (!press && !key->isAutoRepeat()) feel_.session().setHeld(false);
  if (wantsSpace()) return QObject::eventFilter(watched, event);
  if (press && !key->isAutoRepeat()) feel_.session().setHeld(true);
  event->accept();
  return true;
}

bool FeelKeys::escape(QObject& watched, QKeyEvent& key, bool asks) {
  if (asks) {
    // Whoever drags something says now that Escape is his.
    asking_ = true;
    key.ignore();
    QCoreApplication::sendEvent(&watched, &key);
    asking_ = false;
    escape_taken_ = key.isAccepted();
    if (escape_taken_) return true;
  }
  if (escape_taken_) return false;
  feel_.stop();
  key.accept();
  return true;
}

namespace {

// The red of the nurse's button (participant/kit/colors.h), in both looks; white on it has 8.2:1.
constexpr QColor kForceOffFill(0x9B, 0x1C, 0x1C);
constexpr int kForceOffHeight = 30;  // px, of the strip

}  // namespace

ForceOffButton::ForceOffButton(QWidget* parent) : QAbstractButton(parent) {
  setText(tr("Force off"));
  setAccessibleName(text());
  setToolTip(tr("Stop the force with the next tick, whatever has the keyboard (F12, or Esc outside a drag)"));
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QString ForceOffButton::keys() const { return tr("Esc · F12"); }

QSize ForceOffButton::sizeHint() const {
  return {QFontMetrics(theme::headingFont()).horizontalAdvance(text()) +
              QFontMetrics(theme::smallFont()).horizontalAdvance(keys()) + 4 * theme::kGrid,
          kForceOffHeight};
}

void ForceOffButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor fill = isDown() ? kForceOffFill.darker(130) : underMouse() ? kForceOffFill.darker(112) : kForceOffFill;
  painter.setPen(hasFocus() ? QPen(theme::ink(), 2) : QPen(Qt::NoPen));
  painter.setBrush(fill);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
  painter.setPen(Qt::white);
  const QRect inside = rect().adjusted(theme::kGrid + 4, 0, -theme::kGrid - 4, 0);
  painter.setFont(theme::headingFont());
  painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, text());
  painter.setFont(theme::smallFont());
  painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter, keys());
}

FeelStatus::FeelStatus(const FeelController& feel, QWidget* parent) : QLabel(parent), feel_(feel) {
  setTextFormat(Qt::PlainText);
  setFont(theme::smallFont());
  connect(&feel_, &FeelController::stateChanged, this, &FeelStatus::showState);
  connect(&feel_, &FeelController::advanced, this, &FeelStatus::showLatency);
  showState();
}

void FeelStatus::showState() {
  const auto device = feel_.device();
  const bool tripped = device && feel_.session().trip();
  setInk(*this, tripped ? theme::errorInk() : theme::mutedInk());
  if (!device) {
    setText(feel_.state() == FeelController::State::kOpening    ? tr("Feel: starting…")
            : feel_.state() == FeelController::State::kStopping ? tr("Feel: stopping…")
                                                                : tr("Feel: stopped"));
  } else {
    const QString name = device->simulated ? tr("simulated device") : workbench::text(device->name);
    setText(tripped ? tr("Feel: tripped, %1").arg(name) : tr("Feel: running, %1").arg(name));
  }
  showLatency();
}

void FeelStatus::showLatency() {
  QString latency;
  if (const auto felt = feel_.isRunning() ? feel_.editLatency() : std::nullopt) {
    latency = tr("felt after %n tick(s)", nullptr, static_cast<int>(felt->last_ticks));
  }
  if (latency == latency_) return;
  latency_ = latency;
  emit latencyChanged(latency);
}

}  // namespace tactus::workbench
