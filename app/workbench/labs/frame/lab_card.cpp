#include "app/workbench/labs/frame/lab_card.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProxyStyle>
#include <QSignalBlocker>
#include <QSlider>
#include <QSortFilterProxyModel>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/columns.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/kit/quiet_table.h"

namespace tactus::workbench {
namespace {

fuzzy::Variable universe(const QString& name, const SettingRow::Range& range) {
  fuzzy::Variable out;
  out.id = "setting";
  out.label = name.toStdString();
  out.unit = range.unit.toStdString();
  out.min = range.min;
  out.max = range.max;
  return out;
}

}  // namespace

SettingRow::SettingRow(const QString& name, const QString& what, const Range& range, QWidget* parent)
    : QWidget(parent),
      range_(range),
      value_(range.min),
      name_(new QLabel(name, this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      box_(new NumberBox(universe(name, range), range.step, this)) {
  setToolTip(what);
  slider_->setRange(0, static_cast<int>(std::lround((range.max - range.min) / range.step)));
  slider_->setAccessibleName(name);
  if (range.whole) box_->setWhole();
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(theme::kGrid);
  layout->setVerticalSpacing(2);
  layout->addWidget(name_, 0, 0);
  layout->addWidget(box_, 0, 1, Qt::AlignRight);
  layout->addWidget(slider_, 1, 0, 1, 2);
  connect(slider_, &QSlider::valueChanged, this, [this](int place) { setByHand(range_.min + place * range_.step); });
  connect(box_, &QDoubleSpinBox::valueChanged, this, [this] { setByHand(box_->exact()); });
}

void SettingRow::setValue(double value) {
  value_ = value;
  const QSignalBlocker quiet_slider(slider_);
  const QSignalBlocker quiet_box(box_);
  slider_->setValue(static_cast<int>(std::lround((value - range_.min) / range_.step)));
  box_->setValue(value);
}

void SettingRow::setByHand(double value) {
  value = std::clamp(value, range_.min, range_.max);
  if (value == value_) return;
  setValue(value);
  emit changed(value);
}

void SettingRow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::EnabledChange) name_->setEnabled(isEnabled());
  QWidget::changeEvent(event);
}

namespace {

constexpr int kCellPad = 5;        // px on each side: a number at the right keeps off the words of the next column
constexpr int kMeasuredRows = 20;  // of long tables, for the widths of the columns

class RoomyCells : public QProxyStyle {
 public:
  RoomyCells() : QProxyStyle(QStringLiteral("Fusion")) {}
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    const bool pad = metric == PM_FocusFrameHMargin || metric == PM_HeaderMargin;
    return pad ? kCellPad : QProxyStyle::pixelMetric(metric, option, widget);
  }
};

}  // namespace

QTableView* makeLabTable(QAbstractItemModel& model, int stretched, const QString& accessible_name, QWidget* parent) {
  QTableView* const view = makeQuietTable(model, accessible_name, parent);
  QHeaderView* const head = view->horizontalHeader();
  auto* const roomy = new RoomyCells;
  roomy->setParent(view);
  for (QWidget* widget : {static_cast<QWidget*>(view), static_cast<QWidget*>(head)}) widget->setStyle(roomy);
  head->setResizeContentsPrecision(kMeasuredRows);
  head->setTextElideMode(Qt::ElideRight);
  head->setSectionResizeMode(QHeaderView::ResizeToContents);
  if (stretched >= 0) {
    head->setSectionResizeMode(stretched, QHeaderView::Stretch);
  } else {
    head->setStretchLastSection(true);
  }
  return view;
}

QTableView* makeSortedLabTable(QAbstractItemModel& model, int stretched, const QString& accessible_name,
                               QWidget* parent) {
  auto* const sorted = new QSortFilterProxyModel;
  sorted->setSourceModel(&model);
  sorted->setSortRole(kOrderRole);
  QTableView* const view = makeLabTable(*sorted, stretched, accessible_name, parent);
  sorted->setParent(view);
  QHeaderView* const head = view->horizontalHeader();
  head->setSectionsClickable(true);
  head->setSortIndicatorClearable(true);
  head->setSortIndicator(-1, Qt::AscendingOrder);  // newer Qt reverses what is not sorted, too
  view->setSortingEnabled(true);
  return view;
}

namespace {

struct LabCaption {
  Q_DECLARE_TR_FUNCTIONS(LabCaption)
};

QString simulatedText(const std::vector<study::Participant>& participants) {
  QStringList simulated;
  for (const study::Participant& one : participants) {
    if (one.simulated) simulated << harmless(text(one.code));
  }
  if (simulated.isEmpty()) return {};
  return LabCaption::tr("SIMULATED: data of %1").arg(simulated.join(QStringLiteral(", ")));
}

}  // namespace

PlotTable labTable(const LabData& data, const QString& what, const QString& suffix, const QStringList& notes) {
  const QFileInfo study(data.connection().path());
  PlotTable table;
  table.file = study.absolutePath() + QLatin1Char('/') + study.completeBaseName() + suffix;
  table.caption << QStringLiteral("%1: %2").arg(data.connection().fileName(), what);
  table.caption << notes;
  const QString simulated = data.study() == nullptr ? QString() : simulatedText(data.study()->study.participants);
  if (!simulated.isEmpty()) table.caption << simulated;
  return table;
}

LabView::LabView(const QString& name, const QString& title, std::function<void(bool)> set_wanted, QWidget* parent)
    : QWidget(parent), set_wanted_(std::move(set_wanted)) {
  setObjectName(name);
  setWindowTitle(title);
}

void LabView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  set_wanted_(true);
}

// Not while it is being destroyed: then only what is left of it would hear what follows.
void LabView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  set_wanted_(false);
}

LabCard::LabCard(const QString& title, QWidget* content, const QString& brief) : head_(new QHBoxLayout) {
  auto* heading = new ElidedLabel(this);
  heading->setFont(theme::headingFont());
  heading->setFullText(title, brief);
  head_->setContentsMargins(theme::kGrid, 0, 0, 0);
  head_->setSpacing(theme::kGrid);
  head_->addWidget(heading, 1);
  makeColumn(this, {head_, {content, 1}}, 0, inset(theme::kGrid));
}

void LabCard::addTool(QWidget* tool) { head_->addWidget(tool); }

}  // namespace tactus::workbench
