// The experts' lab on the screen: weights and what leaving one out changes, the weight policies, the distances between
// experts, and the averaged force with everybody's pull.
#pragma once

#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class ExpertsLab;
class PairTable;
class PolicyTable;
class PullPlot;
class SettingRow;
class WeightTable;

class ExpertsLabView : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit ExpertsLabView(ExpertsLab& lab, QWidget* parent = nullptr);

  WeightTable& weights() { return *weights_; }
  PullPlot& plot() { return *plot_; }

 signals:
  /// The user wants to tune the averaged model.
  void benchAsked();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeLeft();
  QWidget* makeRight();
  void makeSettings();
  void follow();
  void followCurves();
  void followBand();

  ExpertsLab& lab_;
  WeightTable* weights_;
  PolicyTable* policies_;
  PairTable* pairs_;
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
