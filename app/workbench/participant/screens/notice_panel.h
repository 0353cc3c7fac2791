// One sentence over a screen that waits for the researcher or the disk.
#pragma once

#include "app/workbench/participant/screens/panel_card.h"

namespace tactus::workbench::nurse {

class NoticePanel : public PanelCard {
  Q_OBJECT

 public:
  NoticePanel(const Look& look, const Phrase& sentence, QWidget* parent = nullptr);
};

}  // namespace tactus::workbench::nurse
