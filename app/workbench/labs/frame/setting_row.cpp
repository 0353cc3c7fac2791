#include "app/workbench/labs/frame/setting_row.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/number_box.h"

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
  connect(slider_, &QSlider::valueChanged, this, [this](int place) { take(range_.min + place * range_.step); });
  connect(box_, &QDoubleSpinBox::valueChanged, this, [this] { take(box_->exact()); });
}

void SettingRow::setValue(double value) {
  value_ = value;
  const QSignalBlocker quiet_slider(slider_);
  const QSignalBlocker quiet_box(box_);
  slider_->setValue(static_cast<int>(std::lround((value - range_.min) / range_.step)));
  box_->setValue(value);
}

void SettingRow::take(double value) {
  value = std::clamp(value, range_.min, range_.max);
  if (value == value_) return;
  setValue(value);
  emit changed(value);
}

void SettingRow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::EnabledChange) name_->setEnabled(isEnabled());
  QWidget::changeEvent(event);
}

}  // namespace tactus::workbench
