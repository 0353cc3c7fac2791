#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/stage.h"

namespace tactus::workbench {
namespace {

// Pictures of the stages as line drawings: sharp at any scale, in the color of the text.

void line(QPainterPath& path, double x1, double y1, double x2, double y2) {
  path.moveTo(x1, y1);
  path.lineTo(x2, y2);
}

// A form with three answers.
QPainterPath form() {
  QPainterPath path;
  path.addRoundedRect(QRectF(5, 3, 14, 18), 2, 2);
  for (const double y : {8.0, 12.0, 16.0}) {
    path.addEllipse(QPointF(8.5, y), 0.7, 0.7);
    line(path, 11, y, 16, y);
  }
  return path;
}

// A curve between two axes.
QPainterPath curve() {
  QPainterPath path;
  line(path, 4, 4, 4, 20);
  line(path, 4, 20, 20, 20);
  path.moveTo(6.5, 17);
  path.cubicTo(11, 17, 10, 7, 14, 7);
  path.cubicTo(16.5, 7, 16.5, 11, 20, 11);
  return path;
}

// Three sliders.
QPainterPath sliders() {
  QPainterPath path;
  const double knobs[] = {15, 8, 12};
  double x = 6;
  for (const double y : knobs) {
    line(path, x, 4, x, y - 2);
    path.addEllipse(QPointF(x, y), 2, 2);
    line(path, x, y + 2, x, 20);
    x += 6;
  }
  return path;
}

// Two opinions and what they share.
QPainterPath circles() {
  QPainterPath path;
  path.addEllipse(QPointF(9, 12), 5.5, 5.5);
  path.addEllipse(QPointF(15, 12), 5.5, 5.5);
  return path;
}

// An arrow out of a box.
QPainterPath box() {
  QPainterPath path;
  path.moveTo(8, 11);
  path.lineTo(4, 11);
  path.lineTo(4, 20);
  path.lineTo(20, 20);
  path.lineTo(20, 11);
  path.lineTo(16, 11);
  line(path, 12, 15, 12, 4);
  path.moveTo(8.5, 7.5);
  path.lineTo(12, 4);
  path.lineTo(15.5, 7.5);
  return path;
}

/// Lines in a square of 24 x 24 units.
QPainterPath stagePicture(Stage stage) {
  switch (stage) {
    case Stage::kCollect: return form();
    case Stage::kUnderstand: return curve();
    case Stage::kTune: return sliders();
    case Stage::kBuild: return circles();
    case Stage::kDeliver: return box();
  }
  return {};
}

constexpr int kPicture = 24;  // px
constexpr int kText = 2 * theme::kGrid + kPicture;

QFont compactFont(bool chosen) {
  QFont font = theme::smallFont();
  if (chosen) font.setWeight(QFont::DemiBold);
  return font;
}

void paintPicture(QPainter& painter, Stage stage, QPoint corner, const QColor& ink) {
  painter.save();
  painter.translate(corner);
  painter.setPen(QPen(ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(stagePicture(stage));
  painter.restore();
  painter.setPen(ink);
}

}  // namespace

StageButton::StageButton(Stage stage, QWidget* parent) : QAbstractButton(parent), stage_(stage) {
  setText(stageName(stage));
  setAccessibleDescription(stageHint(stage));
  setCheckable(true);
  setAutoExclusive(true);
  setEnabled(false);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StageButton::setCompact(bool compact) {
  compact_ = compact;
  setToolTip(compact ? hint() : QString());
  updateGeometry();
  update();
}

void StageButton::setState(const QString& state) {
  state_ = state;
  setAccessibleDescription(hint());
  if (compact_) setToolTip(hint());
  update();
}

QString StageButton::hint() const { return state_.isEmpty() ? stageHint(stage_) : state_; }

QSize StageButton::sizeHint() const {
  const QFontMetrics name(theme::headingFont());
  const QFontMetrics small(theme::smallFont());
  int widest = 0;
  if (compact_) {
    const QFontMetrics chosen(compactFont(true));
    for (const Stage stage : kStages) widest = std::max(widest, chosen.horizontalAdvance(stageName(stage)));
    return {widest + 2 * theme::kGrid, 2 * theme::kGrid + kPicture + small.height()};
  }
  for (const Stage stage : kStages) widest = std::max(widest, name.horizontalAdvance(stageName(stage)));
  return {kText + widest + 2 * theme::kGrid, 2 * theme::kGrid + name.height() + 2 * small.height() + 2};
}

QRect StageButton::hintRect() const {
  const int top = theme::kGrid + QFontMetrics(theme::headingFont()).height() + 2;
  return {kText, top, width() - kText - 4, height() - top - 2};
}

void StageButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (isChecked() || underMouse()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(isChecked() ? theme::card() : theme::border());
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), theme::kCornerRadius, theme::kCornerRadius);
  }
  if (isChecked()) {
    painter.setBrush(theme::accent());
    painter.drawRoundedRect(QRectF(1, theme::kGrid, 3, height() - 2.0 * theme::kGrid), 1.5, 1.5);
  }
  if (hasFocus()) {
    painter.setPen(QPen(theme::accent(), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), theme::kCornerRadius, theme::kCornerRadius);
  }

  const QColor disabled = palette().color(QPalette::Disabled, QPalette::WindowText);
  const QColor name = !isEnabled() ? disabled : isChecked() ? theme::accent() : theme::ink();
  if (compact_) {
    paintCompact(painter, name);
  } else {
    paintRoomy(painter, name, isEnabled() ? theme::mutedInk() : disabled);
  }
}

void StageButton::paintRoomy(QPainter& painter, const QColor& ink, const QColor& muted) {
  paintPicture(painter, stage_, QPoint(theme::kGrid + 2, theme::kGrid), ink);
  painter.setFont(theme::headingFont());
  painter.drawText(QRect(kText, theme::kGrid, width() - kText, QFontMetrics(theme::headingFont()).height()),
                   Qt::AlignLeft | Qt::AlignVCenter, text());
  painter.setPen(muted);
  painter.setFont(theme::smallFont());
  painter.drawText(hintRect(), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, hint());
}

void StageButton::paintCompact(QPainter& painter, const QColor& ink) {
  paintPicture(painter, stage_, QPoint((width() - kPicture) / 2, theme::kGrid - 2), ink);
  painter.setFont(compactFont(isChecked()));
  painter.drawText(QRect(0, theme::kGrid + kPicture, width(), height() - theme::kGrid - kPicture),
                   Qt::AlignHCenter | Qt::AlignTop, text());
}

}  // namespace tactus::workbench
