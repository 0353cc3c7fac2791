// A model that is open in the workbench: the contents of its file, and its compiled form.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "app/editing/edit.h"
#include "core/base/error.h"
#include "core/exchange/import/import_model.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "core/procedure/procedure.h"
#include "core/study/record_id.h"

// The author of edits, as the history shows it. The program asks for the name once and keeps it in the settings. It
// never guesses a name.

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

// Names for model files that do not exist yet.

/// `pump.tactus.json` for the stem `pump`; `pump-2.tactus.json` where that exists, and so on.
QString freshModelPath(const QString& stem);

struct OpenModel {
  /// `given` must not be null.
  explicit OpenModel(editing::SharedModel given)
      : shared(std::move(given)), model(shared->model), compiled(shared->compiled) {}

  editing::SharedModel shared;           ///< the one model of history, plots and servo: handed on, never copied
  const fuzzy::ForceModel& model;        ///< of `shared`
  const fuzzy::CompiledModel& compiled;  ///< of `shared`
  QString path;                          ///< of its file, or of the study that keeps it
  bool in_study = false;                 ///< the open study keeps it, version by version
  QStringList warnings;                  ///< of reading the file, one sentence each
  bool simulated = false;                ///< the model says that some of its data are simulated
  /// For a model that a comparison shows instead of the open one: the version that it is or was made from, and the only
  /// expert that counts in it; empty: all count.
  std::optional<study::RecordId> version = std::nullopt;
  std::string only_expert = {};
};

/// Reads and compiles the model file `path`.
base::Result<OpenModel> readOpenModel(const QString& path);

/// The index of the input or of the expert `id` in `model`.
std::optional<std::size_t> inputNamed(const fuzzy::ForceModel& model, const std::string& id);
std::optional<std::size_t> expertNamed(const fuzzy::ForceModel& model, const std::string& id);

/// Whether the provenance, or the label of an expert, says that data are simulated. Signs are the word "simulated" in a
/// text, or a key with that word whose value is not false, 0, null or empty.
bool saysSimulated(const fuzzy::ForceModel& model);

// Models of other fuzzy programs (FLL, FCL, FIS) as open models.

/// Whether `path` has the extension of such a file.
bool isImportPath(const QString& path);

/// Reads the file `path`. Messages name the file without its folder.
base::Result<exchange::ReadFile> readImport(const QString& path);

/// The model of the output `output` (empty: of the only one), with the sentences of the importer as its warnings. Its
/// path is one beside `path` that does not exist yet.
base::Result<OpenModel> importedModel(const exchange::ReadFile& file, const QString& path, const std::string& output);

// A new model to fill with rules.

/// Inputs, output and default terms of `procedure`, one expert without rules. Its path is one in `folder` that does not
/// exist yet. `name` is the model's.
base::Result<OpenModel> templateModel(const procedure::Procedure& procedure, const QString& name,
                                      const QString& folder);

}  // namespace tactus::workbench
