// The legend above the curves: a name and a sample of every line. A click shows or hides the line.
#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <functional>
#include <vector>

#include "app/workbench/plot/plot_source.h"

namespace tactus::workbench {

/// One entry of the legend, checked while its line is visible.
class LegendChip : public QAbstractButton {
  Q_OBJECT

 public:
  LegendChip(LegendEntry look, const QString& tip, QWidget* parent);

  /// Changes the name of the line.
  void setName(const QString& name);
  /// Changes the colors of the line.
  void setLook(LegendEntry look);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  LegendEntry look_;
};

class CurveLegend : public QWidget {
  Q_OBJECT

 public:
  explicit CurveLegend(QWidget* parent = nullptr);

  /// The widgets after the items. The last one gets the rest of its row.
  void setTail(std::vector<QWidget*> tail);

  struct Item {
    LegendEntry look;
    QString tip;
    bool shown = true;
    std::function<void(bool)> toggled;
  };
  /// Arranges the items in rows from the left, as many rows as the width needs.
  void setItems(std::vector<Item> items);
  /// Checks or unchecks an item without a signal.
  void setShown(int index, bool shown);
  /// The chip of item `index`, or null.
  LegendChip* chipAt(int index) const;

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return place(width, false); }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::vector<QWidget*> parts() const;
  int place(int width, bool move) const;

  std::vector<LegendChip*> chips_;
  std::vector<QWidget*> tail_;
};

}  // namespace tactus::workbench
