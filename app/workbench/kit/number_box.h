// A box for an exact number. It takes a decimal point or comma in every locale, shows no trailing zeros, and shows the
// unit after the number. Refused input (no number, or out of range) changes nothing: the text stays in the box, with a
// red frame and a sentence that says why.
#pragma once

#include <QDoubleSpinBox>
#include <optional>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// A power of ten, in the unit of `variable`, that divides its universe into 90 to 900 steps.
double stepOf(const fuzzy::Variable& variable);

class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  /// A number in the universe of `variable`; the arrow keys move it by `step`.
  NumberBox(const fuzzy::Variable& variable, double step, QWidget* parent = nullptr);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& place) const override;
  void stepBy(int steps) override;

  /// Is as wide as `widest`, whatever the font. At first it has room for both ends of the universe.
  void setRoomFor(const QString& widest);
  const QString& roomFor() const { return room_for_; }
  /// Accepts only whole numbers from now on.
  void setWhole();
  /// Shows `value`. If the value is unchanged, text in progress or refused text stays in the box.
  void setValue(double value);
  /// Shows `value`, which may have more digits than the box shows.
  void setExact(double value);
  /// The value given to `setExact`, with all its digits, while the box shows it; otherwise the typed number.
  double exact() const { return value() == shown_ ? exact_ : value(); }

  /// Takes the typed text as the value. Returns false if it is refused: the text stays, and the box says why, until it
  /// is mended, or Esc or the end of the page brings the value back.
  bool commit();
  /// Why the text in the box was refused; empty if it was not.
  QString refusal() const { return refusal_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool isTyped() const;
  bool takesText();
  /// Shows the value again instead of what is typed.
  void restore();
  void setRefusal(const QString& sentence);

  QString room_for_;
  int digits_ = 0;  ///< digits after the point of a number that was set, not typed
  bool whole_ = false;
  double exact_ = 0;
  double shown_ = 0;
  std::optional<double> typed_;  ///< the typed number, shown with all its digits
  QString refusal_;
  QString tool_tip_;  ///< the normal tool tip, kept while the box shows a refusal
  QWidget* frame_;
};

}  // namespace tactus::workbench
