#include "app/session/shareable.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "questionnaires/questionnaire.h"

namespace tactus::session {
namespace {

/// Any other text may say more than it should.
constexpr std::array<std::string_view, 3> kCategories = {"beginner", "intermediate", "expert"};
constexpr std::array<std::string_view, 3> kHands = {"left", "right", "both"};

template <class Words>
std::string oneOf(const Words& words, const std::string& text) {
  return std::find(words.begin(), words.end(), text) == words.end() ? std::string() : text;
}

/// The place of each old participant among the new ones.
std::vector<std::size_t> shuffledPlaces(std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), 0);
  base::Random random(seed);
  for (std::size_t i = count; i > 1; --i) {
    std::swap(places[i - 1], places[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
  return places;
}

class Renamer {
 public:
  Renamer(const std::vector<study::Participant>& participants, const std::vector<std::size_t>& places) {
    for (std::size_t i = 0; i < participants.size(); ++i) place_of_[participants[i].code] = places[i];
  }

  static std::string code(std::size_t place) { return "P" + std::to_string(place + 1); }

  /// The records under their new codes, participant after participant.
  template <class Record>
  std::vector<Record> renamed(std::vector<Record> records) const {
    std::erase_if(records, [&](const Record& record) { return !place_of_.contains(record.participant); });
    std::stable_sort(records.begin(), records.end(), [&](const Record& a, const Record& b) {
      return place_of_.at(a.participant) < place_of_.at(b.participant);
    });
    for (auto& record : records) {
      record.participant = code(place_of_.at(record.participant));
      record.line = {};
    }
    return records;
  }

 private:
  std::map<std::string, std::size_t> place_of_;
};

/// Each stroke begins at 0 s.
void startAtZero(std::vector<study::SpeedSample>& speeds) {
  std::map<std::tuple<std::string, std::string, int>, double> starts;
  for (auto& sample : speeds) {
    const auto stroke = std::tuple(sample.participant, sample.level, sample.stroke);
    sample.time_s -= starts.try_emplace(stroke, sample.time_s).first->second;
  }
}

}  // namespace

std::string experienceBand(std::optional<double> years) {
  if (!years) return {};
  if (*years < 5) return "<5";
  if (*years < 10) return "5-9";
  return *years < 15 ? "10-14" : "15+";
}

std::vector<std::string> inputsOf(const study::Study& study) {
  std::vector<std::string> inputs = procedure::of(study).inputIds();
  for (const auto& rule : study.rules) {
    for (const auto& condition : rule.conditions) {
      if (std::find(inputs.begin(), inputs.end(), condition.input) == inputs.end()) inputs.push_back(condition.input);
    }
  }
  return inputs;
}

std::string simulatedNote(const study::Study& study) {
  const auto count = std::count_if(study.participants.begin(), study.participants.end(),
                                   [](const study::Participant& participant) { return participant.simulated; });
  if (count == 0) return {};
  return "Simulated by a program, not measured: the data of " + std::to_string(count) + " of " +
         std::to_string(study.participants.size()) + " participants (column `simulated`).";
}

std::string virtualNote(const study::Study& study) {
  std::vector<std::string> codes;
  for (const auto& participant : study.participants) {
    if (participant.virtual_device) codes.push_back(participant.code);
  }
  if (codes.empty()) return {};
  return "VIRTUAL: " + base::joined(codes, ", ") +
         " moved a device that gives no force. No judgement made there is among these data; its strokes are only where "
         "the protocol says virtual = accepted.";
}

ShareableStudy shareable(const study::Study& study, std::uint64_t seed) {
  const auto places = shuffledPlaces(study.participants.size(), seed);
  ShareableStudy out;
  out.study.participants.resize(places.size());
  out.bands.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& from = study.participants[i];
    auto& to = out.study.participants[places[i]];
    to.code = out.codes[from.code] = Renamer::code(places[i]);
    to.category = oneOf(kCategories, from.category);
    to.handedness = oneOf(kHands, from.handedness);
    to.simulated = from.simulated;
    to.virtual_device = from.virtual_device;
    to.setup_unchecked = from.setup_unchecked;
    out.bands[places[i]] = experienceBand(from.years_experience);
  }
  const Renamer renamer(study.participants, places);
  out.study.speeds = renamer.renamed(study.speeds);
  startAtZero(out.study.speeds);
  out.study.judgements = renamer.renamed(study.judgements);
  out.study.answers = renamer.renamed(study.answers);
  for (auto& answer : out.study.answers) {
    const auto known = questionnaires::wordingsOf(procedure::of(study), answer.form);
    if (std::find(known.begin(), known.end(), answer.wording) == known.end()) answer.wording.clear();
  }
  out.study.rules = renamer.renamed(study.rules);
  out.study.procedure = study.procedure;
  return out;
}

}  // namespace tactus::session
