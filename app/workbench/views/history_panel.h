// The undo list: every edit with what it did to the force; a click goes back or forward to it.
#pragma once

#include "app/workbench/views/card.h"

class QListWidget;

namespace tactus::workbench {

class EditController;

class HistoryPanel : public Card {
  Q_OBJECT

 public:
  explicit HistoryPanel(EditController& edits, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void list();

  EditController& edits_;
  QListWidget* entries_;
};

}  // namespace tactus::workbench
