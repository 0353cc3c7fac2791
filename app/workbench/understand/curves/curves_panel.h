// The main panel: the plot of the curves, the choice of the x axis, the settings of the paper's figures, the legend,
// the change since an edit, and reference curves.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <optional>
#include <string>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/understand/curves/curve_legend.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace tactus::workbench {

class CurveLegend;
class CurvePlot;
class ElidedLabel;
class GhostController;
class LegendChip;
class PlotMenu;
class ReadingModel;
class ReferenceController;
class Refresh;
class SceneController;

// The bar below the curves: the difference between the model and each reference curve, and a button to remove the
// curve.

class ReferenceBar : public QWidget {
  Q_OBJECT

 public:
  ReferenceBar(ReferenceController& references, const SceneController& scene, QWidget* parent = nullptr);

  /// Shows the current differences.
  void showDifferences();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void build();
  void colorNames();
  void listExperts();

  ReferenceController& references_;
  const SceneController& scene_;
  QWidget* rows_ = nullptr;
  QComboBox* against_;
  QList<QLabel*> names_;
  QList<ElidedLabel*> texts_;
};

// The menu of the settings and families of the paper's figures. The button shows the figure whose family of curves is
// visible.

/// Hidden if the model does not have the inputs of the figures.
class FigureButton : public QPushButton {
  Q_OBJECT

 public:
  explicit FigureButton(SceneController& scene, QWidget* parent = nullptr);

 private:
  void adoptModel();
  void showFamily();

  SceneController& scene_;
};

class CurvesPanel : public Card {
  Q_OBJECT

 public:
  CurvesPanel(SceneController& scene, ReadingModel& readings, GhostController& ghost, ReferenceController& references,
              QWidget* parent = nullptr);

  PlotMenu& plotMenu() { return *menu_; }
  /// True during a drag: thin lines without smoothing.
  void setFast(bool fast);
  void setSpreadShown(SpreadShown shown);
  /// A second cursor on the x axis, from which the reading counts its difference; nothing: that is the operating point.
  void setMark(std::optional<double> x);
  std::optional<double> mark() const { return mark_; }

 signals:
  /// The second cursor was set, moved or taken away.
  void markChanged();
  /// The user chose another spread.
  void spreadChosen(tactus::workbench::SpreadShown shown);
  /// The user asks where the averaged force at `x` of the x axis comes from.
  void originAsked(double x);

 protected:
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void adoptModel();
  void showAxes();
  void showTerms();
  void onXInputChosen(int index);
  void onRowShown(int row);
  void onMarked(double x);
  void showFamily();
  void showLines();
  void showLine(int row);
  void showLegend();
  void drawCurves();
  void drawSteps();
  void drawGhost();
  void showReading();
  void drawReferences();
  PlotTable table();
  QStringList notes() const;

  SceneController& scene_;
  std::optional<double> mark_;
  std::string mark_input_;  ///< the input of mark_
  ReadingModel& readings_;
  GhostController& ghost_;
  ReferenceController& references_;
  QLabel* title_;
  QComboBox* x_input_;
  CurvePlot* plot_;
  PlotMenu* menu_;
  CurveLegend* legend_;
  LegendChip* ghost_chip_;
  ElidedLabel* difference_;
  QToolButton* go_there_;
  ElidedLabel* step_;
  ReferenceBar* reference_bar_;
  Refresh* draw_curves_;
  Refresh* draw_ghost_;
  Refresh* draw_references_;
  Refresh* draw_reading_;
};

}  // namespace tactus::workbench
