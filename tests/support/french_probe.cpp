#include "tests/support/french_probe.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tactus::support {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRegions[] = {"peau", "capsule", "articulation"};
constexpr const char* kForces[] = {"minime", "faible", "forte", "extreme"};
constexpr const char* kLevels[] = {"lente", "mesuree", "rapide", "vive"};

/// `count` terms that cover [0, end] and overlap.
Json termsOf(const char* const* ids, int count, double end) {
  Json out = Json::array();
  const double width = end / count;
  for (int i = 0; i < count; ++i) {
    const double from = i * width;
    const double ramp = 0.2 * width;
    out.push_back({{"id", ids[i]},
                   {"label", ids[i]},
                   {"points",
                    {i == 0 ? 0 : from - ramp, i == 0 ? 0 : from + ramp, i + 1 == count ? end : from + width - ramp,
                     i + 1 == count ? end : from + width + ramp}}});
  }
  return out;
}

std::string conditionId(int index) { return std::string("etat_") + static_cast<char>('a' + index); }

Json inputsOf(const ProbeTraits& traits) {
  constexpr const char* kWords[] = {"souple", "raide"};
  Json out = Json::array();
  for (int i = 0; i < traits.conditions; ++i) {
    out.push_back({{"id", conditionId(i)},
                   {"label", "Etat " + std::string(1, static_cast<char>('A' + i))},
                   {"unit", "1"},
                   {"min", 0},
                   {"max", 1},
                   {"role", "condition"},
                   {"usual", 0.25},
                   {"terms", termsOf(kWords, 2, 1)}});
    if (i == 0) out.back()["declared_direction"] = "rises";
  }
  out.push_back({{"id", "avancee"},
                 {"label", "Avancée"},
                 {"unit", "mm"},
                 {"min", 0},
                 {"max", 60},
                 {"role", "way"},
                 {"terms", termsOf(kRegions, 3, 60)}});
  if (traits.rate_words > 0) {
    out.push_back({{"id", "allure"},
                   {"label", "Allure"},
                   {"unit", "mm/s"},
                   {"min", 0},
                   {"max", 80},
                   {"role", "rate"},
                   {"usual", 20},
                   {"terms", termsOf(kLevels, traits.rate_words, 80)}});
  }
  return out;
}

Json formOf(const Json& inputs) {
  Json out = {{"format", "tactus-form"},
              {"id", "sonde-v1"},
              {"version", 1},
              {"title", "Force de la sonde"},
              {"source", "Formulaire propre"},
              {"answers", Json::array()},
              {"items", Json::array()}};
  for (const char* word : kForces) out["answers"].push_back({{"term", word}, {"word", word}});
  int number = 0;
  for (const Json& input : inputs) {
    if (input["id"] == "avancee") continue;
    for (const Json& term : input["terms"]) {
      for (const char* region : kRegions) {
        out["items"].push_back(
            {{"number", ++number}, {"if", {{std::string(input["id"]), term["id"]}, {"avancee", region}}}});
      }
    }
  }
  return out;
}

Json wordingOf(const Json& inputs) {
  Json phrases = Json::object();
  for (const Json& input : inputs) {
    for (const Json& term : input["terms"]) phrases[std::string(input["id"])][std::string(term["id"])] = "Une phrase.";
  }
  Json answers = Json::object();
  for (const char* word : kForces) answers[word] = word;
  return {{"format", "tactus-form-wording"},
          {"form", "sonde-v1"},
          {"form_version", 1},
          {"wording", "plain"},
          {"language", "fr"},
          {"title", "La force de la sonde"},
          {"instructions", "Pensez."},
          {"question", "Quelle force ?"},
          {"phrases", phrases},
          {"answers", answers}};
}

Json wordsOf(const Json& inputs) {
  Json texts = Json::object();
  const auto add = [&texts](const std::string& id) { texts[id] = {{"fr", "mot"}}; };
  for (const char* id : {"tool", "con.purpose", "you.years", "glo.way"}) add(id);
  for (const char* region : kRegions) add(std::string("a.") + region);
  for (const char* force : kForces) add(std::string("w.") + force);
  for (const Json& input : inputs) {
    const std::string id = input["id"];
    add("s." + id);
    add("glo." + id);
    for (const Json& term : input["terms"]) {
      add("s." + id + "." + std::string(term["id"]));
      add("spd." + std::string(term["id"]));
    }
  }
  return {{"format", "tactus-words"}, {"texts", texts}};
}

}  // namespace

std::shared_ptr<const procedure::Procedure> frenchProbe(const ProbeTraits& traits) {
  const Json inputs = inputsOf(traits);
  const Json manifest = {{"format", "tactus-procedure"},
                         {"version", 1},
                         {"id", "sonde-articulaire"},
                         {"pack_version", 3},
                         {"title", {{"fr", "Sonde articulaire"}}},
                         {"languages", {"fr"}},
                         {"about", "Une sonde dans une articulation."},
                         {"sources", {"Manuel de la sonde"}},
                         {"inputs", inputs},
                         {"output",
                          {{"id", "effort"},
                           {"label", "Effort"},
                           {"unit", "N"},
                           {"min", 0},
                           {"max", 2},
                           {"terms", termsOf(kForces, 4, 2)}}},
                         {"forms", {"form.json"}},
                         {"wordings", {"form.fr.json"}},
                         {"words", "words.json"}};
  auto read = procedure::readProcedure({{"procedure.json", manifest.dump()},
                                        {"form.json", formOf(inputs).dump()},
                                        {"form.fr.json", wordingOf(inputs).dump()},
                                        {"words.json", wordsOf(inputs).dump()}},
                                       "probe");
  EXPECT_TRUE(read) << read.error().message();
  return std::make_shared<const procedure::Procedure>(*std::move(read));
}

study::Study probeStudy(const ProbeTraits& traits, int participants) {
  study::Study out;
  out.name = "Etude";
  out.procedure = frenchProbe(traits);
  const study::Form& form = out.procedure->forms.front();
  for (int who = 1; who <= participants; ++who) {
    const std::string code = "P" + std::to_string(who);
    out.participants.emplace_back().code = code;
    for (const study::FormItem& item : form.items) {
      const int level = (item.number + who / 2) % 4;
      out.answers.push_back({code, form.id, item.number, kForces[level], study::Answer::Status::kAnswered});
    }
    for (int step = 1; step <= 10; ++step) {
      const int level = std::min(3, (step + who / 3) / 3);
      out.judgements.push_back(
          {code, "ascending", step, 0.2 * step, study::ForceJudgement::Kind::kTerm, kForces[level]});
    }
    for (int level = 0; level < traits.rate_words; ++level) {
      const double speed_mm_s = 10 + 50.0 * level / std::max(1, traits.rate_words - 1) + who;
      for (int stroke = 1; stroke <= 3; ++stroke) {
        for (int sample = 0; sample < 20; ++sample) {
          const double time_s = 0.01 * sample;
          out.speeds.push_back(
              {code, kLevels[level], stroke, time_s, speed_mm_s * time_s, speed_mm_s + stroke + 0.1 * sample});
        }
      }
    }
  }
  return out;
}

}  // namespace tactus::support
