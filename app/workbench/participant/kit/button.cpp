#include "app/workbench/participant/kit/button.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QPointer>
#include <algorithm>
#include <cmath>

#include "app/workbench/participant/kit/look.h"

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
    case Qt::Key_Down: return true;
    default: return false;
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
      case QEvent::TabletPress: note(static_cast<QWidget*>(watched), false); break;
      default: break;
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

namespace {

constexpr double kButtonHeightMm = 20;
constexpr double kForceOffMm = 25;
constexpr double kLeastWidthMm = 30;
constexpr double kButtonPaddingMm = 4;
constexpr double kButtonCornerMm = 2;
constexpr double kToleranceMm = 10;
constexpr double kButtonWidestMm = 110;  // of a line; longer texts take two
constexpr double kQuietWidestMm = 20;
constexpr double kQuietHeightMm = 12;
constexpr double kChosenEdge = 3;   // px
constexpr double kQuietText = 0.6;  // of the text around
constexpr int kButtonTextFlags = Qt::AlignCenter | Qt::TextWordWrap;

}  // namespace

bool endsNear(const Look& look, const QWidget& control, const QPoint& at) {
  const int reach = look.mm(kToleranceMm);
  return control.rect().adjusted(-reach, -reach, reach, reach).contains(at);
}

Button::Button(const Look& look, ButtonKind kind, const Phrase& text, QWidget* parent)
    : QAbstractButton(parent), look_(look), kind_(kind), text_(text) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
  connect(&look, &Look::changed, this, &Button::refreshState);
  refreshState();
}

void Button::setPhrase(const Phrase& text) {
  text_ = text;
  refreshState();
}

void Button::waitFor(const std::optional<Phrase>& reason) {
  if (reason == reason_) return;
  reason_ = reason;
  // Qt would hand the keyboard of a disabled button to a neighbour.
  if (reason) giveKeyboardBack(*this);
  setEnabled(!reason);
  refreshState();
}

void Button::reserve(const Phrase& text) {
  reserved_ = text;
  updateGeometry();
}

void Button::keepOneLine() {
  one_line_ = true;
  updateGeometry();
}

void Button::refreshState() {
  const bool quiet = kind_ == ButtonKind::kQuiet;
  setFont(look_.font(quiet ? kQuietText : 1, kind_ != ButtonKind::kPlain && !quiet && !reason_));
  setText(look_.say(reason_ ? *reason_ : text_));
  setAccessibleName(text());
  updateGeometry();
  update();
}

QString Button::shown(const QString& text) const { return isChecked() ? QStringLiteral("✓ ") + text : text; }

QSize Button::sizeHint() const {
  const int padding = look_.mm(kButtonPaddingMm);
  const bool quiet = kind_ == ButtonKind::kQuiet;
  int wide = quiet ? 0 : look_.mm(kLeastWidthMm);
  int high = look_.mm(quiet ? kQuietHeightMm : kind_ == ButtonKind::kForceOff ? kForceOffMm : kButtonHeightMm);
  for (const Phrase& phrase : {text_, reason_.value_or(Phrase{}), reserved_}) {
    const QString text = look_.say(phrase);
    const QSize needed = room(isCheckable() ? QStringLiteral("✓ ") + text : text);
    wide = std::max(wide, needed.width() + 2 * padding);
    high = std::max(high, needed.height() + padding);
  }
  return QSize(wide, high) + QSize(2 * kRingRoom, 2 * kRingRoom);
}

QSize Button::room(const QString& text) const {
  const bool quiet = kind_ == ButtonKind::kQuiet;
  const QFontMetricsF metrics(look_.font(quiet ? kQuietText : 1, true));
  const double line = metrics.horizontalAdvance(text);
  if (one_line_ || line <= look_.mm(quiet ? kQuietWidestMm : kButtonWidestMm))
    return {static_cast<int>(std::ceil(line)) + 1, static_cast<int>(metrics.height())};
  // Two lines of nearly equal length.
  const double step = metrics.averageCharWidth();
  double wide = line / 2;
  const auto height = [&](double width) {
    return metrics.boundingRect(QRectF(0, 0, width, 1e6), kButtonTextFlags, text).height();
  };
  while (wide < line && height(wide) > 2.1 * metrics.lineSpacing()) wide += step;
  return {static_cast<int>(std::ceil(wide)) + 1, static_cast<int>(std::ceil(height(wide)))};
}

bool Button::hitButton(const QPoint& at) const { return isDown() ? endsNear(look_, *this, at) : rect().contains(at); }

QColor Button::fill() const {
  if (!isEnabled()) return colors::kWaiting;
  switch (kind_) {
    case ButtonKind::kPrimary: return isDown() ? colors::kAccentPressed : colors::kAccent;
    case ButtonKind::kForceOff: return isDown() ? colors::kForceOffPressed : colors::kForceOff;
    case ButtonKind::kPlain:
    case ButtonKind::kQuiet: break;
  }
  return isDown() || isChecked() ? colors::kChosen : colors::kCard;
}

void Button::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF face = faceOf(size());
  const double corner = look_.mm(kButtonCornerMm);
  const bool framed = kind_ == ButtonKind::kPlain || kind_ == ButtonKind::kQuiet;
  const bool plain = framed || !isEnabled();
  const QPen edge = isChecked() ? QPen(colors::kInk, kChosenEdge) : QPen(colors::kEdge, 1.5);
  painter.setPen(framed && isEnabled() ? edge : QPen(Qt::NoPen));
  painter.setBrush(fill());
  painter.drawRoundedRect(face, corner, corner);
  painter.setPen(plain ? colors::kInk : QColor(Qt::white));
  const double padding = look_.mm(kButtonPaddingMm);
  painter.drawText(face.adjusted(padding / 2, 0, -padding / 2, 0), kButtonTextFlags, shown(text()));
  if (isRinged(*this)) drawRing(painter, face, corner);
}

}  // namespace tactus::workbench::nurse
