// The window "Where it comes from": the records behind a number, what each of them moves, and its raw data.
#pragma once

#include <QDialog>
#include <functional>

#include "app/workbench/base/columns.h"
#include "app/workbench/labs/origins/origin_finder.h"

class QLabel;
class QPushButton;
class QTableView;

namespace tactus::workbench {

/// A record behind the number, with its place in the order.
struct OriginRow {
  std::size_t index = 0;
  OriginRecord record;
};

class OriginWindow : public QDialog {
  Q_OBJECT

 public:
  /// `finder` outlives this.
  explicit OriginWindow(OriginFinder& finder, QWidget* parent = nullptr);

  /// Shows `preview`, which this owns from now on, below the records while one is chosen that it can show: the raw
  /// trace of a stroke. `shows` gives it the record and says whether it can.
  void setPreview(QWidget* preview, std::function<bool(const OriginRecord&)> shows);
  QTableView& table() { return *view_; }
  /// The chosen record, or null.
  const OriginRecord* chosen() const;

 signals:
  /// The user clicked a record: its lab shows it.
  void recordChosen(const tactus::workbench::OriginRecord& record);
  /// The user asks for all that its participant said and did.
  void participantAsked(const tactus::workbench::OriginRecord& record);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refreshState();
  void followChosen();
  int chosenRow() const;
  void lead();

  OriginFinder& finder_;
  QLabel* title_;
  QLabel* notes_;
  Columns<OriginRow>* table_;
  QTableView* view_;
  QLabel* moved_;
  QWidget* preview_ = nullptr;
  std::function<bool(const OriginRecord&)> shows_;
  QPushButton* lead_;
  QPushButton* participant_;
  bool placed_ = false;
};

}  // namespace tactus::workbench
