#include "app/workbench/understand/curves/curve_legend.h"

#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/understand/curves/force_spread.h"
#include "app/workbench/understand/curves/reading_model.h"
#include "app/workbench/understand/curves/reference_controller.h"

namespace tactus::workbench {

QPen familyPen(std::size_t index, std::size_t count, bool fast) {
  constexpr std::array<Qt::PenStyle, 4> kStyles = {Qt::SolidLine, Qt::DashLine, Qt::DashDotLine, Qt::DotLine};
  const double share = count < 2 ? 1 : static_cast<double>(index) / static_cast<double>(count - 1);
  return {mixedColor(theme::mutedInk(), theme::ink(), share), fast ? 1.0 : 1.6 + share,
          kStyles[index % kStyles.size()]};
}

QPen referencePen(std::size_t index) {
  static constexpr std::array<QRgb, kMostReferences> kLight = {0x5B2DA0, 0x6B4E00, 0x00646B,
                                                               0x8A1F11, 0x3F5F00, 0xB0006A};
  static constexpr std::array<QRgb, kMostReferences> kDark = {0xC0A4FF, 0xE2C27A, 0x7FE0E6,
                                                              0xFF9C8C, 0xC3E07A, 0xFF7AC4};
  return {QColor::fromRgb((theme::isDark() ? kDark : kLight)[index % kMostReferences]), 1.6, Qt::DotLine};
}

LegendEntry ghostLook(const QString& name) { return {name, ghostPen(theme::mean())}; }

LegendEntry rangeLook(const QString& name) {
  QColor fill = theme::mean();
  fill.setAlpha(theme::isDark() ? 26 : 22);
  return {name, Qt::NoPen, fill};
}

LegendEntry deviationLook(const QString& name) { return {name, QPen(fadedLine(theme::mean()), 1.2, Qt::DotLine)}; }

LegendEntry stepLook(const QString& name) {
  QPen pen(theme::errorInk(), 4);
  pen.setCapStyle(Qt::RoundCap);
  return {name, pen};
}

namespace {

using Items = std::vector<CurveLegend::Item>;

constexpr std::size_t kMostChips = 8;  // experts with a name of their own in the legend

struct CurveItems {
  Q_DECLARE_TR_FUNCTIONS(CurveItems)
};

std::function<void(bool)> showRows(ReadingModel& readings, int first, int last) {
  return [&readings, first, last](bool shown) {
    for (int row = first; row <= last; ++row) {
      readings.setData(readings.index(row, ReadingModel::kWho), shown ? Qt::Checked : Qt::Unchecked,
                       Qt::CheckStateRole);
    }
  };
}

void addExperts(Items& items, const fuzzy::ForceModel& model, const CurvePlot& plot, ReadingModel& readings) {
  const std::size_t experts = model.experts.size();
  if (experts > kMostChips) {
    LegendEntry all = plot.lineOf(0);
    all.name = CurveItems::tr("%n expert(s)", nullptr, static_cast<int>(experts));
    items.push_back({std::move(all), CurveItems::tr("The lines of all experts; single ones under Forces here"),
                     readings.isShown(1), showRows(readings, 1, static_cast<int>(experts))});
    return;
  }
  for (std::size_t i = 0; i < experts; ++i) {
    const int row = static_cast<int>(i) + 1;
    // The id is short enough for a row of its own; the label is in the tool tip, the table and every picture.
    LegendEntry line = plot.lineOf(i);
    line.name = text(model.experts[i].id);
    items.push_back({std::move(line), CurveItems::tr("Expert %1").arg(labelOf(model.experts[i])), readings.isShown(row),
                     showRows(readings, row, row)});
  }
}

void addSpread(Items& items, std::size_t experts, CurvePlot& plot, const std::function<void()>& changed) {
  if (experts >= 2) {
    items.push_back({rangeLook(CurveItems::tr("Range")),
                     CurveItems::tr("From the lowest to the highest force of the experts who have a rule there"),
                     plot.spreadShown().range, [&plot, changed](bool shown) {
                       plot.setSpreadShown({shown, plot.spreadShown().deviation});
                       changed();
                     }});
  }
  if (experts >= kFewestForDeviation) {
    items.push_back(
        {deviationLook(CurveItems::tr("± 1 SD")),
         CurveItems::tr("Mean ± 1 standard deviation (n − 1) of the %n expert(s), where three or more have a rule. "
                        "So few people say little about others; the range says what these said.",
                        nullptr, static_cast<int>(experts)),
         plot.spreadShown().deviation, [&plot, changed](bool shown) {
           plot.setSpreadShown({plot.spreadShown().range, shown});
           changed();
         }});
  }
}

void addFamily(Items& items, const fuzzy::ForceModel& model, const CurveFamily& family, CurvePlot& plot) {
  for (std::size_t i = 0; i < family.values.size(); ++i) {
    LegendEntry line = plot.familyLine(i);
    const QString tip = CurveItems::tr("%1: the mean of the experts at %2").arg(family.figure, line.name);
    // The name of the input once, where one line stands next to the other.
    if (i > 0) line.name = quantityText(family.values[i], model.inputs[family.input].unit);
    items.push_back(
        {std::move(line), tip, plot.isFamilyShown(i), [&plot, i](bool shown) { plot.setFamilyShown(i, shown); }});
  }
}

}  // namespace

Items curveItems(const SceneController& scene, CurvePlot& plot, ReadingModel& readings,
                 const std::function<void()>& spread_changed) {
  const fuzzy::ForceModel& model = scene.model()->model;
  Items items;
  items.push_back({plot.lineOf(std::nullopt),
                   scene.family() ? CurveItems::tr("The mean of the experts at the operating point")
                                  : CurveItems::tr("The mean of the experts"),
                   readings.isShown(ReadingModel::kMeanRow),
                   showRows(readings, ReadingModel::kMeanRow, ReadingModel::kMeanRow)});
  if (scene.family()) {
    addFamily(items, model, *scene.family(), plot);
  } else {
    addExperts(items, model, plot, readings);
    addSpread(items, model.experts.size(), plot, spread_changed);
  }
  return items;
}

std::optional<int> curveItemOf(const SceneController& scene, int row) {
  if (row == ReadingModel::kMeanRow) return 0;
  if (scene.family()) return std::nullopt;
  if (scene.model()->model.experts.size() <= kMostChips) return row;
  return row == 1 ? std::optional(1) : std::nullopt;
}

namespace {

constexpr int kSwatch = 16;        // px
constexpr int kInside = 6;         // px between the edge of a chip and what is in it
constexpr int kLeastLetters = 10;  // of a name that is cut
constexpr double kOff = 0.35;

}  // namespace

LegendChip::LegendChip(LegendEntry look, const QString& tip, QWidget* parent)
    : QAbstractButton(parent), look_(std::move(look)) {
  setText(look_.name);
  if (!tip.isEmpty()) setToolTip(tr("Show or hide: %1").arg(tip));
  setFont(theme::smallFont());
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
}

void LegendChip::setName(const QString& name) {
  if (name == text()) return;
  setText(name);
  updateGeometry();
}

void LegendChip::setBrief(const QString& brief) {
  brief_ = brief;
  update();
}

void LegendChip::setLook(LegendEntry look) {
  look_ = std::move(look);
  update();
}

QSize LegendChip::sizeHint() const {
  const QFontMetrics metrics(font());
  return {kSwatch + 3 * kInside + metrics.horizontalAdvance(text()), metrics.height() + 6};
}

QSize LegendChip::minimumSizeHint() const {
  const QSize whole = sizeHint();
  return {std::min(whole.width(), kSwatch + 3 * kInside + fontMetrics().averageCharWidth() * kLeastLetters),
          whole.height()};
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
  if (isChecked()) {
    painter.drawLine(QPointF(swatch.left(), middle), QPointF(swatch.right(), middle));
  } else {  // an empty frame: not in the plot
    painter.setPen(QPen(pen.color(), 1));
    painter.drawRect(swatch.adjusted(0.5, 0.5, -0.5, -0.5));
  }
  if (look_.dots && isChecked()) {
    painter.setBrush(pen.color());
    painter.drawEllipse(swatch.center(), 2.2, 2.2);
  }
  painter.setOpacity(1);
  painter.setPen(isChecked() ? theme::ink() : theme::mutedInk());
  const QRect room = rect().adjusted(kSwatch + 2 * kInside, 0, 0, 0);
  const bool fits = fontMetrics().horizontalAdvance(text()) <= room.width();
  const QString shown = fits || brief_.isEmpty() ? text() : brief_;
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(shown, Qt::ElideRight, room.width()));
}

void LegendChip::enterEvent(QEnterEvent* event) {
  update();
  QAbstractButton::enterEvent(event);
}

void LegendChip::leaveEvent(QEvent* event) {
  update();
  QAbstractButton::leaveEvent(event);
}

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
