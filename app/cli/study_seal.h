// The commands that put a reference curve under seal in a study, and open it (docs/evidence.md).
#pragma once

#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "core/base/error.h"

namespace tactus::cli {

struct StudySealOptions {
  std::string file;
  std::string reference;        ///< CSV file with the curve
  std::string note;             ///< stored beside the seal; may be empty
  std::string passphrase_file;  ///< its first line; empty: the terminal, or the first line of the standard input
  std::vector<std::string> at;  ///< `INPUT=VALUE`, the conditions of the curve other than those of Fig. 11
  bool late = false;
  bool json = false;
};
/// Encrypts a reference curve into the study, before its elicitation.
base::Result<Output> studySeal(const StudySealOptions& options);

struct StudyOpenOptions {
  std::string file;
  std::string passphrase_file;
  std::string out;  ///< the reference as it was; empty: not written
  bool early = false;
  bool json = false;
};
/// Opens the sealed reference of the study, after a sign-off. Each call leaves its record.
base::Result<Output> studyOpen(const StudyOpenOptions& options);

}  // namespace tactus::cli
