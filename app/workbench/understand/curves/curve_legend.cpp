#include "app/workbench/understand/curves/curve_legend.h"

#include <QEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kSwatch = 20;  // px
constexpr int kInside = 6;   // px between the edge of a chip and what is in it
constexpr int kBetween = 2;  // px between chips
constexpr double kOff = 0.35;

}  // namespace

LegendChip::LegendChip(LegendEntry look, const QString& tip, QWidget* parent)
    : QAbstractButton(parent), look_(std::move(look)) {
  setText(look_.name);
  setToolTip(tip);
  setFont(theme::smallFont());
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
}

void LegendChip::setName(const QString& name) {
  if (name == text()) return;
  setText(name);
  updateGeometry();
}

void LegendChip::setLook(LegendEntry look) {
  look_ = std::move(look);
  update();
}

QSize LegendChip::sizeHint() const {
  const QFontMetrics metrics(font());
  return {kSwatch + 3 * kInside + metrics.horizontalAdvance(text()), metrics.height() + 6};
}

void LegendChip::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (underMouse() || hasFocus()) {
    painter.setPen(hasFocus() ? QPen(theme::accent(), 1) : Qt::NoPen);
    painter.setBrush(theme::grid());
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }
  painter.setOpacity(isChecked() ? 1 : kOff);
  const double middle = height() / 2.0;
  const QRectF swatch(kInside, middle - 5, kSwatch, 10);
  // The entry may have been made in the other look.
  QBrush fill = look_.fill;
  fill.setColor(theme::inLook(fill.color()));
  if (fill.style() != Qt::NoBrush) painter.fillRect(swatch, fill);
  QPen pen = look_.pen;
  pen.setColor(theme::inLook(pen.color()));
  pen.setWidthF(std::min(pen.widthF(), 4.0));
  painter.setPen(pen);
  painter.drawLine(QPointF(swatch.left(), middle), QPointF(swatch.right(), middle));
  if (look_.dots) {
    painter.setBrush(pen.color());
    painter.drawEllipse(swatch.center(), 2.2, 2.2);
  }
  painter.setOpacity(1);
  painter.setPen(isChecked() ? theme::ink() : theme::mutedInk());
  QFont words = font();
  words.setStrikeOut(!isChecked());
  painter.setFont(words);
  painter.drawText(rect().adjusted(kSwatch + 2 * kInside, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text());
}

void LegendChip::enterEvent(QEnterEvent* event) {
  update();
  QAbstractButton::enterEvent(event);
}

void LegendChip::leaveEvent(QEvent* event) {
  update();
  QAbstractButton::leaveEvent(event);
}

CurveLegend::CurveLegend(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void CurveLegend::setItems(std::vector<Item> items) {
  for (LegendChip* chip : chips_) chip->deleteLater();
  for (LegendChip* chip : chips_) chip->hide();
  chips_.clear();
  for (Item& item : items) {
    auto* chip = new LegendChip(std::move(item.look), item.tip, this);
    chip->setChecked(item.shown);
    connect(chip, &LegendChip::toggled, this, [toggled = std::move(item.toggled)](bool shown) { toggled(shown); });
    chip->show();
    chips_.push_back(chip);
  }
  place(width(), true);
  updateGeometry();
}

void CurveLegend::setShown(int index, bool shown) {
  LegendChip* chip = chipAt(index);
  const QSignalBlocker no_signal(chip);
  chip->setChecked(shown);
  chip->update();
}

LegendChip* CurveLegend::chipAt(int index) const {
  return index >= 0 && index < static_cast<int>(chips_.size()) ? chips_[static_cast<std::size_t>(index)] : nullptr;
}

void CurveLegend::setTail(std::vector<QWidget*> tail) {
  tail_ = std::move(tail);
  for (QWidget* part : tail_) part->setParent(this);
  updateGeometry();
}

std::vector<QWidget*> CurveLegend::parts() const {
  std::vector<QWidget*> all(chips_.begin(), chips_.end());
  for (QWidget* part : tail_) {
    const bool taken_away = part->isHidden() && part->testAttribute(Qt::WA_WState_ExplicitShowHide);
    if (!taken_away) all.push_back(part);
  }
  return all;
}

QSize CurveLegend::sizeHint() const {
  int width = 0;
  for (const QWidget* part : parts()) width += part->sizeHint().width() + kBetween;
  return {width, place(this->width(), false)};
}

QSize CurveLegend::minimumSizeHint() const {
  const std::vector<QWidget*> all = parts();
  return {1, all.empty() ? 0 : all.front()->sizeHint().height()};
}

// A part of the tail has other words.
bool CurveLegend::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest && place(width(), true) != height()) updateGeometry();
  return QWidget::event(event);
}

void CurveLegend::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place(width(), true);
}

int CurveLegend::place(int width, bool move) const {
  int x = 0;
  int y = 0;
  int row = 0;
  const std::vector<QWidget*> all = parts();
  for (QWidget* part : all) {
    const QSize size = part->sizeHint();
    if (x > 0 && x + size.width() > width) {
      x = 0;
      y += row;
      row = 0;
    }
    row = std::max(row, size.height());
    // The rows have the height of chips, in the middle of which a label stands.
    const bool rest = part == all.back() && !tail_.empty();
    if (move) part->setGeometry(x, y, rest ? width - x : std::min(size.width(), width), row);
    x += size.width() + kBetween;
  }
  return y + row;
}

}  // namespace tactus::workbench
