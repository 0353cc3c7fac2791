#include "app/workbench/participant/kit/ring.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QPointer>

#include "app/workbench/participant/kit/colors.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kWidth = 3;
constexpr double kOffset = 2;
constexpr auto kByKeys = "nurse_by_keys";  // of a window

bool movesFocus(const QEvent& event) {
  switch (static_cast<const QKeyEvent&>(event).key()) {
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return true;
    default:
      return false;
  }
}

/// Notes at each window by what means somebody moves in it. The reason that Qt gives with the focus does not tell: a
/// control that is hidden or disabled hands it on "by Tab" too.
class MeansOfMoving : public QObject {
 public:
  explicit MeansOfMoving(QObject* application) : QObject(application) { application->installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (!watched->isWidgetType()) return false;
    switch (event->type()) {
      case QEvent::KeyPress:
        if (movesFocus(*event)) note(static_cast<QWidget*>(watched), true);
        break;
      case QEvent::MouseButtonPress:
      case QEvent::TouchBegin:
      case QEvent::TabletPress:
        note(static_cast<QWidget*>(watched), false);
        break;
      default:
        break;
    }
    return false;
  }

 private:
  static void note(const QWidget* widget, bool by_keys) {
    QWidget* const window = widget->window();
    if (window->property(kByKeys).toBool() == by_keys) return;
    window->setProperty(kByKeys, by_keys);
    if (QWidget* const focus = window->focusWidget()) focus->update();
  }
};

}  // namespace

bool isRinged(const QWidget& control) {
  static QPointer<MeansOfMoving> watch;
  if (!watch) watch = new MeansOfMoving(qApp);
  return control.hasFocus() && control.window()->property(kByKeys).toBool();
}

void giveKeyboardBack(const QWidget& within) {
  const QWidget* const focus = within.window()->focusWidget();
  if (focus == nullptr || (focus != &within && !within.isAncestorOf(focus))) return;
  for (QWidget* up = within.parentWidget(); up != nullptr; up = up->parentWidget()) {
    if (up->focusPolicy() != Qt::NoFocus) return up->setFocus(Qt::OtherFocusReason);
  }
}

void drawRing(QPainter& painter, const QRectF& face, double corner_radius) {
  const double out = kOffset + kWidth / 2;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors::kInk, kWidth));
  painter.drawRoundedRect(face.adjusted(-out, -out, out, out), corner_radius + out, corner_radius + out);
}

}  // namespace tactus::workbench::nurse
