// A sentence with seven points between two ends: the effort and comfort of a part, and what clinical teachers say of
// the simulator.
#pragma once

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

struct ScaleState {
  Phrase title;
  Phrase sentence;
  Phrase instructions;  ///< above the sentence; may be empty
  Phrase low;           ///< what 1 means
  Phrase high;          ///< what 7 means
  QString chosen;       ///< `1` to `7`, `not_say`; empty: none
  bool may_not_say = false;
  bool is_last = false;  ///< the primary button locks the answers
  bool simulated = false;
};

class ScaleScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ScaleScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ScaleState& state);

 signals:
  void picked(const QString& points);
  void confirmed();

 protected:
  /// 1 to 7; 0: she would rather not say.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  TextBlock* texts_;
  Label* instructions_;
  Label* lead_;
  Label* low_;
  Label* high_;
  Choices* choices_;
};

}  // namespace tactus::workbench::nurse
