#include "tests/support/table_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/session/simulated_nurse.h"
#include "app/session/study_source.h"
#include "core/base/random.h"

#include "tests/support/default_procedure.h"

namespace tactus::support {
namespace {

using base::Random;

constexpr std::array<const char*, 3> kLevels = {"slow", "medium", "fast"};
constexpr std::array<const char*, 5> kTerms = {"very_small", "small", "medium", "large", "very_large"};
constexpr double kStrokeMm = 60;
constexpr double kRamp = 0.2;  // of the duration

double rounded(double value, double unit) { return std::round(value / unit) * unit; }

/// Speed at `u` of the duration, 1 on the plateau: minimum-jerk ramps.
double profile(double u) {
  const double x = std::clamp(std::min(u, 1 - u) / kRamp, 0.0, 1.0);
  return x * x * x * (10 - 15 * x + 6 * x * x);
}

class Writer {
 public:
  Writer(std::uint64_t seed, const TableStudyTraits& traits) : random_(seed), traits_(traits) {}

  study::Study write() {
    study_.name = "tables";
    for (int i = 1; i <= traits_.nurses; ++i) addNurse("N" + std::to_string(i));
    return std::move(study_);
  }

 private:
  template <class Record>
  static void setLine(std::vector<Record>& records) {
    records.back().line.number = static_cast<std::uint32_t>(records.size() + 1);
  }

  void addNurse(const std::string& code) {
    study::Participant participant;
    participant.code = code;
    participant.years_experience = 5 + random_.below(25);
    participant.category = "expert";
    study_.participants.push_back(participant);
    setLine(study_.participants);
    double plateau_mm_s = random_.uniform(35, 110);
    for (const char* level : kLevels) {
      for (int stroke = 1; stroke <= traits_.strokes; ++stroke) {
        addStroke(code, level, stroke, plateau_mm_s * random_.uniform(0.9, 1.1));
      }
      plateau_mm_s *= random_.uniform(1.35, 2.2);
    }
    addJudgements(code);
    addAnswers(code);
  }

  void addStroke(const std::string& code, const char* level, int number, double plateau_mm_s) {
    const double duration_s = kStrokeMm * random_.uniform(0.9, 1.1) / (plateau_mm_s * (1 - kRamp));
    const int rows = static_cast<int>(duration_s * traits_.rows_per_s) + 1;
    double depth_mm = 0;
    double before_mm_s = 0;
    for (int i = 0; i < rows; ++i) {
      const double time_s = i / traits_.rows_per_s;
      const double speed_mm_s =
          plateau_mm_s * (0.1 + 0.9 * profile(time_s / duration_s) + traits_.noise * random_.normal());
      if (i > 0) depth_mm += 0.5 * (before_mm_s + speed_mm_s) / traits_.rows_per_s;
      before_mm_s = speed_mm_s;
      study_.speeds.push_back(
          {code, level, number, rounded(time_s, 1e-3), rounded(depth_mm, 0.01), rounded(speed_mm_s, 0.1)});
      setLine(study_.speeds);
    }
  }

  void addJudgements(const std::string& code) {
    session::ResponderTraits traits;
    traits.code = code;
    traits.threshold_n = {random_.uniform(0.12, 0.28), random_.uniform(0.3, 0.45), random_.uniform(0.5, 0.65),
                          random_.uniform(0.7, 0.9)};
    traits.beyond_from_n = random_.uniform(1.05, 1.4);
    session::SimulatedResponder responder(traits, {kTerms.begin(), kTerms.end()});
    for (int step = 1; step <= 17; ++step) {
      const double force_n = step / 10.0;
      const auto response = responder.judge(force_n, random_);
      study_.judgements.push_back({code, "ascending", step, force_n, response.kind, response.term});
      setLine(study_.judgements);
      if (response.kind == study::ForceJudgement::Kind::kBeyondPractice) return;
    }
  }

  /// A level for each region and condition, a sensitivity of the nurse, and noise.
  void addAnswers(const std::string& code) {
    const auto forms = session::knownForms(support::defaultProcedure());
    const double bias = random_.uniform(-0.5, 0.5);
    const double sensitivity = random_.uniform(0.6, 1.2);
    for (const auto& item : forms.front().items) {
      double level = 1.8 + bias;
      for (const auto& [input, term] : item.conditions) {
        const bool least = term == "poor" || term == "small" || term == "slow";
        const bool most = term == "well" || term == "large" || term == "fast";
        const double side = most ? 1 : least ? -1 : 0;
        if (input == "depth") level += term == "nasopharynx" || term == "laryngopharynx" ? 0.8 : -0.4;
        if (input == "speed") level += side * sensitivity;
        if (input == "lubrication" || input == "neck_flexion") level -= side * sensitivity;
      }
      level += 0.4 * random_.normal();
      const auto term = static_cast<std::size_t>(std::clamp(std::lround(level), 0L, 4L));
      study_.answers.push_back({code, forms.front().id, item.number, kTerms[term], study::Answer::Status::kAnswered});
      setLine(study_.answers);
    }
  }

  Random random_;
  TableStudyTraits traits_;
  study::Study study_;
};

}  // namespace

study::Study tableStudy(std::uint64_t seed, const TableStudyTraits& traits) { return Writer(seed, traits).write(); }

}  // namespace tactus::support
