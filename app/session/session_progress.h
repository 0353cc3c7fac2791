// How far a session has come, read from the study file alone: nothing is added to its log.
#pragma once

#include <optional>
#include <set>

#include "app/session/session.h"
#include "app/session/session_settings.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

/// Things done of things planned.
struct Share {
  int done = 0;
  int wanted = 0;

  bool isComplete() const { return done >= wanted; }
  bool operator==(const Share&) const = default;
};

/// A part is nothing where the session has no such block.
struct SessionProgress {
  SessionPart part = SessionPart::kProfile;
  std::optional<Block> block;  ///< in progress or being rated
  bool paused = false;
  bool has_profile = false;
  std::set<Block> skipped;
  Share practice;                ///< insertions and forces before the counted ones
  std::optional<Share> speed;    ///< accepted insertions
  std::optional<Share> force;    ///< forces; `wanted` falls where a series ends early
  std::optional<Share> form;     ///< questions with a reply
  bool sealed = false;           ///< the participant locked the answers to the form, or rated it
  int own_model_verdicts = 0;    ///< regions of the own model that were judged
  std::int64_t last_utc_ms = 0;  ///< time of the last line of the log
};

/// Errors: settings or records that cannot be read. Reads no recordings. Thread: that of `file`.
base::Result<SessionProgress> sessionProgress(const store::StudyFile& file, const study::SessionRecord& session);

}  // namespace tactus::session
