// A small study for the tests of the model builder, and short ways to look into what is built.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

inline study::Participant participant(const char* code, double years = 10, bool simulated = false) {
  study::Participant out;
  out.code = code;
  out.years_experience = years;
  out.simulated = simulated;
  return out;
}

/// Two items about the nasal cavity, one about the esophagus.
inline std::vector<study::Form> forms() {
  study::Form form;
  form.id = "short";
  form.depth_terms = "form_a1";
  form.items = {{1, "", {{"lubrication", "well"}, {"depth", "nasal_cavity"}}},
                {2, "", {{"speed", "fast"}, {"depth", "nasal_cavity"}}},
                {3, "", {{"speed", "slow"}, {"depth", "esophagus"}}}};
  study::Form reading;
  reading.id = "reading";
  reading.depth_terms = "form_a2";
  return {form, reading};
}

/// Two experts who answered the form; no speeds, no judgements.
inline study::Study smallStudy() {
  study::Study study;
  study.name = "Small study";
  study.participants = {participant("A", 3), participant("B", 1)};
  study.answers = {{"A", "short", 1, "very_small", study::Answer::Status::kAnswered},
                   {"A", "short", 2, "small", study::Answer::Status::kAnswered},
                   {"A", "short", 3, "medium", study::Answer::Status::kAnswered},
                   {"B", "short", 1, "small", study::Answer::Status::kAnswered},
                   {"B", "short", 2, "", study::Answer::Status::kSkipped}};
  return study;
}

inline fuzzy::Evaluation evaluate(const fuzzy::ForceModel& model, std::vector<double> in) {
  return fuzzy::compile(model).value().evaluate(in);
}

inline std::string errorOf(const study::Study& study, const BuildSettings& settings = {}) {
  const auto built = buildModel(study, forms(), settings);
  return built ? std::string("no error") : built.error().message();
}

inline bool mentions(const std::vector<std::string>& notes, const std::string& text) {
  return std::any_of(notes.begin(), notes.end(),
                     [&text](const std::string& note) { return note.find(text) != std::string::npos; });
}

/// JSON text of a setting of the provenance.
inline std::string settingOf(const fuzzy::ForceModel& model, const std::string& key) {
  for (const auto& setting : model.provenance->settings) {
    if (setting.key == key) return setting.json;
  }
  return "absent";
}

/// Ten samples at each of three speeds, so that the centers are those speeds.
inline void addSpeeds(study::Study& study, const char* who, std::vector<double> speeds_mm_s) {
  const char* levels[] = {"slow", "medium", "fast"};
  for (int sample = 0; sample < 10; ++sample) {
    for (std::size_t level = 0; level < 3; ++level) {
      study.speeds.push_back({who, levels[level], 1, 0.001 * sample, 0, speeds_mm_s[level]});
    }
  }
}

}  // namespace tactus::elicitation
