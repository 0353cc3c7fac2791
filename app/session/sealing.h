// A reference curve under seal in a study (docs/evidence.md): locked away before the elicitation, opened after a
// sign-off.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/procedure/procedure.h"
#include "core/store/sealed_references.h"
#include "core/store/study_file.h"
#include "elicitation/model/evidence.h"

namespace tactus::session {

struct SealState {
  std::vector<store::SealedTrial> trials;  ///< with the openings of each; a merge can bring several
  bool began = false;                      ///< the elicitation has begun: a seal would be late
  bool signed_off = false;                 ///< a model is: an opening would not be early
};
base::Result<SealState> sealState(const store::StudyFile& file);

/// The conditions of a curve if none are given: the usual value of each input but the way, by id.
std::map<std::string, double> usualConditions(const procedure::Procedure& about);

struct SealOrder {
  std::string content;  ///< of the CSV file
  std::string name;     ///< of the file, for errors
  std::string note;     ///< stored beside the seal, for everyone; may be empty
  std::map<std::string, double> conditions;
  std::string passphrase;  ///< 8 to 500 bytes
};
struct Sealed {
  store::SealedReference record;
  std::size_t points = 0;
};
/// Encrypts a reference curve into the study; it is marked as late where the elicitation has begun. `program`: that
/// does it. Returns an error for a curve that is none (elicitation::readReferenceCurve), a study with a seal, and those
/// of store::sealContent and store::append.
base::Result<Sealed> seal(store::StudyFile& file, const SealOrder& order, std::string_view program);

struct Unsealed {
  store::SealedReference reference;
  store::SealOpening opening;
  std::vector<elicitation::ReferencePoint> points;
  std::size_t times = 1;          ///< that it was opened, this one included
  std::size_t changes_after = 0;  ///< versions of models that an earlier opening did not find
};
/// Opens the reference that `passphrase` opens; the opening is marked as early where no model is signed off, and stays
/// in the study. Returns an error for a study without a seal, and those of store::openContent.
base::Result<Unsealed> unseal(store::StudyFile& file, const std::string& passphrase, std::string_view program);

}  // namespace tactus::session
