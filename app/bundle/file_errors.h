// How far the forces of a bundle's files are from the model's.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "app/bundle/bounded_table.h"
#include "app/bundle/sources.h"
#include "core/exchange/dialect.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/bundle_check.h"

namespace tactus::bundle {

// Runs another program, without a shell, with its input and output in files.

enum class Ran {
  kNotThere,  ///< no such program
  kEnded,     ///< by the limit of time, or by a request to stop
  kFailed,    ///< with another exit status than 0
  kWell,
};

/// Runs the program `words[0]`, found in PATH. It reads the file `in` of `folder` and writes `out` and, for its errors,
/// `err` there.
Ran runProgram(std::vector<std::string> words, const std::string& folder, const std::stop_token& stop = {});

// The work of `tactus verify`: reads a bundle back and compares each of its files with its model.

/// Calls model_io::checkBundle. Then reads the look-up table and compares it with the model, and measures the errors of
/// the files for other programs again. If `generator` (this program and version) wrote the bundle, their texts and the
/// C source must be equal to the ones that this program writes for the model. Texts of another version are compared by
/// their checksums alone. A zip file (zip.h) is unpacked beside the other temporary files first.
base::Result<model_io::BundleCheck> verifyBundle(const std::string& path, std::string_view generator);

/// The error of a program that reads expert `expert` from a file of this dialect: its forces against those of the model
/// at `points`. The promised tolerance is that of the dialect; if the error is larger, a tolerance above the error.
model_io::Promise promiseOf(exchange::Dialect dialect, const fuzzy::CompiledModel& model, std::size_t expert,
                            const std::vector<std::vector<double>>& points);

/// The same for the look-up table and the averaged force. The tolerance is the bound over the whole box.
model_io::Promise promiseOf(const BoundedTable& table, const fuzzy::CompiledModel& model,
                            const std::vector<std::vector<double>>& points);

/// The error of a table that was read, at `points` alone.
model_io::Promise errorOf(const ForceTable& table, const fuzzy::CompiledModel& model,
                          const std::vector<std::vector<double>>& points);

/// A file that holds the exact forces: 1e-12 of the output's range is left for rounding.
model_io::Promise exactPromise(const fuzzy::ForceModel& model);

/// The error of a source that gives forces, at the points of `runs` or in its traces. If it cannot be run here: the
/// bound that the tests of the sources prove, with `measured` false. `at` of a tube: the numbers of trace and step,
/// from 1.
model_io::Promise promiseOf(SourceRuns& runs, const SourceFile& file, const fuzzy::CompiledModel& model);

}  // namespace tactus::bundle
