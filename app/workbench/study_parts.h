// Adds the study to the window: the menu Study, the state of storing, messages, and recordings in the feel panel.
// Closing the window waits until everything is written.
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace tactus::workbench {

class FeelController;
class FeelStore;
class MainWindow;
class ModelController;
class RecentFiles;
class StudyConnection;
class StudyModels;

class StudyParts : public QObject {
  Q_OBJECT

 public:
  StudyParts(MainWindow& window, StudyConnection& study, StudyModels& study_models, FeelController& feel,
             FeelStore& store, const ModelController& models, RecentFiles& recent);

  /// For what else concerns the study.
  QMenu& menu() { return *menu_; }

 protected:
  /// Keeps the window open until everything is written, or until the user gives it up.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildMenu();
  void connectAll();
  void chooseNew();
  void showState();
  void onOpened();
  void onFailed(const QString& path, const QString& sentence);
  bool mayEnd();

  MainWindow& window_;
  StudyConnection& study_;
  StudyModels& study_models_;
  FeelController& feel_;
  FeelStore& store_;
  const ModelController& models_;
  RecentFiles& recent_;
  QMenu* menu_ = nullptr;
  QAction* make_ = nullptr;
  QAction* show_ = nullptr;
  QAction* put_ = nullptr;
  QAction* build_ = nullptr;
  QAction* close_ = nullptr;
  bool ending_ = false;  ///< the window closes as soon as everything is written
};

}  // namespace tactus::workbench
