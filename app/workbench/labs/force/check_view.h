// The checks of the judgements, a row for each participant.
#pragma once

#include <QWidget>

#include "app/workbench/labs/force/check_table.h"

namespace tactus::workbench {

class CheckView : public QWidget {
  Q_OBJECT

 public:
  explicit CheckView(QWidget* parent = nullptr);

  void setChecks(std::vector<ParticipantChecks> checks) { table_->setChecks(std::move(checks)); }
  const CheckTable& table() const { return *table_; }

 private:
  CheckTable* table_;
};

}  // namespace tactus::workbench
