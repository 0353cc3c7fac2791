// The author of edits, as the history shows it. The program asks for the name once and keeps it in the settings. It
// never guesses a name.
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

  /// Empty until the user gives a name; edits are then marked `unnamed`.
  QString name() const;
  /// Sets the author of all later edits. Earlier edits keep their author.
  void setName(const QString& name);

 private:
  QSettings& settings_;
  EditController& edits_;
};

}  // namespace tactus::workbench
