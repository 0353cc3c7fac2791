// A box to type an exact number: it takes a decimal point and a decimal comma in every locale, shows no zeros at the
// end, and its unit behind it. What is no number inside the range stays as it was typed, in a red frame with a
// sentence, and changes nothing.
#pragma once

#include <QDoubleSpinBox>
#include <optional>

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
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& place) const override;
  void stepBy(int steps) override;

  /// Only whole numbers may be typed.
  void setWhole();
  /// Shows `value`. Something that is being typed, or was refused, stays where the number itself is the same.
  void setValue(double value);
  /// Shows `value`, which may have more digits than the box.
  void setExact(double value);
  /// What was set so, with all its digits, as long as the box shows it; otherwise what was typed.
  double exact() const { return value() == shown_ ? exact_ : value(); }

  /// Takes what was typed; false where it is no number of the range: then it stays, and the box says why.
  bool commit();
  /// Why what stands in the box was refused; empty where it was not.
  QString refusal() const { return refusal_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool isTyped() const;
  bool takesText();
  void setRefusal(const QString& sentence);

  int digits_ = 0;  ///< after the point, of a number that was not typed
  bool whole_ = false;
  double exact_ = 0;
  double shown_ = 0;
  std::optional<double> typed_;  ///< shown with all its digits
  QString refusal_;
  QString tool_tip_;  ///< while the refusal stands in its place
  QWidget* frame_;
};

}  // namespace tactus::workbench
