// Adds the stage Deliver to the window: its two panels, the way from each line of the readiness to the place or the
// act, and the choice of the folder.
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <span>

#include "app/link/link_lines.h"
#include "app/workbench/deliver/readiness.h"
#include "core/haptics/servo/sample.h"

class QAction;
class QSettings;

namespace tactus::workbench {

class BundleMaker;
class FeelController;
class FindingsController;
class HistoryParts;
class LinkController;
class LinkDialog;
class MainWindow;
class ModelController;
class Panel;
class ReadinessController;
class SceneController;
class StudyModels;
struct NoteGroup;
struct OpenModel;

// Adds "Serve to a simulator" to the window: the menu entry, its dialog, the sign in the strip, and what the hand feels
// for the simulators.

// What the hand feels, in the words of the live link.

/// Thread: gui. It reads the samples that the servo has left for the screen; the servo knows nothing of it.
class FeltStates {
 public:
  FeltStates(const FeelController& feel, const SceneController& scene) : feel_(feel), scene_(scene) {}

  /// `samples` of the current run as states, in the setting of the scene.
  link::LinkStates of(std::span<const haptics::Sample> samples);
  /// The state after a run: the hand holds nothing and feels no force. No states if there was no run.
  link::LinkStates afterRun();

 private:
  std::shared_ptr<const link::LinkSetting> setting();

  const FeelController& feel_;
  const SceneController& scene_;
  std::uint64_t run_ = 0;
  std::int64_t run_began_ns_ = 0;
  // The setting and what it is of: made anew where one of these differs.
  std::shared_ptr<const OpenModel> model_;
  std::shared_ptr<const link::LinkSetting> setting_;
};

class LinkParts : public QObject {
  Q_OBJECT

 public:
  LinkParts(MainWindow& window, const ModelController& models, const SceneController& scene, FeelController& feel,
            LinkController& link);

  LinkDialog& dialog() { return *dialog_; }
  void showDialog();

 private:
  void showFelt();

  MainWindow& window_;
  FeelController& feel_;
  LinkController& link_;
  FeltStates states_;
  LinkDialog* dialog_;
  QAction* serve_;
  bool felt_ = false;     ///< a run is in progress
  bool serving_ = false;  ///< as last said
};

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
