// The record of one participant as a table: what was asked, what was said, and what is remarkable about it.
#pragma once

#include <QDialog>

#include "app/workbench/base/columns.h"
#include "app/workbench/collect/participant_record.h"

class QCheckBox;
class QLabel;

namespace tactus::workbench {

class CollectController;

class RecordDialog : public QDialog {
  Q_OBJECT

 public:
  /// `collect` outlives this. Reads the record at once, and again when the study changes.
  RecordDialog(CollectController& collect, const study::RecordId& person, QWidget* parent = nullptr);

  const std::vector<RecordLine>& lines() const { return table_.rows(); }

 private:
  void read();
  void take(std::vector<RecordLine> lines);
  void filter();

  CollectController& collect_;
  const study::RecordId person_;
  std::vector<RecordLine> all_;
  Columns<RecordLine> table_;
  QLabel* summary_;
  QCheckBox* log_;
};

}  // namespace tactus::workbench
