// The study sessions in which a person feels a model: one for each person and each run. A session is created with its
// first record. Used only by the thread of the study file.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/store/study_file.h"
#include "core/study/session_records.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

class FeelSessions {
 public:
  /// A person and the device.
  struct Visit {
    std::uint64_t run = 0;               ///< number of the run
    std::optional<study::RecordId> who;  ///< nothing: the researcher
    study::Moment started;
    std::string device;
    std::string device_id;
    bool simulated = false;
    std::optional<double> device_friction_n;
  };

  /// The session of `visit` in `file`; creates it if there is none. At the first session of the researcher it adds a
  /// person with a code and a profile that says so.
  base::Result<study::RecordId> sessionOf(const Visit& visit, store::StudyFile& file, study::RecordIds& ids);

  /// The number of the recording `serial` within `session`, counted from 1 in the order of their beginning.
  int numberOf(std::uint64_t serial, const study::RecordId& session);

 private:
  base::Result<study::RecordId> researcher(store::StudyFile& file, study::RecordIds& ids);

  using Key = std::pair<std::uint64_t, std::optional<study::RecordId>>;
  std::map<Key, study::RecordId> sessions_;
  std::map<std::uint64_t, int> numbers_;
  std::map<study::RecordId, int> counts_;
};

/// The current time of both clocks.
study::Moment momentNow();

}  // namespace tactus::workbench
