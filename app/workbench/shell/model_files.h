// Model files in the window: the menu File, dropped and recent files, the title, and the question
// about unsaved changes. Models of other programs are opened as models without a file. Studies are files too; opening
// them is another's work.
#pragma once

#include <QObject>
#include <QString>

class QAction;
class QDropEvent;
class QMenu;

namespace tactus::workbench {

// Accepts a model file, a study file or a model of another program dropped anywhere on the window.

/// Accepts one file at a time, by its extension. Text fields do not get the file as text.
class FileDrop : public QObject {
  Q_OBJECT

 public:
  /// `window` owns this.
  explicit FileDrop(QWidget& window);

 signals:
  /// Emitted after the drop has been answered, so that the source program does not wait for the receiver.
  void dropped(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool takes(QDropEvent& event);

  QWidget& window_;
};

class MainWindow;
class ModelController;
class RecentFiles;

class ModelFiles : public QObject {
  Q_OBJECT

 public:
  ModelFiles(MainWindow& window, ModelController& models, RecentFiles& recent);

  /// Asks the user about unsaved changes, if there are any. Returns whether another model may be opened.
  bool mayLoseChanges();
  /// The study that is open, by its file's name, in the title and beside the heading; empty: none. `read_only`: why it
  /// is open for reading alone; empty: it is not.
  void showStudy(const QString& name, const QString& read_only);

 public slots:
  /// Opens a model file or a model of another program, or emits `studyChosen` for a study file. Asks about unsaved
  /// changes first. Where a file has several outputs, it asks for one of them.
  void open(const QString& path);
  /// Asks for a model or a study and opens it.
  void choose();
  /// Asks for a model of another program and opens it.
  void chooseImport();
  /// Opens a model without rules of the default procedure. Returns whether it is open.
  bool makeFromTemplate();
  /// Saves the open model; asks for a place where it has no file.
  void save();

 signals:
  /// The user chose a study file to open.
  void studyChosen(const QString& path);

 private:
  void buildMenu();
  void connectAll();
  /// In which files are looked for first.
  QString folder() const;
  void import(const QString& path);
  /// Whether the open model was made from a file of another program and has not been saved.
  bool isUnnamed() const;
  void chooseCopy();
  void showNotes();
  void reopen();
  void showModel();
  void showTitle();
  void showFailure(const QString& path, const QString& sentence);
  void listRecent();

  MainWindow& window_;
  ModelController& models_;
  RecentFiles& recent_;
  QString study_;  ///< file name of the open study
  bool study_read_only_ = false;
  QString unnamed_;  ///< path of an imported model, which does not exist yet; empty: none
  QMenu* recent_menu_ = nullptr;
  QAction* open_ = nullptr;
  QAction* reopen_ = nullptr;
  QAction* save_ = nullptr;
  QAction* save_as_ = nullptr;
  QAction* notes_ = nullptr;
};

}  // namespace tactus::workbench
