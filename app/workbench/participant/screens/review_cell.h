// One answer in a review grid. Open ones pulse.
#pragma once

#include <QAbstractButton>
#include <QVariantAnimation>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

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
  void follow();

  const Look& look_;
  int item_;
  QString word_;
  QString situation_;
  QVariantAnimation pulse_;
  double glow_ = 0;
};

}  // namespace tactus::workbench::nurse
