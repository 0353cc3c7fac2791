// A box to type an exact number: decimal point in every locale, no zeros at the end, its unit behind it.
#pragma once

#include <QDoubleSpinBox>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// A step that divides the universe of `variable` into 90 to 900 parts, a power of ten in its unit.
double stepOf(const fuzzy::Variable& variable);

class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  /// A number in the universe of `variable`, moved by `step`.
  NumberBox(const fuzzy::Variable& variable, double step, QWidget* parent = nullptr);

  QString textFromValue(double value) const override;

  /// Shows `value`, which may have more digits than the box.
  void setExact(double value);
  /// What was set so, with all its digits, as long as the box shows it; otherwise what was typed.
  double exact() const { return value() == shown_ ? exact_ : value(); }

 private:
  double exact_ = 0;
  double shown_ = 0;
};

}  // namespace tactus::workbench
