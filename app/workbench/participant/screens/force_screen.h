// Force perception: feel, then one of five words, then Confirm. Catch trials look the same. Nothing tells a force, a
// step or how many there are.
#pragma once

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

enum class JudgingPhase {
  kPause,  ///< the force is off for a moment
  kFeel,
  kAnswer,
};

struct ForceState {
  bool practice = false;
  int part = 2;  ///< of `parts`
  int parts = 3;
  JudgingPhase step = JudgingPhase::kFeel;
  bool asks = true;    ///< for a word; not in the practice
  bool again = false;  ///< the force was not delivered in full: once more
  bool warm = false;   ///< the pause is long because the device rests
  QString lit;         ///< the word that the device's button would choose
  QString chosen;      ///< very_small … very_large, not_felt, beyond_practice; empty: none
  bool may_feel_again = true;
  bool before = false;  ///< it is about the force before
  bool left_handed = false;
  bool simulated = false;
};

class ForceScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ForceScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ForceState& state);

 signals:
  void picked(const QString& word);
  void confirmed();
  void feelAgain();

 protected:
  /// 1 to 5 the words, 0 not felt, 9 beyond practice, F feel again.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  ForceState state_;
  TextBlock* texts_;
  PictureBox* push_;
  Label* practice_;
  Label* lead_;
  Label* hint_;
  Choices* choices_;
  Button* feel_again_;
};

}  // namespace tactus::workbench::nurse
