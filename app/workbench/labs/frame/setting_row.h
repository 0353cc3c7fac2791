// A setting of a lab: its name, a slider, and a box for the exact number.
#pragma once

#include <QWidget>

class QLabel;
class QSlider;

namespace tactus::workbench {

class NumberBox;

class SettingRow : public QWidget {
  Q_OBJECT

 public:
  struct Range {
    double min;
    double max;
    double step;     ///< of the slider
    QString unit{};  ///< for the screen; empty: none
    bool whole = false;
  };
  SettingRow(const QString& name, const QString& what, const Range& range, QWidget* parent = nullptr);

  double value() const { return value_; }
  /// Shows `value`; emits nothing.
  void setValue(double value);

 signals:
  /// The person moved the slider or typed a number; `value` is in the range.
  void changed(double value);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void take(double value);

  Range range_;
  double value_;
  QLabel* name_;
  QSlider* slider_;
  NumberBox* box_;
};

}  // namespace tactus::workbench
