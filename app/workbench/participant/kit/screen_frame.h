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

namespace tactus::workbench {

struct ParticipantState;

namespace nurse {

class Choices;

/// The size of the corner at the top right, at all sizes of text and in all languages.
QSize forceOffCorner(const Look& look);
/// Between the window's edges and what stands in it, px.
int frameMargin(const Look& look);

class ScreenFrame : public QWidget {
  Q_OBJECT

 public:
  explicit ScreenFrame(const Look& look, QWidget* parent = nullptr);

  /// Shows the state of the course. Simulated data say so beside the title, and Back is there where it leads to
  /// something.
  virtual void setState(const ParticipantState& state);

 signals:
  void back();     ///< beyond the first page
  void primary();  ///< on the last page
  /// A card, or its key: one of the ids that the state offers.
  void picked(const QString& id);

 protected:
  const Look& look() const { return look_; }
  void setTitle(const Phrase& title);
  /// A line below the title.
  void setHint(const Phrase& hint);
  /// `share` of the width for `side`, which begins below the corner.
  void setMain(QWidget* main, QWidget* side = nullptr, double share = 0.34);
  /// The primary button stands at the hand that does not hold the device.
  void setFreeHandLeft(bool left);
  /// `cards` answer the screen: a click emits `picked`. `around`: what they stand in, if not alone.
  void setAnswers(Choices* cards, QWidget* around = nullptr);
  /// The card that the key `key` (Qt::Key) stands for; empty: none, or keys answer nothing now.
  virtual QString idOfKey(int key) const;
  /// Of a screen with several pages: turns to the next (1) or the previous one (-1). False: there is none.
  virtual bool turnPage(int by);
  /// Back stands on later pages of a screen whatever the course says.
  virtual bool hasPageBefore() const { return false; }
  /// After a turn.
  void showBack();

  Button& primaryButton() { return *primary_; }
  void addExtra(Button* button);

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  /// Enter or Space: the primary button; Backspace: Back; the keys of the cards. A held key repeats nothing.
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void arrange();

  const Look& look_;
  Label* title_;
  Label* hint_;
  Label* simulated_;
  Label* scale_;  ///< where a device gives only a share of the forces
  Button* back_;
  Button* primary_;
  QWidget* main_ = nullptr;
  QWidget* side_ = nullptr;
  QWidget* answers_ = nullptr;
  double share_ = 0;
  std::vector<Button*> extras_;
  bool free_hand_left_ = false;
  bool may_go_back_ = true;
};

}  // namespace nurse
}  // namespace tactus::workbench
