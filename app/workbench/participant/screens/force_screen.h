// Force perception: feel, then one of the words, then Confirm. Catch trials look the same. Nothing tells a force, a
// step or how many there are.
#pragma once

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

class ForceScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ForceScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 signals:
  void feelAgain();

 protected:
  /// From 1 the words, 0 not felt, 9 beyond practice, S would stop.
  QString idOfKey(int key) const override;
  /// F: feel again.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  ForceState state_;
  TextBlock* texts_;
  PictureBox* push_;
  Label* practice_;
  Label* lead_;
  Label* hint_;
  Choices* choices_;
  Button* stop_;  ///< whether she would stop at this force
  Button* feel_again_;
};

}  // namespace tactus::workbench::nurse
