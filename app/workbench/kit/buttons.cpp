#include "app/workbench/kit/buttons.h"

#include <QFrame>
#include <QPainter>
#include <QPainterPath>
#include <QScreen>
#include <QStringList>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"

namespace tactus::workbench {

StatisticHelp::StatisticHelp(std::initializer_list<Statistic> statistics, QWidget* parent) : QToolButton(parent) {
  QStringList sentences;
  for (const Statistic statistic : statistics) sentences << explained(statistic);
  setText(QStringLiteral("?"));
  setFont(theme::smallFont());
  setAutoRaise(true);
  setFocusPolicy(Qt::TabFocus);
  setObjectName(QStringLiteral("statistic_help"));
  setAccessibleName(tr("Explain these numbers"));
  setAccessibleDescription(sentences.join(QLatin1Char('\n')));
  setToolTip(sentences.join(QLatin1Char('\n')));
  connect(this, &QToolButton::clicked, this, [this, sentences] {
    showNotesPopup(*this, mapToGlobal(QPoint(0, height() + 4)), {{tr("What these numbers mean"), sentences}});
  });
}

QSize StatisticHelp::sizeHint() const {
  const int side = 3 * theme::kGrid;
  return {side, side};
}

namespace {

constexpr int kLockWidth = 16;  // px
constexpr int kHeight = 24;     // px

}  // namespace

LockButton::LockButton(QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize LockButton::sizeHint() const { return {kLockWidth, kHeight}; }

void LockButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool strong = isChecked() || underMouse() || hasFocus();
  QColor color = isChecked() ? theme::ink() : theme::mutedInk();
  color.setAlphaF(strong ? 1.0F : 0.35F);
  drawLock(painter, QPointF(width() / 2.0, height() / 2.0), color, isChecked());
  if (hasFocus()) {
    painter.setPen(QPen(theme::accent(), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  }
}

void drawLock(QPainter& painter, const QPointF& center, const QColor& color, bool closed) {
  const QRectF body(center.x() - 4.5, center.y() - 1, 9, 7);
  QPainterPath shackle;
  const double top = body.top() - 4.5;
  const double side = closed ? body.right() - 2 : body.right() + 1.5;
  // Open: the shackle has left its hole on the right and stands a little higher.
  const double lift = closed ? 0 : 1.5;
  shackle.moveTo(body.left() + 2, body.top());
  shackle.lineTo(body.left() + 2, top + 2 - lift);
  shackle.quadTo(QPointF(body.left() + 2, top - lift), QPointF((body.left() + 2 + side) / 2, top - lift));
  shackle.quadTo(QPointF(side, top - lift), QPointF(side, top + 2 - lift));
  if (closed) shackle.lineTo(side, body.top());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, 1.5));
  painter.drawPath(shackle);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRoundedRect(body, 1.5, 1.5);
}

QPixmap lockPicture(const QColor& color, qreal dots) {
  constexpr int kSize = 16;  // px
  QPixmap picture(qRound(kSize * dots), qRound(kSize * dots));
  picture.setDevicePixelRatio(dots);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  drawLock(painter, QPointF(kSize / 2.0, kSize / 2.0), color, true);
  return picture;
}

namespace {

constexpr int kDrawerWidth = 56 * theme::kGrid;  // px

}  // namespace

DrawerButton::DrawerButton(const QString& name, QWidget* content, QBoxLayout& place, QWidget* parent)
    : QToolButton(parent), content_(content), place_(place), drawer_(new QFrame(this, Qt::Popup)) {
  setText(name);
  setFont(theme::smallFont());
  setArrowType(Qt::DownArrow);
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setFocusPolicy(Qt::TabFocus);
  drawer_->setFrameShape(QFrame::StyledPanel);
  drawer_->setBackgroundRole(QPalette::Base);
  makeColumn(drawer_, {}, theme::kGrid, inset(theme::kGrid / 2));
  place_.addWidget(content);
  hide();
  connect(this, &QToolButton::clicked, this, &DrawerButton::open);
}

void DrawerButton::setFolded(bool folded) {
  if (folded == folded_ || !content_) return;
  folded_ = folded;
  drawer_->hide();
  if (folded) {
    drawer_->layout()->addWidget(content_);
  } else {
    place_.addWidget(content_);
  }
  setVisible(folded);
}

void DrawerButton::open() {
  drawer_->setFixedWidth(std::min(kDrawerWidth, screen()->availableGeometry().width()));
  drawer_->adjustSize();
  const QRect room = screen()->availableGeometry();
  QPoint corner = mapToGlobal(QPoint(width() - drawer_->width(), height() + 4));
  if (corner.y() + drawer_->height() > room.bottom())
    corner.setY(mapToGlobal(QPoint(0, 0)).y() - drawer_->height() - 4);
  corner.setX(std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() - drawer_->width())));
  drawer_->move(corner);
  drawer_->show();
}

PrimaryButton::PrimaryButton(const QString& text, QWidget* parent) : QPushButton(text, parent) {
  setFont(theme::headingFont());
  setAttribute(Qt::WA_Hover);
}

QSize PrimaryButton::sizeHint() const {
  const QFontMetrics metrics(font());
  return {metrics.size(Qt::TextShowMnemonic, text()).width() + 5 * theme::kGrid, 4 * theme::kGrid + 4};
}

void PrimaryButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor fill = !isEnabled() ? theme::border() : theme::accent();
  const QRectF shape = QRectF(rect()).adjusted(2, 2, -2, -2);
  painter.setPen(Qt::NoPen);
  painter.setBrush(isDown() ? fill.darker(120) : underMouse() && isEnabled() ? fill.darker(108) : fill);
  painter.drawRoundedRect(shape, 6, 6);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::ink(), 1.5));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.75, 0.75, -0.75, -0.75), 7, 7);
  }
  painter.setPen(isEnabled() ? theme::inkOn(fill) : theme::mutedInk());
  painter.drawText(rect(), Qt::AlignCenter | Qt::TextShowMnemonic, text());
}

}  // namespace tactus::workbench
