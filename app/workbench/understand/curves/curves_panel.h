// The main panel: the plot of the curves, the choice of the x axis, the settings of the paper's figures, the legend,
// the change since an edit, and reference curves.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "app/figures/force_curves.h"
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

 signals:
  /// The user asks for edits that bring the force to the curve `name`.
  void pullAsked(const QString& name);

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

/// What is drawn while a curve is pulled (understand/pull).
struct PullMarks {
  std::optional<std::size_t> expert;  ///< whose line; nothing: the mean
  /// The place on the line, with a handle at the wanted force.
  struct Handle {
    double x = 0;
    std::optional<double> now_n;
    double wanted_n = 0;
    std::optional<figures::Interval> reach_n;  ///< what one edit reaches
    QString says;                              ///< the wanted force, beside the handle
  };
  std::optional<Handle> handle;
  /// The force should lie in `force_n` over `x`.
  struct Band {
    figures::Interval x;
    figures::Interval force_n;
  };
  std::optional<Band> band;
  /// The line stays here.
  struct Pin {
    double x = 0;
    double force_n = 0;
  };
  std::vector<Pin> pins;
  std::vector<double> x;                 ///< of `curve`
  std::vector<fuzzy::Evaluation> curve;  ///< the line after the edit that is looked at; empty: none
};

/// Where a simulator is that runs elsewhere.
struct SimulatorMark {
  QString name;  ///< what stands beside it
  double x = 0;  ///< on the x axis
  double force_n = 0;
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
  /// Null: nothing is pulled.
  void setPull(const PullMarks* pull);
  /// In the units of the x axis that is shown.
  void setSimulators(std::vector<SimulatorMark> marks);
  /// Where `x` of the x axis and a force are in this panel, px.
  QPoint pixelOf(double x, double force_n) const;

 signals:
  /// A line was taken with Alt at `x` of the x axis, that of `expert` or of the mean; then where the mouse takes it.
  void grabbed(std::optional<std::size_t> expert, double x, double force_n);
  /// A band was drawn with Alt and Shift, between two corners.
  void bandDrawn(tactus::figures::Interval x, tactus::figures::Interval force_n);
  /// The handle of the pulled line was moved.
  void pulledTo(double force_n);
  void pullReleased();
  /// A key moves the wanted force by `by_n`, at the operating point where nothing is pulled yet.
  void pullStepped(double by_n);
  /// A key, or another place that is clicked, ends what the keys pull.
  void pullDropped();
  /// The user pins the force at `x` of the x axis, or takes the pin away that is there.
  void pinAsked(double x);
  /// The user asks for edits that bring the force elsewhere at the place that is read.
  void pullAsked();
  /// The user asks for edits that bring the force to the reference curve `name`.
  void pullToReferenceAsked(const QString& name);
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
