// A study as a data set for publication, in the layout of a standard (docs/study-export.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/shareable.h"
#include "app/session/trials.h"
#include "core/base/error.h"
#include "core/study/records.h"

namespace tactus::dataset {

/// What the writers of both layouts share: the study without identifying details, its words, and a folder for files.
struct PublishedStudy {
  session::ShareableStudy shared;
  std::vector<std::string> inputs;          ///< of the rules
  std::string simulated;                    ///< a sentence; empty without simulated participants
  std::string without_force;                ///< the note on devices that give no force, or nothing
  std::string version;                      ///< of this program
  std::vector<session::Trial> trials = {};  ///< as they are shared; none for a study of tables

  const study::Study& study() const { return shared.study; }
  /// The name of the data set: no study's own name, which may tell the place.
  std::string name() const;
  /// One paragraph: what was measured, and what of it is simulated.
  std::string description() const;
  /// The text of README: `description`, what is left out, what is still to be entered, and `layout`, a paragraph about
  /// the folder.
  std::string readme(std::string_view layout) const;
};

/// `trials`: those of the study as it is (session::trials).
PublishedStudy publishedStudy(const study::Study& study, std::uint64_t seed, std::string_view version,
                              std::vector<session::Trial> trials = {});

/// Files below one folder, with their number. After an error the later files are not written. They are on the disk when
/// `finish` returns: all at once, because a study has thousands of them.
class FileSet {
 public:
  explicit FileSet(std::string folder) : folder_(std::move(folder)) {}

  /// Writes `text` to `below`, a path like `sub-P1/beh/table.tsv`, and makes the folders on the way.
  void add(std::string_view below, std::string_view text);

  /// Waits until the files are on the disk. Returns their number, or the first error.
  base::Result<std::size_t> finish() const;

 private:
  std::string folder_;
  base::Result<void> state_;
  std::size_t files_ = 0;
};

enum class Layout {
  kPsychDs,  ///< Psych-DS: the study's tables, described in one JSON-LD file
  kBids,     ///< BIDS 1.10: Motion-BIDS for strokes, `beh` for judgements and rules, `phenotype` for answers
};

struct DataSet {
  std::size_t participants = 0;
  std::size_t files = 0;
  std::vector<std::string> notes;  ///< one sentence each: what is left out
};

/// Writes `study` into `folder` as session::shareable leaves it: without codes, exact years, dates, places and notes.
/// `trials`: those of the study file (session::trials); none for a study of tables. `seed` draws the order of the
/// participants; the receivers must not know it. `version` is that of this program. The folder appears completely or
/// not at all. It must be new, empty, or an earlier data set of the same layout, which is replaced. Refused too: a
/// study without participants.
base::Result<DataSet> writeDataSet(const study::Study& study, Layout layout, const std::string& folder,
                                   std::uint64_t seed, std::string_view version,
                                   std::vector<session::Trial> trials = {});

}  // namespace tactus::dataset
