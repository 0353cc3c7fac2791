// Puts what is compared with the curves into the window: what was before an edit, and reference curves from files.
#pragma once

#include <QObject>

class QAction;

namespace tactus::workbench {

class EditController;
class GhostController;
class MainWindow;
class ModelController;
class ReferenceController;

class CurveParts : public QObject {
  Q_OBJECT

 public:
  /// After EditParts, whose membership function editor gets the shapes before an edit.
  CurveParts(MainWindow& window, const ModelController& models, EditController& edits, GhostController& ghost,
             ReferenceController& references);

 private:
  void chooseReference();

  MainWindow& window_;
  const ModelController& models_;
  ReferenceController& references_;
  QAction* open_reference_ = nullptr;
};

}  // namespace tactus::workbench
