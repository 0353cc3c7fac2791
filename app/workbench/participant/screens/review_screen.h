// All answers as grids, one condition after the other: a tap changes a cell, open ones pulse, at the end she locks
// them.
#pragma once

#include <QAbstractButton>
#include <QGridLayout>
#include <QVariantAnimation>
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
  /// `word`: very_small … very_large, cant_tell; empty: open. `situation` is what it answers, for screen readers.
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

class ReviewScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ReviewScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;
  /// Which grid: 0 lubrication, 1 neck flexion, 2 speed.
  void setPage(int page);
  int page() const { return page_; }

 signals:
  void cellPicked(int item);

 protected:
  bool turnPage(int by) override;
  bool hasPageBefore() const override { return page_ > 0 && !state_.sealed; }

 private:
  void build();

  ReviewState state_;
  int page_ = 0;
  QWidget* page_widget_ = nullptr;
};

}  // namespace tactus::workbench::nurse
