// The button in the header of every plot. It copies the plot as a picture or a table, or saves it as PNG, SVG, PDF or
// CSV, with the settings as a caption.
#pragma once

#include <QToolButton>
#include <functional>

#include "app/workbench/base/plot_table.h"
#include "core/base/error.h"

namespace tactus::workbench {

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
