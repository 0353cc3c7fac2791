// A model that is open in the workbench: the contents of its file, and its compiled form.
#pragma once

#include <QString>
#include <QStringList>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "app/editing/edit.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

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

}  // namespace tactus::workbench
