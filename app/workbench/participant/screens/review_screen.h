// All answers as grids, one condition after the other: a tap changes a cell, open ones pulse, at the end she locks
// them.
#pragma once

#include <QAbstractButton>
#include <QGridLayout>
#include <QVariantAnimation>
#include <string>
#include <vector>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

/// One answer in a review grid. Open ones pulse.
class ReviewCell : public QAbstractButton {
  Q_OBJECT

 public:
  ReviewCell(const Look& look, int item, QWidget* parent = nullptr);

  int item() const { return item_; }
  /// `word`: a term of the force, cant_tell; empty: open. `situation` is what it answers, for screen readers.
  void setAnswer(const QString& word, const QString& situation);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool hitButton(const QPoint& at) const override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refreshState();

  const Look& look_;
  int item_;
  QString word_;
  QString situation_;
  QVariantAnimation pulse_{this};
  double glow_ = 0;
};

/// One grid: the words of a condition beside each other, the regions below each other.
struct ReviewPage {
  std::vector<study::ItemCondition> fixed;  ///< the other conditions of its answers
  std::string input;                        ///< of the columns; empty: the answers have no condition
  std::vector<std::string> terms;           ///< of the columns, in their order
  std::vector<QString> regions;             ///< of the rows, in the order of the way; an empty one: of no region

  /// The answer in a cell, or null.
  const ReviewAnswer* answer(const std::vector<ReviewAnswer>& answers, std::size_t row, std::size_t column) const;
};

/// The pages of `answers`, in their order. A page has as many regions as there is room for.
std::vector<ReviewPage> reviewPages(const procedure::Procedure& procedure, const study::Form& form,
                                    const std::vector<ReviewAnswer>& answers);

class ReviewScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ReviewScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;
  /// Which grid, from 0.
  void setPage(int page);
  int page() const { return page_; }

 signals:
  void cellPicked(int item);

 protected:
  bool turnPage(int by) override;
  bool hasPageBefore() const override { return page_ > 0 && !state_.sealed; }

 private:
  void build();
  void fill(QGridLayout& grid, const ReviewPage& page);
  QString nameOf(const QString& region) const;
  bool isLast() const { return page_ + 1 >= static_cast<int>(pages_.size()); }

  ReviewState state_;
  std::vector<ReviewPage> pages_;
  int page_ = 0;
  QWidget* page_widget_ = nullptr;
};

}  // namespace tactus::workbench::nurse
