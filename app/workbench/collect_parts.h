// Adds stage Collect to the window: the study's home, its protocol, sessions on the participant's screens, and the ways
// to it from the start screen.
#pragma once

#include <QObject>

#include "app/workbench/collect/collect_controller.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/session_run.h"

namespace tactus::workbench {

class AuthorName;
class CollectView;
class DeviceSession;
class MainWindow;
class StudyModels;
class StudyParts;

class CollectParts : public QObject {
  Q_OBJECT

 public:
  CollectParts(MainWindow& window, StudyParts& study_parts, StudyConnection& study, StudyModels& study_models,
               DeviceSession& device, const AuthorName& author);

  CollectController& collect() { return collect_; }
  ProtocolController& protocol() { return protocol_; }
  CollectView& view() { return *view_; }
  SessionRun& run() { return run_; }
  /// Asks for the place of a new study and makes it. A study without a model enters this stage.
  void makeStudy();
  /// The study is read.
  bool isReady() const { return protocol_.isReady(); }

 private:
  void connectAll();
  void connectErrors();
  void showProtocol();
  void onOpened();

  MainWindow& window_;
  StudyParts& study_parts_;
  StudyConnection& study_;
  StudyModels& study_models_;
  CollectController collect_;
  ProtocolController protocol_;
  CollectView* view_;
  SessionRun run_;
};

}  // namespace tactus::workbench
