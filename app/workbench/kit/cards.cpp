#include "app/workbench/kit/cards.h"

#include <QFontMetrics>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <QWidget>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"

namespace tactus::workbench {
namespace {

constexpr int kFadesMs = 900;  // long enough to find it with the eyes, short enough not to be in the way

}  // namespace

Flash::Flash(QWidget* widget) : QObject(widget) {
  fading_.setDuration(kFadesMs);
  fading_.setStartValue(1.0);
  fading_.setEndValue(0.0);
  connect(&fading_, &QVariantAnimation::valueChanged, this, [this, widget](const QVariant& value) {
    strength_ = value.toDouble();
    widget->update();
  });
}

void Flash::start() {
  fading_.stop();
  strength_ = 1;
  fading_.start();
}

void addMenuHeading(QMenu& menu, const QString& text) {
  menu.addSection(text);
  const int wanted = QFontMetrics(menu.font()).horizontalAdvance(text) + 4 * theme::kGrid;
  menu.setMinimumWidth(qMax(menu.minimumWidth(), wanted));
}

namespace {

constexpr int kFormWidth = 40 * theme::kGrid;  // px

}  // namespace

PopupForm::PopupForm(const QString& title, const QString& accept, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      note_(new QLabel(this)),
      fields_(new QFormLayout),
      accept_(new QPushButton(accept, this)) {
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  setBackgroundRole(QPalette::Base);
  setFixedWidth(kFormWidth);
  auto* head = new QLabel(title, this);
  head->setFont(theme::headingFont());
  head->setTextFormat(Qt::PlainText);
  head->setWordWrap(true);
  note_->setTextFormat(Qt::PlainText);
  note_->setWordWrap(true);
  note_->hide();

  makeColumn(this, {head, note_, fields_, makeRow({spring(1), accept_}, kStyleGap)}, theme::kGrid, inset(12));
  connect(accept_, &QPushButton::clicked, this, &PopupForm::accepted);
}

void PopupForm::addField(const QString& label, QWidget* field) {
  fields_->addRow(label, field);
  if (fields_->rowCount() == 1) field->setFocus();
}

void PopupForm::setNote(const QString& sentence) {
  note_->setText(sentence);
  note_->setVisible(!sentence.isEmpty());
  adjustSize();
}

void PopupForm::openAt(const QWidget& anchor) {
  adjustSize();
  const QRect room = anchor.screen()->availableGeometry();
  QPoint place = anchor.mapToGlobal(QPoint(0, anchor.height() + 4));
  if (place.y() + height() > room.bottom()) place.setY(anchor.mapToGlobal(QPoint(0, 0)).y() - height() - 4);
  place.setX(std::clamp(place.x(), room.left(), std::max(room.left(), room.right() - width())));
  move(place);
  show();
}

void PopupForm::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    accept_->click();
  } else {
    QFrame::keyPressEvent(event);
  }
}

Card::Card(QWidget* parent) : QFrame(parent) {}

void Card::setColors(const QColor& fill, const QColor& edge) {
  fill_ = fill;
  edge_ = edge;
  update();
}

void Card::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::inLook(edge_.value_or(theme::border())), 1));
  painter.setBrush(theme::inLook(fill_.value_or(theme::card())));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), theme::kCornerRadius, theme::kCornerRadius);
}

}  // namespace tactus::workbench
