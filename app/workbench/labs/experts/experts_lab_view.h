// The experts' lab on the screen: weights and what leaving one out changes, the weight policies, the distances between
// experts, and the averaged force with everybody's pull.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/frame/lab_table_model.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace tactus::workbench {

/// The experts with their weights and what leaving each one out would change, as an item model. The weights can be
/// edited.
class WeightTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kExpert, kWeight, kRms, kLargest, kNoticeable, kWhere };

  /// `lab` outlives this.
  explicit WeightTable(ExpertsLab& lab, QObject* parent = nullptr);

  /// Shows what the lab has.
  void follow();

  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;
  QString shown(std::size_t expert, int column) const;

  ExpertsLab& lab_;
  std::shared_ptr<const elicitation::BuiltModel> built_;
  std::vector<std::size_t> numbers_;  ///< of the experts, for their colors
};

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
