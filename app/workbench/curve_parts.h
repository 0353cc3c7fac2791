// Adds the comparisons of the curves to the window: the ghost (the model before an edit) and reference curves from
// files. The settings keep the user's choices for the next start.
#pragma once

#include <QObject>

class QAction;
class QSettings;

namespace tactus::workbench {

class CurvesPanel;
class EditController;
class GhostController;
class MainWindow;
class ModelController;
class ReferenceController;

class CurveParts : public QObject {
  Q_OBJECT

 public:
  /// Create after EditParts: its membership function editor shows the shapes before an edit.
  CurveParts(MainWindow& window, const ModelController& models, EditController& edits, GhostController& ghost,
             ReferenceController& references, QSettings& settings);

 private:
  void chooseReference();
  void keepChoices(GhostController& ghost);
  void openReferences();
  void storeReferences();

  MainWindow& window_;
  const ModelController& models_;
  ReferenceController& references_;
  QSettings& settings_;
  CurvesPanel& curves_;
  QAction* open_reference_ = nullptr;
};

}  // namespace tactus::workbench
