// The sessions of a study in which somebody feels a model: one for each person and each start of a device, made when
// the first record of it comes. Belongs to the thread of the study file.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/store/study_file.h"
#include "core/study/feel_records.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

class FeelSessions {
 public:
  /// Who feels on what.
  struct Visit {
    std::uint64_t run = 0;               ///< number of the start of the device
    std::optional<study::RecordId> who;  ///< nothing: the researcher
    study::Moment started;
    std::string device;
    std::string device_id;
    bool simulated = false;
    std::optional<double> device_friction_n;
  };

  /// The session of `visit` in `file`, made where there is none yet. The researcher becomes a person of the study, with
  /// a code and a profile that says so, the first time that they feel something.
  base::Result<study::RecordId> sessionOf(const Visit& visit, store::StudyFile& file, study::RecordIds& ids);

  /// Number of the recording `serial` within `session`, counted from 1 as they begin.
  int numberOf(std::uint64_t serial, const study::RecordId& session);

 private:
  base::Result<study::RecordId> researcher(store::StudyFile& file, study::RecordIds& ids);

  using Key = std::pair<std::uint64_t, std::optional<study::RecordId>>;
  std::map<Key, study::RecordId> sessions_;
  std::map<std::uint64_t, int> numbers_;
  std::map<study::RecordId, int> counts_;
};

/// Now, by both clocks.
study::Moment momentNow();

}  // namespace tactus::workbench
