#include "app/workbench/participant/screens/code_field.h"

#include <QPainter>

#include "app/workbench/participant/kit/colors.h"
#include "app/workbench/participant/kit/ring.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kWidthMm = 130;
constexpr double kHeightMm = 20;
constexpr double kCornerMm = 2;
constexpr double kPaddingMm = 4;
constexpr int kLongest = 40;  // characters of a code

}  // namespace

CodeField::CodeField(const Look& look, QWidget* parent) : QWidget(parent), look_(look), edit_(new QLineEdit(this)) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setFocusProxy(edit_);
  edit_->setFrame(false);
  edit_->setMaxLength(kLongest);
  // Menus are windows of their own, above the button that stops the force.
  edit_->setContextMenuPolicy(Qt::NoContextMenu);
  edit_->setInputMethodHints(Qt::ImhNoPredictiveText | Qt::ImhLatinOnly | Qt::ImhNoAutoUppercase);
  connect(edit_, &QLineEdit::textEdited, this, &CodeField::edited);
  connect(edit_, &QLineEdit::returnPressed, this, &CodeField::entered);
  connect(&look, &Look::changed, this, &CodeField::follow);
  follow();
}

void CodeField::follow() {
  edit_->setFont(look_.font());
  edit_->setAccessibleName(look_.say(phrase(QStringLiteral("code.field"))));
  updateGeometry();
}

QSize CodeField::sizeHint() const {
  return QSize(look_.mm(kWidthMm), look_.mm(kHeightMm)) + QSize(2 * kRingRoom, 2 * kRingRoom);
}

void CodeField::resizeEvent(QResizeEvent* /*event*/) {
  const int padding = kRingRoom + look_.mm(kPaddingMm);
  edit_->setGeometry(rect().adjusted(padding, kRingRoom + 3, -padding, -kRingRoom - 3));
}

void CodeField::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF face = faceOf(size());
  painter.setPen(QPen(colors::kEdge, 1.5));
  painter.setBrush(colors::kCard);
  painter.drawRoundedRect(face, look_.mm(kCornerMm), look_.mm(kCornerMm));
  if (edit_->hasFocus()) drawRing(painter, face, look_.mm(kCornerMm));
}

}  // namespace tactus::workbench::nurse
