// The frame of every screen of the nurse: where she is at the top, one thing to do, Back and one primary button at the
// bottom. The corner of "Force off" stays free; that button belongs to the window.
//
//   title                                   [corner]
//   main                                        side
//   answers, over the whole width
//   Back   extra …                           primary
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/label.h"

namespace tactus::workbench::nurse {

/// The size of the corner at the top right, at all sizes of text and in all languages.
QSize forceOffCorner(const Look& look);
/// Between the window's edges and what stands in it, px.
int frameMargin(const Look& look);

class ScreenFrame : public QWidget {
  Q_OBJECT

 public:
  explicit ScreenFrame(const Look& look, QWidget* parent = nullptr);

  /// The data are simulated: SIMULATED stands beside the title.
  void setSimulated(bool simulated);
  /// The primary button stands at the hand that does not hold the device.
  void setFreeHandLeft(bool left);
  /// Back is there, or not. Screens of several pages keep it for their own.
  virtual void setMayGoBack(bool may);

 signals:
  void back();
  void primary();

 protected:
  const Look& look() const { return look_; }
  void setTitle(const Phrase& title);
  /// A line below the title.
  void setHint(const Phrase& hint);
  /// `share` of the width for `side`, which begins below the corner.
  void setMain(QWidget* main, QWidget* side = nullptr, double share = 0.34);
  void setAnswers(QWidget* answers);
  Button& backButton() { return *back_; }
  Button& primaryButton() { return *primary_; }
  void addExtra(Button* button);

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  /// Enter or Space: the primary button; Backspace: Back. A held key repeats nothing.
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void arrange();

  const Look& look_;
  Label* title_;
  Label* hint_;
  Label* simulated_;
  Button* back_;
  Button* primary_;
  QWidget* main_ = nullptr;
  QWidget* side_ = nullptr;
  QWidget* answers_ = nullptr;
  double share_ = 0;
  std::vector<Button*> extras_;
  bool free_hand_left_ = false;
};

}  // namespace tactus::workbench::nurse
