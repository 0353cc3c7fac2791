// A card of a lab: its heading with buttons beside it, and its content below.
#pragma once

#include "app/workbench/kit/cards.h"

class QHBoxLayout;

namespace tactus::workbench {

class LabCard : public Card {
  Q_OBJECT

 public:
  LabCard(const QString& title, QWidget* content, QWidget* parent = nullptr);

  /// Adds `tool` at the right of the heading.
  void addTool(QWidget* tool);

 private:
  QHBoxLayout* head_;
};

}  // namespace tactus::workbench
