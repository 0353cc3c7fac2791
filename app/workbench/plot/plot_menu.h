// The button in the header of every plot. It copies the plot as a picture or a table, or saves it as PNG, SVG, PDF or
// CSV, with the settings as a caption.
#pragma once

#include <QPen>
#include <QSize>
#include <QString>
#include <QToolButton>
#include <functional>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "core/base/error.h"

class QCPPainter;

namespace tactus::workbench {

// A plot that can be drawn into a picture. All plots with a copy and save button implement it.

/// A legend entry of a picture: a line, or an area if it has a fill.
struct LegendEntry {
  QString name;
  QPen pen;
  QBrush fill = Qt::NoBrush;
  bool dots = false;  ///< the points of the line have dots
};

class PlotSource {
 public:
  PlotSource() = default;
  virtual ~PlotSource() = default;
  PlotSource(const PlotSource&) = delete;
  PlotSource& operator=(const PlotSource&) = delete;

  /// Size of the plot in a picture, px, without legend and caption.
  virtual QSize pictureSize() const { return {1000, 560}; }
  /// The legend entries of the picture, in this order.
  virtual std::vector<LegendEntry> legend() const { return {}; }
  /// Draws the plot in its current state over `size` px at the origin, with its background and without hover marks. A
  /// QCPPainter is a QPainter (plot_style.h). The plot on the screen stays unchanged.
  virtual void paintPicture(QCPPainter& painter, const QSize& size) = 0;
};

class PlotSource;

class PlotMenu : public QToolButton {
  Q_OBJECT

 public:
  /// `table` returns the numbers of `plot` and updates the plot; the picture uses the same caption. It is called only
  /// for copying or saving, and then a model must be open. `plot` must outlive this.
  PlotMenu(PlotSource& plot, std::function<PlotTable()> table, QWidget* parent);

  /// Saves the plot with its caption, completely or not at all: PNG, SVG or PDF by the extension of `path`.
  base::Result<void> savePicture(const QString& path);
  /// Saves the numbers as CSV, after the caption in lines that start with `#`.
  base::Result<void> saveTable(const QString& path);

  QSize sizeHint() const override;

 public slots:
  void copyPicture();
  /// As tab-separated text for a spreadsheet, and as CSV.
  void copyTable();
  /// Asks for a file first. The banner of the window shows an error.
  void choosePicture();
  void chooseTable();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void tell(const base::Result<void>& saved, const QString& path, void (PlotMenu::*again)());

  PlotSource& plot_;
  std::function<PlotTable()> table_;
};

/// The button of the current plot: in the panel with the keyboard focus, else in the panel under the mouse, else the
/// first visible one in `window`. Null if there is none.
PlotMenu* currentPlot(QWidget& window);

}  // namespace tactus::workbench
