// Adds the stage Deliver to the window: its two panels, the way from each line of the readiness to the place or the
// act, and the choice of the folder.
#pragma once

#include <QObject>

#include "app/workbench/deliver/readiness.h"

class QSettings;

namespace tactus::workbench {

class BundleMaker;
class FindingsController;
class HistoryParts;
class LinkController;
class LinkParts;
class MainWindow;
class ModelController;
class Panel;
class ReadinessController;
class StudyModels;
struct NoteGroup;

class DeliverParts : public QObject {
  Q_OBJECT

 public:
  /// `findings_panel` shows the findings, `link_parts` the panel of `link`.
  DeliverParts(MainWindow& window, const ModelController& models, FindingsController& findings, Panel& findings_panel,
               HistoryParts& history, BundleMaker& maker, ReadinessController& readiness, StudyModels& study_models,
               const LinkController& link, LinkParts& link_parts, QSettings& settings);

  Panel& readinessPanel() { return *readiness_panel_; }
  Panel& bundlePanel() { return *bundle_panel_; }

 private:
  void lead(ReadinessTopic topic);
  void showFindings(ReadinessTopic topic);
  void showOrigin();
  void showNotes();
  void popUp(const QVector<NoteGroup>& groups);
  void make();
  void readBack();
  /// Empty if the user chose none.
  QString askFolder(const QString& title);

  MainWindow& window_;
  const ModelController& models_;
  FindingsController& findings_;
  Panel& findings_panel_;
  HistoryParts& history_;
  BundleMaker& maker_;
  ReadinessController& readiness_;
  QSettings& settings_;
  Panel* readiness_panel_;
  Panel* bundle_panel_;
};

}  // namespace tactus::workbench
