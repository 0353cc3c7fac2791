// A screen of text and cards: shows what PageState says.
#pragma once

#include <QWidget>

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

class PageScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit PageScreen(const Look& look, QWidget* parent = nullptr);

  /// Whether there is a picture, cards or a scale stays as in the first state.
  void setState(const ParticipantState& state) override;

 protected:
  /// Of a scale: its points, and 0 for the card apart.
  QString idOfKey(int key) const override;

 private:
  /// Places what `page` has.
  void arrange(const PageState& page);

  bool arranged_ = false;
  bool has_scale_ = false;
  TextBlock* texts_;
  PictureBox* picture_;
  Label* instructions_;
  Label* sentence_;
  Label* remark_;
  Label* low_;
  Label* high_;
  Choices* choices_;
};

}  // namespace tactus::workbench::nurse
