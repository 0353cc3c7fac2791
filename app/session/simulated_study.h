// The paper's study. Data that the paper does not print are simulated.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session.h"
#include "app/session/simulated_nurse.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/records.h"
#include "questionnaires/published_rules.h"

namespace tactus::session {

// The traits of the paper's four nurses, S1 to S4, as simulated persons.

// Simulated answers to the force questionnaire, made to follow the paper's text about its nurses. They are not real.

/// The answers of S1, S2 and S3 to all items of `form` (`ngt-force-v1`: each item asks about one condition in one
/// region). The paper does not print their answers. The model: a level is the sum of
///   the region's level + the condition's effect × the nurse's sensitivity + the nurse's own extra in the oropharynx
/// plus a seeded deviation of each nurse for each region and each condition, rounded to one of the form's terms. For
/// every seed, by construction (paper, Section 3.4 and Fig. 11): more lubrication never increases the force; more neck
/// flexion never increases it; more speed never decreases it; the nasal cavity is never below the nasopharynx; no
/// region is above the oropharynx; no nurse is above S2 there; in the esophagus the three differ by at most one term.
std::vector<study::Answer> simulatedAnswers(const study::Form& form, std::uint64_t seed);

/// The nurses in the order of their codes. They hear and feel without noise: their strokes have the means and
/// deviations of Table 1, and their votes are those of Table 2. S1 to S3 have answers to the form `ngt-force-v1`
/// (simulated_study.h); S4 has none. The same `seed` gives the same traits. Takes a second or more.
std::vector<NurseTraits> simulatedNurses(std::uint64_t seed);

/// One of them; `code` is `S1` to `S4`, anything else is our own bug.
NurseTraits simulatedNurseCalled(std::string_view code, std::uint64_t seed);

/// An expert in any procedure, invented from its pack: thresholds at the boundaries of its force words, strokes in the
/// middle of the words of its rate, and answers to `form` that follow the declared directions, with a force for each
/// region that is drawn once for the procedure. `spread`: the standard deviation of what differs between experts, as a
/// share. Nothing of it is measured, and nothing of it is known of real experts. The same `seed` gives the same expert.
NurseTraits simulatedExpert(const procedure::Procedure& procedure, const study::Form& form, std::uint64_t seed,
                            double spread);

/// The mean speed of such an expert at each word of the rate, mm/s; empty without a rate.
std::vector<double> typicalSpeeds(const procedure::Procedure& procedure);

// A clock under the control of a simulation, so that the same seed gives the same study file.

/// Time advances on request, and by one millisecond with each reading. Copies share the same time.
class SimulatedClock {
 public:
  explicit SimulatedClock(std::int64_t utc_ms) : now_(std::make_shared<study::Moment>(study::Moment{utc_ms, 0})) {}

  void pass(double seconds) const { passMs(std::llround(seconds * 1000)); }
  study::Moment look() const {
    passMs(1);
    return *now_;
  }
  /// Tools for a session, with ids derived from `seed`. Two sessions of one file need different seeds.
  SessionTools tools(std::uint64_t seed) const {
    return {[clock = *this] { return clock.look(); }, study::RecordIds(seed)};
  }

 private:
  void passMs(std::int64_t ms) const {
    now_->utc_ms += ms;
    now_->monotonic_ns += ms * 1'000'000;
  }

  std::shared_ptr<study::Moment> now_;
};

/// The default seed. The value is arbitrary.
inline constexpr std::uint64_t kDefaultSeed = 2;
/// A larger seed would repeat a smaller one: each seed uses a thousand numbers of 64 bits.
inline constexpr std::uint64_t kLargestSeed = 10'000'000'000'000'000;

/// Creates the study file `path`, which must not exist yet. Four simulated nurses S1 to S4 do their sessions
/// (simulated_nurse.h):
///   simulated: strokes with the means and deviations of Table 1, judgements with the votes of Table 2, and the answers
///   of S1, S2 and S3 to the form `ngt-force-v1`, which follow the paper's text; published: S4's 45 rules (Table A2, in
///   the reading `reading`, see s4Readings), stored in S4's session.
/// All four are marked as simulated, also S4: S4's rules are real, but S4's strokes and judgements are not. Times are
/// simulated, too. The same arguments give the same records, including ids and times. Years of experience are empty:
/// the paper says "more than 10" of all four. Refused: an unknown reading, and whatever StudyFile::create refuses.
/// After a failure the file may exist with fewer sessions.
base::Result<store::StudyFile> makeSimulatedNgtStudy(const std::string& path, std::uint64_t seed = kDefaultSeed,
                                                     std::string_view reading = questionnaires::kDefaultReading,
                                                     const std::string& program = {});

/// Simulated nurses for a rehearsal of a study: not the paper's four, but others like them; of another procedure
/// experts invented from its pack (simulatedExpert).
struct SimulatedGroup {
  static constexpr int kMost = 50;

  int count = 4;           ///< 1 to kMost
  double alike = 0.5;      ///< 0 to 1; 1: they differ as S1, S2 and S3 of the demo study do, and no more
  std::uint64_t seed = 1;  ///< 1 to kLargestSeed; another one gives other nurses
};

/// Adds them to the study, each under a code of two words with a whole session under the study's protocol, or the
/// defaults without one. All are marked as simulated. The last session begins 45 minutes before
/// `now_utc_ms`, and each of the others as long before the next. `goes_on` is asked before
/// each: false stops with those that are there. Returns the codes. Takes a second or more for each. Refused: numbers
/// out of their range, and a protocol that a simulated nurse cannot do (more than four strokes of a speed, another
/// speed than the words of the procedure).
base::Result<std::vector<std::string>> addSimulatedNurses(store::StudyFile& file, const SimulatedGroup& group,
                                                          std::int64_t now_utc_ms, const std::string& program,
                                                          const std::function<bool()>& goes_on = {});

}  // namespace tactus::session
