// All answers as grids, one condition after the other: a tap changes a cell, open ones pulse, at the end she locks
// them.
#pragma once

#include <QGridLayout>
#include <vector>

#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/review_cell.h"

namespace tactus::workbench::nurse {

struct ReviewAnswer {
  int item = 0;       ///< the number of the question in the form
  QString condition;  ///< `lubrication`, `neck_flexion` or `speed`
  QString term;
  QString region;
  QString word;  ///< empty: open
};

struct ReviewState {
  std::vector<ReviewAnswer> answers;
  bool sealed = false;
  bool simulated = false;
};

class ReviewScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ReviewScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ReviewState& state);
  /// Which grid: 0 lubrication, 1 neck flexion, 2 speed.
  void setPage(int page);
  int page() const { return page_; }

  void setMayGoBack(bool may) override;

 signals:
  void cellPicked(int item);
  void seal();
  void goOn();  ///< after the answers are locked
  void left();  ///< Back from the first grid

 private:
  void build();
  int gaps() const;
  void press();

  ReviewState state_;
  int page_ = 0;
  QWidget* page_widget_ = nullptr;
  bool may_leave_ = true;  ///< Back from the first page
};

}  // namespace tactus::workbench::nurse
