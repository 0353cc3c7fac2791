// The history as a list for the screen. The effect of an edit is computed when its row is visible.
#pragma once

#include <QStringList>
#include <optional>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/base/columns.h"

namespace tactus::workbench {

class EditController;

class HistoryModel : public Columns<editing::HistoryRow> {
  Q_OBJECT

 public:
  enum Role {
    kEffectRole = Qt::UserRole,  ///< QString: `max ΔF 0.032 N (0.4 JND) · 19:20 · M. Ortiz`
    kSnapshotsRole,              ///< QStringList: names
    kSignOffsRole,               ///< QStringList: `S4: feels right`, `S4: approved unfelt`
  };

  /// Empty until `refresh`, and again when another history begins.
  explicit HistoryModel(EditController& edits, QObject* parent = nullptr);

  /// Reads the history again.
  void refresh();
  std::optional<int> currentRow() const;

 private:
  QString labelOf(const editing::HistoryRow& row) const;
  QString detailOf(const editing::HistoryRow& row) const;
  QString tipOf(const editing::HistoryRow& row) const;
  QStringList marksOf(const editing::HistoryRow& row, editing::EventKind kind) const;

  EditController& edits_;
};

}  // namespace tactus::workbench
