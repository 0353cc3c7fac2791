// The button at the head of every plot: copies the plot as a picture or a table, or saves it as PNG, SVG, PDF or CSV,
// with the settings as a caption.
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
  /// `table` gives the numbers that `plot` shows and has the plot show what is newest; its caption is that of the
  /// picture too. It is called when something is copied or saved only. A model must be open by then. `plot` must live
  /// as long as this.
  PlotMenu(PlotSource& plot, std::function<PlotTable()> table, QWidget* parent);

  /// The plot with its caption, whole or not at all: PNG, SVG or PDF by the ending of `path`.
  base::Result<void> savePicture(const QString& path);
  /// The numbers as CSV, the caption above them in lines that start with `#`.
  base::Result<void> saveTable(const QString& path);

  QSize sizeHint() const override;

 public slots:
  void copyPicture();
  /// As text with tabs for a spreadsheet, and as CSV.
  void copyTable();
  /// Asks for a file first. What goes wrong is said in the banner of the window.
  void choosePicture();
  void chooseTable();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void tell(const base::Result<void>& saved, const QString& path);

  PlotSource& plot_;
  std::function<PlotTable()> table_;
};

/// The button of the plot that is meant without pointing at it: of the panel with the keyboard, otherwise of the panel
/// under the mouse, otherwise the first one in `window` that can be seen. Null where there is none.
PlotMenu* currentPlot(QWidget& window);

}  // namespace tactus::workbench
