// A highlight that fades away: shows where something was pointed at.
#pragma once

#include <QVariantAnimation>

class QWidget;

namespace tactus::workbench {

class Flash : public QObject {
  Q_OBJECT

 public:
  /// Repaints `widget` while the highlight fades. Owned by it.
  explicit Flash(QWidget* widget);

  /// Begins the highlight anew.
  void start();
  /// 1 at the beginning, 0 at the end and afterwards.
  double strength() const { return strength_; }

 private:
  QVariantAnimation fading_;
  double strength_ = 0;
};

}  // namespace tactus::workbench
