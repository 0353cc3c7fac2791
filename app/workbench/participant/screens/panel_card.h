// A card in the middle of the dimmed window: what is said over a screen. Inside the window, so that no dialog can stand
// above the button that stops the force.
#pragma once

#include <QVBoxLayout>
#include <QWidget>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/label.h"

namespace tactus::workbench::nurse {

class PanelCard : public QWidget {
  Q_OBJECT

 public:
  explicit PanelCard(const Look& look, QWidget* parent = nullptr);

 protected:
  const Look& look() const { return look_; }
  Label* addText(TextRole role, const Phrase& text);
  Button* addButton(ButtonKind kind, const Phrase& text);
  /// Below what was added before; belongs to the card from now on.
  void addWidget(QWidget* widget);

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void arrange();

  const Look& look_;
  QWidget* card_;
  QVBoxLayout* column_;
};

}  // namespace tactus::workbench::nurse
