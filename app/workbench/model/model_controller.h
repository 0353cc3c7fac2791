// The open model: opened from a file, edited, saved. It stays until another one was read without an error, and an edit
// that makes no sense leaves it as it was.
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "app/workbench/model/open_model.h"

namespace tactus::workbench {

class ModelController : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// The open model, or null before the first one. What it points to never changes; an edit makes a new one.
  std::shared_ptr<const OpenModel> current() const { return current_; }

  /// What is looked at and felt: the open model, or another one in its place while versions are compared.
  std::shared_ptr<const OpenModel> shown() const { return instead_ ? instead_ : current_; }
  /// Shows and lets feel `model` in the place of the open one, or with null the open one again. The open model stays as
  /// it is: edits, saving and the history are always its own. The next edit ends it.
  void showInstead(std::shared_ptr<const OpenModel> model);

  /// Whether the open model differs from its file, as it was read or saved last. Undoing every edit clears it. False
  /// for a model that a study keeps: the study stores every edit.
  bool isModified() const { return modified_; }

  /// Puts `model` in the place of the open one, which keeps its path, and emits `edited`. A model that does not make
  /// sense is refused with the error of `fuzzy::validate`. A model must be open.
  base::Result<void> edit(fuzzy::ForceModel model);
  /// The same for a model that is compiled already.
  void edit(editing::SharedModel model);
  /// Opens a model that was read already, from a study for example; its path is where `save` writes it. Ends with
  /// `opened`.
  void openRead(OpenModel model);
  /// Opens a model that is in no file any more: it counts as modified until it is saved.
  void openUnsaved(OpenModel model);
  /// From now on the study `path` keeps the open model.
  void moveIntoStudy(const QString& path);
  /// The study does not keep it any more: its file would be `path`, where nothing is yet.
  void moveOutOfStudy(const QString& path);

 public slots:
  /// Reads the model file `path`; ends with `opened` or `openFailed`.
  void open(const QString& path);
  /// Reads the file of the open model again. Of one that a study keeps, asks for `reopenFromStudy`.
  void reopen();
  /// Writes the open model to its file, whole or not at all; ends with `saved` or `saveFailed`. Of one that a study
  /// keeps, asks for `storeNow`.
  void save();
  /// Writes the open model to `path`, which is its file from then on; a study goes on keeping its model, and the file
  /// is a copy.
  void saveAs(const QString& path);

 signals:
  void opened();
  /// One sentence for the person: what, where, found, wanted.
  void openFailed(const QString& path, const QString& sentence);
  void edited();
  /// `shown()` is another model than before, without an edit.
  void shownChanged();
  void modifiedChanged(bool modified);
  void saved(const QString& path);
  /// The model of a study was written to a file of its own.
  void copied(const QString& path);
  void storeNow();
  void reopenFromStudy();
  void saveFailed(const QString& path, const QString& sentence);

 private:
  void setModified(bool modified);
  void moveTo(const QString& path, bool in_study);

  std::shared_ptr<const OpenModel> current_;
  std::shared_ptr<const OpenModel> instead_;
  std::shared_ptr<const OpenModel> on_disk_;  ///< as the file has it; null where there is no file
  bool modified_ = false;
};

}  // namespace tactus::workbench
