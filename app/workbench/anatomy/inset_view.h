// Small drawings beside the picture from the side, for what a side view cannot show: chest and stomach from the front
// (the stomach lies on the left), and the pharynx from behind (its recesses lie beside the larynx). They are never
// mirrored, because left and right would be exchanged.
#pragma once

#include <QPixmap>
#include <QWidget>

namespace tactus::workbench::anatomy {

enum class Inset { kFront, kBehind };

class InsetView : public QWidget {
  Q_OBJECT

 public:
  explicit InsetView(Inset inset, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {160, 240}; }
  QSize minimumSizeHint() const override { return {64, 96}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Inset inset_;
  QPixmap drawing_;  ///< at the current size
};

}  // namespace tactus::workbench::anatomy
