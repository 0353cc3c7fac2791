// What each participant said at each force, in one series at a time, and the place to correct it.
#pragma once

#include <QStyledItemDelegate>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "core/fuzzy/force_model.h"

class QComboBox;
class QTableView;

namespace tactus::workbench {

class ElidedLabel;
class JudgementGrid;

// Draws the cells of the judgements: each judgement is its word in its color; a corrected one has a corner.

class JudgementDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// `grid` outlives this.
  explicit JudgementDelegate(const JudgementGrid& grid, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  const JudgementGrid& grid_;
};

class JudgementView : public QWidget {
  Q_OBJECT

 public:
  explicit JudgementView(QWidget* parent = nullptr);

  void setJudgements(const fuzzy::Variable& words, std::vector<session::JudgedForce> all);
  const JudgementGrid& grid() const { return *grid_; }
  QTableView& table() { return *view_; }

 public slots:
  /// Says something about the chosen judgement; empty: how to correct one.
  void tell(const QString& sentence);
  /// Chooses a judgement; at once, or as soon as there are judgements.
  void showJudgement(const std::string& participant, const std::string& series, double force_n);
  /// Chooses the column of a force.
  void showForce(double force_n);

 signals:
  /// The user chose the cell of a judgement.
  void judgementChosen(const tactus::session::JudgedForce& judged);
  /// The user chose another word for a judgement.
  void correctionAsked(const tactus::session::JudgedForce& judged, const tactus::session::JudgedWord& word);

 private:
  void showSeries();
  void openMenu(const QModelIndex& index);

  void showWanted();

  struct Wanted {
    std::string participant;
    std::string series;
    double force_n;
  };
  std::optional<Wanted> wanted_;  ///< to be chosen as soon as it is there
  std::vector<session::JudgedForce> all_;
  fuzzy::Variable words_;
  JudgementGrid* grid_;
  QTableView* view_;
  QComboBox* series_;
  ElidedLabel* hint_;
};

}  // namespace tactus::workbench
