// A rest: the force is off, there is no countdown, she continues whenever she likes.
#pragma once

#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

class RestScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit RestScreen(const Look& look, QWidget* parent = nullptr);

 private:
  TextBlock* texts_;
};

}  // namespace tactus::workbench::nurse
