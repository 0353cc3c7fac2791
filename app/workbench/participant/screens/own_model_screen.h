// Feel your own model, region by region: lighter, about the same, heavier than in practice, and "mark this moment". The
// researcher sees the marks; they change nothing by themselves.
#pragma once

#include <optional>

#include "app/workbench/anatomy/anatomy_view.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

struct OwnModelState {
  QString region;            ///< `nasal_cavity` … `esophagus`
  bool ready = true;         ///< the force is in the device
  bool unavailable = false;  ///< no model follows from her answers
  QString chosen;            ///< lighter, right, heavier; empty: none
  bool left_handed = false;
  bool simulated = false;
};

class OwnModelScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit OwnModelScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const OwnModelState& state);
  void setDepth(std::optional<double> depth_mm);

 signals:
  void picked(const QString& comparison);
  void marked();
  void confirmed(const QString& region);

 protected:
  /// 1 to 3: lighter, about the same, heavier.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void show();

  OwnModelState state_;
  TextBlock* texts_;
  Label* region_;
  Label* do_;
  Label* line_;
  Button* mark_;
  Choices* choices_;
  anatomy::AnatomyView* picture_;
};

}  // namespace tactus::workbench::nurse
