// The experts' lab on the screen: weights and what leaving one out changes, the weight policies, the distances between
// experts, and the averaged force with everybody's pull.
#pragma once

#include <QWidget>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"

class QCPAxisRect;
class QCPGraph;
class QComboBox;
class QCustomPlot;
class QLabel;
class QPushButton;

namespace tactus::workbench {

// The averaged force along the depth with every expert, and below it who pulls where: each expert's distance from the
// mean, beside what a hand notices.

class LeaveOneOutPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit LeaveOneOutPlot(QWidget* parent = nullptr);

  /// `x_input`: the input of the curves.
  void setCurves(const fuzzy::ForceModel& model, std::size_t x_input, const figures::ForceCurves& curves);
  /// The band around the mean, in place of that from the lowest to the highest expert; null: that one.
  void setBand(const ShownBand* band);
  void clear();

  QSize pictureSize() const override { return {1000, 760}; }
  std::vector<LegendEntry> legend() const override { return legend_; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  QCPGraph& addLine(QCPAxisRect& area, const QPen& pen);
  void drawBand(const figures::ForceCurves& curves);
  void drawExperts(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                   const std::vector<std::size_t>& numbers);
  void drawOwnWords(const fuzzy::ForceModel& model, const std::vector<std::size_t>& numbers);
  void drawForces(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                  const std::vector<std::size_t>& numbers);
  void drawPulls(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                 const std::vector<std::size_t>& numbers);

  QCustomPlot* plot_;
  QCPAxisRect* forces_;
  QCPAxisRect* pulls_;
  std::vector<LegendEntry> legend_;
  std::optional<ShownBand> band_;
};

// Whose words, whose rules: the disagreement of the experts with shared and with own words, by shared and by own rules.

/// A row of it: shared or own words.
struct WordsRow {
  QString words, shared_rules, own_rules, shared_tip, own_tip;
};

class WordsAndRulesView : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit WordsAndRulesView(ExpertsLab& lab, QWidget* parent = nullptr);

  const Columns<WordsRow>& table() const { return *table_; }
  QString sentence() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refreshState();

  ExpertsLab& lab_;
  Columns<WordsRow>* table_;
  QTableView* view_;
  QLabel* sentence_;
  QLabel* notes_;
};

/// An expert with the weight, which can be edited, and what leaving this one out would change.
struct WeightRow {
  std::string id;
  std::size_t number = 0;  ///< of the color
  QString expert, weight, rms, largest, noticeable, where;
};

class LeaveOneOutPlot;
class SettingRow;

class ExpertsLabView : public LabView {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit ExpertsLabView(ExpertsLab& lab, QWidget* parent = nullptr);

  Columns<WeightRow>& weights() { return *weights_; }
  LeaveOneOutPlot& plot() { return *plot_; }
  /// The place of the curves is set elsewhere in the window, or here.
  void setPlaceElsewhere(bool elsewhere) { settings_->setVisible(!elsewhere); }

 signals:
  /// The user wants to tune the averaged model.
  void benchAsked();

 private:
  QWidget* makeLeft();
  QWidget* makeRight();
  void makeSettings();
  void refreshState();
  void followCurves();
  void followBand();

  ExpertsLab& lab_;
  Columns<WeightRow>* weights_;
  Columns<PolicyRow>* policies_;
  Columns<DistanceRow>* pairs_;
  std::shared_ptr<const elicitation::BuiltModel> of_;  ///< what `pairs_` shows
  LeaveOneOutPlot* plot_;
  QComboBox* policy_;
  QPushButton* open_;
  QLabel* failure_;
  QComboBox* band_;
  QLabel* band_text_;
  QWidget* settings_;
  std::vector<std::pair<std::size_t, SettingRow*>> rows_;  ///< with their input
};

}  // namespace tactus::workbench
