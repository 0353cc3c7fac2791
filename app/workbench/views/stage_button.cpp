#include "app/workbench/views/stage_button.h"

#include <QPainter>
#include <algorithm>

#include "app/workbench/theme.h"
#include "app/workbench/views/stage_picture.h"

namespace tactus::workbench {
namespace {

constexpr int kPicture = 24;  // px
constexpr int kText = 2 * theme::kGrid + kPicture;

}  // namespace

StageButton::StageButton(Stage stage, QWidget* parent) : QAbstractButton(parent), stage_(stage) {
  setText(stageName(stage));
  setAccessibleDescription(stageHint(stage));
  setCheckable(true);
  setAutoExclusive(true);
  setEnabled(isReady(stage));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize StageButton::sizeHint() const {
  const QFontMetrics name(theme::headingFont());
  const QFontMetrics hint(theme::smallFont());
  int widest = 0;
  for (const Stage stage : kStages) widest = std::max(widest, name.horizontalAdvance(stageName(stage)));
  return {kText + widest + 2 * theme::kGrid, 2 * theme::kGrid + name.height() + 2 * hint.height() + 2};
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
  painter.save();
  painter.translate(theme::kGrid + 2, theme::kGrid);
  painter.setPen(QPen(name, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(stagePicture(stage_));
  painter.restore();

  painter.setPen(name);
  painter.setFont(theme::headingFont());
  painter.drawText(QRect(kText, theme::kGrid, width() - kText, QFontMetrics(theme::headingFont()).height()),
                   Qt::AlignLeft | Qt::AlignVCenter, text());
  painter.setPen(isEnabled() ? theme::mutedInk() : disabled);
  painter.setFont(theme::smallFont());
  painter.drawText(hintRect(), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, stageHint(stage_));
}

}  // namespace tactus::workbench
