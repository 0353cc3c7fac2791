// The check of the set-up before a session: what was looked at, what was found, and for how long it holds.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session_notes.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

/// What a session needs of its place, in the order in which it is checked.
enum class SetupItem {
  kDevice,    ///< it is there, and it sends fresh positions
  kForce,     ///< the guided self-test of the device passed, or a scale showed the force that was asked for
  kLatency,   ///< the servo is punctual
  kScreens,   ///< the participant's screen is large enough, and another one is the researcher's
  kSound,     ///< the tone of a call was heard
  kLanguage,  ///< each language of the protocol has its screens and its consent text
  kConsent,   ///< the consent text has a version, and says whom to ask
  kDisk,      ///< there is room, and the disk stores at once
};
inline constexpr std::array kSetupItems = {SetupItem::kDevice,  SetupItem::kForce, SetupItem::kLatency,
                                           SetupItem::kScreens, SetupItem::kSound, SetupItem::kLanguage,
                                           SetupItem::kConsent, SetupItem::kDisk};

/// `device`, `force`, `latency`, `screens`, `sound`, `language`, `consent`, `disk`.
std::string_view name(SetupItem item) noexcept;

struct SetupFinding {
  SetupItem item = SetupItem::kDevice;
  bool good = false;
  std::string found;  ///< one line, with numbers

  bool operator==(const SetupFinding&) const = default;
};

struct SetupCertificate {
  std::int64_t utc_ms = 0;  ///< when it was completed
  std::string device;       ///< id of the device that was checked
  std::string program;
  std::vector<SetupFinding> findings;  ///< one for each item that was checked

  /// Each item was checked and is good.
  bool isGood() const;
  bool operator==(const SetupCertificate&) const = default;
};

/// A certificate holds for sessions that begin or are resumed within this time, on the same device.
inline constexpr std::int64_t kSetupHoldsMs = std::int64_t{12} * 3600 * 1000;
bool holds(const SetupCertificate& certificate, const std::string& device, std::int64_t utc_ms);

/// A line of a session's log: the certificate under which it began or was resumed.
Note setupChecked(const SetupCertificate& certificate);
/// Back from the log. Nothing for a line of another kind; an error for a detail that does not fit.
base::Result<std::optional<SetupCertificate>> setupIn(const study::EventRecord& event);

/// Whether `session` of a real person has strokes or judgements on a device with force, but none of its beginnings has
/// a good certificate.
base::Result<bool> isWithoutSetup(const store::StudyFile& file, const study::SessionRecord& session);

/// The latest certificate in the log of any session; nothing: there is none.
base::Result<std::optional<SetupCertificate>> latestSetup(const store::StudyFile& file);

}  // namespace tactus::session
