#include "app/workbench/participant/screens/notice_panel.h"

namespace tactus::workbench::nurse {

NoticePanel::NoticePanel(const Look& look, const Phrase& sentence, QWidget* parent) : PanelCard(look, parent) {
  addText(TextRole::kLead, sentence);
}

}  // namespace tactus::workbench::nurse
