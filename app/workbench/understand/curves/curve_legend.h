// The legend above the curves, in one row: a name and a sample of every line. A click shows or hides the line.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "app/workbench/understand/curves/legend_chip.h"

class QToolButton;

namespace tactus::workbench {

class CurveLegend : public QWidget {
  Q_OBJECT

 public:
  explicit CurveLegend(QWidget* parent = nullptr);

  /// The widgets after the items. The last one gets the rest of the row. If the row is full, it and the chips among
  /// these widgets become narrower.
  void setTail(std::vector<QWidget*> tail);

  struct Item {
    LegendEntry look;
    QString tip;
    bool shown = true;
    std::function<void(bool)> toggled;
  };
  /// Arranges the items from the left. Items without room move into the menu of a button, hidden lines first.
  void setItems(std::vector<Item> items);
  /// Checks or unchecks an item without a signal.
  void setShown(int index, bool shown);
  /// The chip of item `index`, or null.
  LegendChip* chipAt(int index) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::vector<QWidget*> tail() const;
  std::vector<LegendChip*> chipsWithin(int room) const;
  void arrange();
  void fillMenu();

  std::vector<LegendChip*> chips_;
  std::vector<QWidget*> tail_;
  QToolButton* more_;
};

}  // namespace tactus::workbench
