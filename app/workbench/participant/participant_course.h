// Decides which of the nurse's screens is shown. The decision follows from the stored records of the session and from
// the screens that she has passed since she sat down.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include "app/workbench/participant/participant_state.h"
#include "app/workbench/study/connection/session_snapshot.h"

namespace tactus::workbench {

/// A rest every so many questions (facts on the screens, part 3).
inline constexpr std::size_t kQuestionsToRest = 15;

/// What she has passed since she sat down. Nothing of it is stored: after a crash she passes it again.
struct CoursePassed {
  bool code = false;            ///< her code is known, and she left its screen
  bool device = false;          ///< the device was checked, and is still running
  bool glossary = false;        ///< the words were explained
  bool own_model = false;       ///< she felt her own model, or there is none
  std::set<std::string> rests;  ///< that she had: `restBefore` of each
  std::size_t blocks = 0;       ///< that were done when she sat down: no rest comes after those
  bool sealing = false;         ///< she locked her answers; the rating of the form is asked
  bool sealed = false;          ///< she saw that they are locked
  bool stopped = false;         ///< she stopped, or withdrew, or did not consent
  std::size_t replies = 0;      ///< to questions since the last rest
};

/// The rest that comes before what `at` asks; empty: none. The same text for the same place.
std::string restBefore(const SessionSnapshot& at, const CoursePassed& passed);

/// A clinical teacher's session with the usability form.
bool isUsability(const SessionSnapshot& at);

/// Whether the screen gives a force, or reads the hand.
bool usesDevice(ParticipantScreen screen);

/// `at`: null before the session has begun.
ParticipantScreen screenOf(const SessionSnapshot* at, const CoursePassed& passed);

}  // namespace tactus::workbench
