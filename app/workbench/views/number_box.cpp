#include "app/workbench/views/number_box.h"

#include <algorithm>
#include <cmath>

#include "app/workbench/display_text.h"

namespace tactus::workbench {

double stepOf(const fuzzy::Variable& variable) {
  return std::pow(10.0, std::floor(std::log10((variable.max - variable.min) / 90)));
}

NumberBox::NumberBox(const fuzzy::Variable& variable, double step, QWidget* parent) : QDoubleSpinBox(parent) {
  setLocale(QLocale::c());
  setGroupSeparatorShown(false);
  // Two digits more than the step: exact values such as a measured speed can be typed.
  setDecimals(std::max(0, static_cast<int>(std::ceil(-std::log10(step)))) + 2);
  setRange(variable.min, variable.max);
  setSingleStep(step);
  setKeyboardTracking(false);
  setAlignment(Qt::AlignRight);
  const QString unit = unitText(variable.unit);
  if (!unit.isEmpty()) setSuffix(QLatin1Char(' ') + unit);
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  // Room for both ends of the universe with a place more, as the mouse sets them.
  int width = fontMetrics().horizontalAdvance(QStringLiteral("0.25"));
  for (const double end : {variable.min, variable.max}) {
    width = std::max(width, fontMetrics().horizontalAdvance(numberText(end) + QStringLiteral(".0")));
  }
  setFixedWidth(width + fontMetrics().horizontalAdvance(suffix()) + 10);
  setAccessibleName(labelOf(variable));
}

void NumberBox::setExact(double value) {
  setValue(value);
  exact_ = value;
  shown_ = this->value();
}

QString NumberBox::textFromValue(double value) const { return numberText(value, decimals()); }

}  // namespace tactus::workbench
