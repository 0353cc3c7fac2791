#include "app/workbench/kit/number_box.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QStatusTipEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

// So many digits after the point are kept of what is typed.
constexpr int kKeptDigits = 15;

/// A red frame over the box.
class RefusalFrame : public QWidget {
 public:
  explicit RefusalFrame(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme::errorInk(), 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
  }
};

}  // namespace

double stepOf(const fuzzy::Variable& variable) {
  return std::pow(10.0, std::floor(std::log10((variable.max - variable.min) / 90)));
}

NumberBox::NumberBox(const fuzzy::Variable& variable, double step, QWidget* parent)
    : QDoubleSpinBox(parent),
      // Two digits more than the step: exact values such as a measured speed can be read.
      digits_(std::max(0, static_cast<int>(std::ceil(-std::log10(step)))) + 2),
      frame_(new RefusalFrame(this)) {
  setLocale(QLocale::c());
  setGroupSeparatorShown(false);
  setDecimals(kKeptDigits);
  setRange(variable.min, variable.max);
  setSingleStep(step);
  setKeyboardTracking(false);
  setAlignment(Qt::AlignRight);
  const QString unit = unitText(variable.unit);
  if (!unit.isEmpty()) setSuffix(QLatin1Char(' ') + unit);
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  // Room for both ends of the universe with a place more, as the mouse sets them.
  QString widest = QStringLiteral("0.25");
  for (const double end : {variable.min, variable.max}) {
    const QString number = numberText(end) + QStringLiteral(".0");
    if (fontMetrics().horizontalAdvance(number) > fontMetrics().horizontalAdvance(widest)) widest = number;
  }
  setRoomFor(widest + suffix());
  keepFitted(*this, [this] {
    // A place that gives it another width keeps it.
    if (minimumWidth() == maximumWidth()) setRoomFor(room_for_);
  });
  setAccessibleName(labelOf(variable));
  // The red frame is off while the person corrects the text.
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { setRefusal({}); });
}

void NumberBox::setRoomFor(const QString& widest) {
  constexpr int kAround = 10;  // px
  room_for_ = widest;
  setFixedWidth(fontMetrics().horizontalAdvance(widest) + kAround);
}

void NumberBox::setWhole() {
  whole_ = true;
  digits_ = 0;
}

bool NumberBox::isTyped() const {
  return lineEdit()->text() != prefix() + textFromValue(QDoubleSpinBox::value()) + suffix();
}

bool NumberBox::takesText() {
  if (!isTyped()) {
    setRefusal({});
    return true;
  }
  QString typed = lineEdit()->text();
  if (typed.startsWith(prefix())) typed.remove(0, prefix().size());
  const auto number = typedNumber(typed, NumberBounds{minimum(), maximum(), whole_, suffix().trimmed()});
  setRefusal(number ? QString() : number.error());
  if (number) typed_ = *number;
  return number.has_value();
}

void NumberBox::restore() {
  lineEdit()->setText(prefix() + textFromValue(QDoubleSpinBox::value()) + suffix());
  setRefusal({});
}

bool NumberBox::commit() {
  if (!takesText()) return false;
  interpretText();
  return true;
}

void NumberBox::setRefusal(const QString& sentence) {
  if (refusal_ == sentence) return;
  if (refusal_.isEmpty()) tool_tip_ = toolTip();
  refusal_ = sentence;
  frame_->setVisible(!sentence.isEmpty());
  frame_->raise();
  setToolTip(sentence.isEmpty() ? tool_tip_ : sentence);
  setAccessibleDescription(sentence);
  if (sentence.isEmpty()) {
    QToolTip::hideText();
    return;
  }
  if (isVisible()) QToolTip::showText(mapToGlobal(QPoint(0, height())), sentence, this);
  QStatusTipEvent tip(sentence);
  QCoreApplication::sendEvent(this, &tip);
}

void NumberBox::setValue(double value) {
  const bool keeps = isTyped() && (hasFocus() || !refusal_.isEmpty());
  if (keeps && value == exact()) return;
  if (typed_ != value) typed_.reset();
  setRefusal({});
  QDoubleSpinBox::setValue(value);
}

void NumberBox::setExact(double value) {
  setValue(value);
  exact_ = value;
  shown_ = this->value();
}

void NumberBox::stepBy(int steps) {
  setRefusal({});
  QDoubleSpinBox::stepBy(steps);
}

QString NumberBox::textFromValue(double value) const {
  return typed_ && value == *typed_ ? workbench::text(base::formatNumber(value)) : numberText(value, digits_);
}

// Also asked where the box is hidden in the middle of typing: then nothing changes.
double NumberBox::valueFromText(const QString& typed) const {
  // What it shows of a number with more digits is that number.
  if (typed == prefix() + textFromValue(QDoubleSpinBox::value()) + suffix()) return QDoubleSpinBox::value();
  QString number = typed;
  if (number.startsWith(prefix())) number.remove(0, prefix().size());
  return typedNumber(number, NumberBounds{minimum(), maximum(), whole_, suffix().trimmed()})
      .value_or(QDoubleSpinBox::value());
}

// Anything may be typed; Enter and leaving the box say what it is.
QValidator::State NumberBox::validate(QString& /*text*/, int& /*place*/) const { return QValidator::Acceptable; }

void NumberBox::keyPressEvent(QKeyEvent* event) {
  const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enters && !takesText()) {
    event->accept();
    return;
  }
  // Esc takes back what is typed; with nothing typed it is for what the box stands in.
  if (event->key() == Qt::Key_Escape && isTyped()) {
    restore();
    event->accept();
    return;
  }
  QDoubleSpinBox::keyPressEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent* event) {
  if (takesText()) {
    QDoubleSpinBox::focusOutEvent(event);
    return;
  }
  // As the base does, without taking the text.
  lineEdit()->event(event);
  QWidget::focusOutEvent(event);
}

void NumberBox::hideEvent(QHideEvent* event) {
  QDoubleSpinBox::hideEvent(event);
  // The box forgets a text that it did not accept: the next time it shows its value.
  if (isTyped()) restore();
  setRefusal({});
}

void NumberBox::resizeEvent(QResizeEvent* event) {
  QDoubleSpinBox::resizeEvent(event);
  frame_->setGeometry(rect());
}

}  // namespace tactus::workbench
