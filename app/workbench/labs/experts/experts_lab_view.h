// The experts' lab on the screen: weights and what leaving one out changes, the weight policies, the distances between
// experts, and the averaged force with everybody's pull.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/frame/lab_card.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace tactus::workbench {

/// An expert with the weight, which can be edited, and what leaving this one out would change.
struct WeightRow {
  std::string id;
  std::size_t number = 0;  ///< of the color
  QString expert, weight, rms, largest, noticeable, where;
};

class PullPlot;
class SettingRow;

class ExpertsLabView : public LabView {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit ExpertsLabView(ExpertsLab& lab, QWidget* parent = nullptr);

  Columns<WeightRow>& weights() { return *weights_; }
  PullPlot& plot() { return *plot_; }

 signals:
  /// The user wants to tune the averaged model.
  void benchAsked();

 private:
  QWidget* makeLeft();
  QWidget* makeRight();
  void makeSettings();
  void follow();
  void followCurves();
  void followBand();

  ExpertsLab& lab_;
  Columns<WeightRow>* weights_;
  Columns<PolicyRow>* policies_;
  Columns<DistanceRow>* pairs_;
  std::shared_ptr<const elicitation::BuiltModel> of_;  ///< what `pairs_` shows
  PullPlot* plot_;
  QComboBox* policy_;
  QPushButton* open_;
  QLabel* failure_;
  QComboBox* band_;
  QLabel* band_text_;
  QWidget* settings_;
  std::vector<std::pair<std::size_t, SettingRow*>> rows_;  ///< with their input
};

}  // namespace tactus::workbench
