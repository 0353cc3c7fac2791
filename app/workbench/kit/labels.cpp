#include "app/workbench/kit/labels.h"

#include <QEvent>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace tactus::workbench {
namespace {

class FontFit : public QObject {
 public:
  FontFit(QWidget& widget, std::function<void()> fit) : QObject(&widget), fit_(std::move(fit)) {
    widget.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::FontChange) fit_();
    return QObject::eventFilter(watched, event);
  }

 private:
  std::function<void()> fit_;
};

}  // namespace

void keepFitted(QWidget& widget, std::function<void()> fit) {
  fit();
  new FontFit(widget, std::move(fit));
}

namespace {

constexpr qsizetype kShortestPart = 3;  // letters on either line

// Two lines of about the same length, or one where nothing can be broken.
std::pair<QString, QString> halves(const QString& label) {
  const QString vowels = QStringLiteral("aeiouäöü");
  const bool has_space = label.contains(QLatin1Char(' '));
  qsizetype best = -1;
  for (qsizetype i = 1; i < label.size(); ++i) {
    const bool space = label[i] == QLatin1Char(' ');
    const bool behind_vowel = vowels.contains(label[i - 1].toLower()) && !vowels.contains(label[i].toLower()) &&
                              i >= kShortestPart && label.size() - i >= kShortestPart;
    if (has_space ? !space : !behind_vowel) continue;
    if (best < 0 || qAbs(2 * i - label.size()) < qAbs(2 * best - label.size())) best = i;
  }
  if (best < 0) return {label, {}};
  if (has_space) return {label.left(best), label.mid(best + 1)};
  return {label.left(best) + QLatin1Char('-'), label.mid(best)};
}

}  // namespace

QString brokenLabel(const QString& label, double width, const QFontMetricsF& metrics) {
  if (metrics.horizontalAdvance(label) <= width) return label;
  const auto [first, second] = halves(label);
  QString out = metrics.elidedText(first, Qt::ElideRight, width);
  if (!second.isEmpty()) out += QLatin1Char('\n') + metrics.elidedText(second, Qt::ElideRight, width);
  return out;
}

double brokenWidth(const QString& label, const QFontMetricsF& metrics) {
  const auto [first, second] = halves(label);
  return std::max(metrics.horizontalAdvance(first), metrics.horizontalAdvance(second));
}

namespace {

constexpr int kInside = 2;  // px between the edge and the letters, as in a line edit without a frame

}  // namespace

ElidedEdit::ElidedEdit(QWidget* parent) : QLineEdit(parent) { setFrame(false); }

void ElidedEdit::paintEvent(QPaintEvent* event) {
  const QRect room = rect().adjusted(kInside, 0, -kInside, 0);
  if (hasFocus() || fontMetrics().horizontalAdvance(text()) <= room.width()) {
    QLineEdit::paintEvent(event);
    return;
  }
  QPainter painter(this);
  painter.setPen(palette().color(isEnabled() ? QPalette::Normal : QPalette::Disabled, QPalette::Text));
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(text(), Qt::ElideRight, room.width()));
}

WrappedLabel::WrappedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  setAlignment(Qt::AlignLeft | Qt::AlignTop);
}

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ElidedLabel::setFullText(const QString& text, const QString& brief) {
  if (text == full_ && brief == brief_) return;
  full_ = text;
  brief_ = brief;
  elide();
  updateGeometry();
}

void ElidedLabel::setHint(const QString& hint) {
  hint_ = hint;
  elide();
}

QSize ElidedLabel::minimumSizeHint() const { return {1, QLabel::sizeHint().height()}; }

QSize ElidedLabel::sizeHint() const {
  return {fontMetrics().horizontalAdvance(full_) + std::max(0, indent()) + 2, QLabel::sizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  elide();
}

void ElidedLabel::elide() {
  const int room = width() - std::max(0, indent());
  const bool fits = fontMetrics().horizontalAdvance(full_) <= room;
  const QString& text = fits || brief_.isEmpty() ? full_ : brief_;
  const QString shown = fontMetrics().elidedText(text, cut_, room);
  setText(shown);
  QStringList tip;
  if (shown != full_) tip << full_;
  if (!hint_.isEmpty()) tip << hint_;
  setToolTip(tip.join(QLatin1Char('\n')));
}

}  // namespace tactus::workbench
