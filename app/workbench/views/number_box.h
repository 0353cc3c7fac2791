// A box to type an exact number: decimal point in every locale, no zeros at the end, its unit behind it.
#pragma once

#include <QDoubleSpinBox>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  /// A number in the universe of `variable`, moved by `step`.
  NumberBox(const fuzzy::Variable& variable, double step, QWidget* parent = nullptr);

  QString textFromValue(double value) const override;
};

}  // namespace tactus::workbench
