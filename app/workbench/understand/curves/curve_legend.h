// The legend above the curves, in one row: a name and a sample of every line. A click shows or hides the line.
#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "app/workbench/plot/plot_menu.h"

class QToolButton;

namespace tactus::workbench {

// The looks of all lines but those of the mean and the experts, in the plot of the curves and its legends.

/// Line `index` of `count` of a family: gray, as it belongs to no expert and is no force; darker
/// and wider with the value, with dashes of its own.
QPen familyPen(std::size_t index, std::size_t count, bool fast = false);
/// The line of reference `index`. No expert and no mean has its color.
QPen referencePen(std::size_t index);

LegendEntry ghostLook(const QString& name);
LegendEntry rangeLook(const QString& name);
LegendEntry deviationLook(const QString& name);
/// A step of the force: a thick line in the error color.
LegendEntry stepLook(const QString& name);

/// The visible parts of a spread.
struct SpreadShown {
  bool range = true;
  bool deviation = false;
};

/// One entry of the legend of the curves: a sample of the line and its name, checked while the line is visible.
class LegendChip : public QAbstractButton {
  Q_OBJECT

 public:
  LegendChip(LegendEntry look, const QString& tip, QWidget* parent);

  /// Changes the name of the line.
  void setName(const QString& name);
  /// Shown instead of the name where that does not fit.
  void setBrief(const QString& brief);
  /// Changes the colors of the line.
  void setLook(LegendEntry look);

  QSize sizeHint() const override;
  /// With the beginning of a long name.
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  LegendEntry look_;
  QString brief_;
};

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

// The entries of the legend above the curves.

class CurvePlot;
class ReadingModel;
class SceneController;

/// The mean first; then either the experts (one entry for all if there are many) and the parts of their spread, or the
/// lines of a family. Calls `spread_changed` after a part of the spread was shown or hidden. All arguments must outlive
/// the items.
std::vector<CurveLegend::Item> curveItems(const SceneController& scene, CurvePlot& plot, ReadingModel& readings,
                                          const std::function<void()>& spread_changed);

/// The index of the item that belongs to `row` of the readings; nothing if there is none.
std::optional<int> curveItemOf(const SceneController& scene, int row);

}  // namespace tactus::workbench
