#include "app/workbench/views/curve_legend.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/workbench/theme.h"

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
  if (look_.fill.style() != Qt::NoBrush) painter.fillRect(swatch, look_.fill);
  QPen pen = look_.pen;
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

LegendChip* CurveLegend::chipAt(int index) const {
  return index >= 0 && index < static_cast<int>(chips_.size()) ? chips_[static_cast<std::size_t>(index)] : nullptr;
}

QSize CurveLegend::sizeHint() const {
  int width = 0;
  for (const LegendChip* chip : chips_) width += chip->sizeHint().width() + kBetween;
  return {width, place(width, false)};
}

QSize CurveLegend::minimumSizeHint() const { return {1, chips_.empty() ? 0 : chips_.front()->sizeHint().height()}; }

void CurveLegend::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place(width(), true);
}

int CurveLegend::place(int width, bool move) const {
  int x = 0;
  int y = 0;
  int row = 0;
  for (LegendChip* chip : chips_) {
    const QSize size = chip->sizeHint();
    if (x > 0 && x + size.width() > width) {
      x = 0;
      y += row;
    }
    if (move) chip->setGeometry(x, y, std::min(size.width(), width), size.height());
    x += size.width() + kBetween;
    row = size.height();
  }
  return y + row;
}

}  // namespace tactus::workbench
