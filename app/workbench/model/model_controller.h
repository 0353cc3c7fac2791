// The open model: opened from a file, edited, saved. It stays open until another model was read without an error. An
// invalid edit leaves it unchanged.
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

  /// The open model; null before the first one. The object never changes; an edit makes a new one.
  std::shared_ptr<const OpenModel> current() const { return current_; }

  /// The model on the screen and on the device: the open model, or another one while versions are compared.
  std::shared_ptr<const OpenModel> shown() const { return instead_ ? instead_ : current_; }
  /// Shows and renders `model` in place of the open one; null: the open one again. The open model stays unchanged:
  /// edits, saving and the history always refer to it. The next edit ends this state.
  void showInstead(std::shared_ptr<const OpenModel> model);

  /// Whether the open model differs from its file as last read or saved. Undoing every edit clears it. Always false for
  /// a model in a study, because the study stores every edit.
  bool isModified() const { return modified_; }

  /// Replaces the open model by `model`, keeps the path, and emits `edited`. An invalid model is refused with the error
  /// of `fuzzy::validate`. A model must be open.
  base::Result<void> edit(fuzzy::ForceModel model);
  /// The same for a model that is compiled already.
  void edit(editing::SharedModel model);
  /// Opens a model that was read already, from a study for example; its path is where `save` writes it. Ends with
  /// `opened`.
  void openRead(OpenModel model);
  /// Opens a model that has no file any more. It counts as modified until it is saved.
  void openUnsaved(OpenModel model);
  /// From now on the study at `path` keeps the open model.
  void moveIntoStudy(const QString& path);
  /// The study does not keep the open model any more. The model's file is now `path`, which does not exist yet.
  void moveOutOfStudy(const QString& path);

 public slots:
  /// Reads the model file `path`. Ends with `opened` or `openFailed`.
  void open(const QString& path);
  /// Reads the file of the open model again. For a model in a study it asks for `reopenFromStudy`.
  void reopen();
  /// Writes the open model to its file, completely or not at all. Ends with `saved` or `saveFailed`. For a model in a
  /// study it asks for `storeNow`.
  void save();
  /// Writes the open model to `path`, which becomes its file. A model in a study stays in the study; the file is then a
  /// copy.
  void saveAs(const QString& path);

 signals:
  void opened();
  /// One sentence for the user: what, where, what was found, what was wanted.
  void openFailed(const QString& path, const QString& sentence);
  void edited();
  /// `shown()` changed without an edit.
  void shownChanged();
  void modifiedChanged(bool modified);
  void saved(const QString& path);
  /// The model of a study was written to a file as a copy.
  void copied(const QString& path);
  void storeNow();
  void reopenFromStudy();
  void saveFailed(const QString& path, const QString& sentence);

 private:
  void setModified(bool modified);
  void moveTo(const QString& path, bool in_study);

  std::shared_ptr<const OpenModel> current_;
  std::shared_ptr<const OpenModel> instead_;
  std::shared_ptr<const OpenModel> on_disk_;  ///< the model as its file has it; null if there is no file
  bool modified_ = false;
};

}  // namespace tactus::workbench
