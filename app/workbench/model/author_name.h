// Who edits, as it stands in the history: asked for once, kept in the settings. Nobody's name is guessed.
#pragma once

#include <QObject>
#include <QString>

class QSettings;

namespace tactus::workbench {

class EditController;

class AuthorName : public QObject {
  Q_OBJECT

 public:
  AuthorName(QSettings& settings, EditController& edits, QObject* parent = nullptr);

  /// Empty until somebody says it; edits are then marked `unnamed`.
  QString name() const;
  /// For the edits from now on; what was done before keeps its author.
  void setName(const QString& name);

 private:
  QSettings& settings_;
  EditController& edits_;
};

}  // namespace tactus::workbench
