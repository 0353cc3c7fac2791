#include "app/workbench/understand/curves/curve_legend.h"

#include <QAction>
#include <QEvent>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kBetween = 2;  // px between the parts

int widthOf(const std::vector<QWidget*>& parts) {
  int width = 0;
  for (const QWidget* part : parts) width += part->sizeHint().width() + kBetween;
  return width;
}

// Words need the room of a short sentence with a number.
int leastWidthOf(const QWidget& part, bool words) {
  const int whole = part.sizeHint().width();
  if (words) return std::min(whole, part.fontMetrics().horizontalAdvance(QStringLiteral("ΔF ≥ 0.000 N on this curve")));
  return qobject_cast<const LegendChip*>(&part) ? part.minimumSizeHint().width() : whole;
}

}  // namespace

CurveLegend::CurveLegend(QWidget* parent) : QWidget(parent), more_(new QToolButton(this)) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  more_->setAutoRaise(true);
  more_->setFont(theme::smallFont());
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setToolTip(tr("Show or hide the lines that find no place here"));
  more_->setAccessibleName(tr("Further lines"));
  more_->setMenu(new QMenu(more_));
  more_->hide();
  connect(more_->menu(), &QMenu::aboutToShow, this, &CurveLegend::fillMenu);
}

void CurveLegend::setItems(std::vector<Item> items) {
  for (LegendChip* chip : chips_) chip->deleteLater();
  for (LegendChip* chip : chips_) chip->hide();
  chips_.clear();
  for (Item& item : items) {
    auto* chip = new LegendChip(std::move(item.look), item.tip, this);
    chip->setChecked(item.shown);
    connect(chip, &LegendChip::toggled, this, [toggled = std::move(item.toggled)](bool shown) { toggled(shown); });
    chips_.push_back(chip);
  }
  arrange();
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

std::vector<QWidget*> CurveLegend::tail() const {
  std::vector<QWidget*> shown;
  for (QWidget* part : tail_) {
    const bool taken_away = part->isHidden() && part->testAttribute(Qt::WA_WState_ExplicitShowHide);
    if (!taken_away) shown.push_back(part);
  }
  return shown;
}

QSize CurveLegend::sizeHint() const {
  std::vector<QWidget*> parts(chips_.begin(), chips_.end());
  const std::vector<QWidget*> after = tail();
  parts.insert(parts.end(), after.begin(), after.end());
  int height = 0;
  for (const QWidget* part : parts) height = std::max(height, part->sizeHint().height());
  return {widthOf(parts), height};
}

QSize CurveLegend::minimumSizeHint() const { return {1, sizeHint().height()}; }

// A part of the tail has other words.
bool CurveLegend::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) arrange();
  return QWidget::event(event);
}

void CurveLegend::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

// Who has to go: lines that are hidden, then those at the end.
std::vector<LegendChip*> CurveLegend::chipsWithin(int room) const {
  std::vector<LegendChip*> kept = chips_;
  const auto width = [&kept] { return widthOf({kept.begin(), kept.end()}); };
  while (!kept.empty() && width() > room) {
    const auto hidden =
        std::find_if(kept.rbegin(), kept.rend(), [](const LegendChip* chip) { return !chip->isChecked(); });
    kept.erase(hidden == kept.rend() ? std::prev(kept.end()) : std::prev(hidden.base()));
  }
  return kept;
}

void CurveLegend::arrange() {
  const std::vector<QWidget*> after = tail();
  int least = 0;
  for (const QWidget* part : after) least += leastWidthOf(*part, part == after.back()) + kBetween;
  std::vector<LegendChip*> kept = chipsWithin(width() - least);
  if (kept.size() < chips_.size()) kept = chipsWithin(width() - least - more_->sizeHint().width() - kBetween);
  const auto left_out = static_cast<int>(chips_.size() - kept.size());
  more_->setText(QStringLiteral("+%1").arg(left_out));
  more_->setVisible(left_out > 0);

  int x = 0;
  for (LegendChip* chip : chips_) {
    const bool placed = std::find(kept.begin(), kept.end(), chip) != kept.end();
    chip->setVisible(placed);
    if (!placed) continue;
    chip->setGeometry(x, 0, chip->sizeHint().width(), height());
    x += chip->width() + kBetween;
  }
  if (left_out > 0) {
    more_->setGeometry(x, 0, more_->sizeHint().width(), height());
    x += more_->width() + kBetween;
  }
  // The room beyond the least goes to the parts in their order.
  int spare = std::max(0, width() - x - least);
  for (QWidget* part : after) {
    const int narrow = leastWidthOf(*part, part == after.back());
    const int more = std::min(spare, part->sizeHint().width() - narrow);
    spare -= more;
    part->setGeometry(x, 0, part == after.back() ? std::max(0, width() - x) : narrow + more, height());
    x += narrow + more + kBetween;
  }
}

void CurveLegend::fillMenu() {
  more_->menu()->clear();
  for (LegendChip* chip : chips_) {
    if (!chip->isHidden()) continue;
    QAction* action = more_->menu()->addAction(QString(chip->text()).replace(QLatin1Char('&'), QLatin1String("&&")));
    action->setToolTip(chip->toolTip());
    action->setCheckable(true);
    action->setChecked(chip->isChecked());
    connect(action, &QAction::toggled, chip, &LegendChip::setChecked);
  }
}

}  // namespace tactus::workbench
