#include "core/procedure/procedure.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "questionnaires/questionnaire.h"

#include "tests/support/temp_folder.h"

namespace tactus::procedure {
namespace {

using Json = nlohmann::ordered_json;

Json term(const char* id, std::vector<double> points) { return {{"id", id}, {"label", id}, {"points", points}}; }

/// A pack with two inputs and two words.
struct Small {
  Json manifest = {{"format", "tactus-procedure"},
                   {"version", 1},
                   {"id", "probe"},
                   {"pack_version", 2},
                   {"title", {{"fr", "Sonde"}}},
                   {"languages", {"fr"}},
                   {"about", "A probe."},
                   {"inputs",
                    {{{"id", "way"},
                      {"label", "Way"},
                      {"unit", "mm"},
                      {"min", 0},
                      {"max", 60},
                      {"role", "way"},
                      {"terms", {term("near", {0, 0, 20, 40}), term("far", {20, 40, 60, 60})}}},
                     {{"id", "gel"},
                      {"label", "Gel"},
                      {"unit", "1"},
                      {"min", 0},
                      {"max", 1},
                      {"role", "condition"},
                      {"declared_direction", "falls"},
                      {"usual", 1},
                      {"terms", {term("dry", {0, 0, 0.4, 0.6}), term("wet", {0.4, 0.6, 1, 1})}}}}},
                   {"output",
                    {{"id", "force"},
                     {"label", "Force"},
                     {"unit", "N"},
                     {"min", 0},
                     {"max", 2},
                     {"terms", {term("low", {0, 0, 0.8, 1.2}), term("high", {0.8, 1.2, 2, 2})}}}},
                   {"forms", {"form.json"}},
                   {"wordings", {"form.fr.json"}},
                   {"words", "words.json"}};
  Json form = {{"format", "tactus-form"},
               {"id", "probe-v1"},
               {"version", 1},
               {"title", "Probe"},
               {"source", "own"},
               {"answers", {{{"term", "low"}, {"word", "Low"}}, {{"term", "high"}, {"word", "High"}}}},
               {"items",
                {{{"number", 1}, {"if", {{"gel", "dry"}, {"way", "near"}}}},
                 {{"number", 2}, {"if", {{"gel", "wet"}, {"way", "near"}}}}}}};
  Json wording = {
      {"format", "tactus-form-wording"},
      {"form", "probe-v1"},
      {"form_version", 1},
      {"wording", "plain"},
      {"language", "fr"},
      {"title", "Sonde"},
      {"instructions", "Pensez."},
      {"question", "Quelle force ?"},
      {"phrases", {{"gel", {{"dry", "Sans gel."}, {"wet", "Avec gel."}}}, {"way", {{"near", "Tout près."}}}}},
      {"answers", {{"low", "faible"}, {"high", "forte"}}}};
  Json words = {{"format", "tactus-words"}, {"texts", Json::object()}};

  Small() {
    for (const char* id : {"tool", "con.purpose", "you.years", "glo.way", "a.near", "a.far", "s.gel", "glo.gel",
                           "s.gel.dry", "s.gel.wet", "w.low", "w.high"})
      words["texts"][id] = {{"fr", "mot"}};
  }

  PackFiles files() const {
    return {{"procedure.json", manifest.dump()},
            {"form.json", form.dump()},
            {"form.fr.json", wording.dump()},
            {"words.json", words.dump()}};
  }
  std::string refusal() const {
    const auto read = readProcedure(files(), "p");
    if (!read) return read.error().message();
    const auto worded = questionnaires::checkWordings(*read);
    return worded ? "" : worded.error().message();
  }
};

TEST(Procedure, SaysWhatItIs) {
  const auto read = readProcedure(Small().files(), "p");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->id, "probe");
  EXPECT_EQ(read->version, 2);
  EXPECT_EQ(read->way(), 0U);
  EXPECT_EQ(read->rate(), std::nullopt);
  EXPECT_EQ(read->inputs[0].role, fuzzy::Role::kWay);
  EXPECT_EQ(read->inputs[1].role, fuzzy::Role::kUnsaid) << "what is not called depth or speed is a condition";
  EXPECT_EQ(read->input_notes[1].direction, Direction::kFalls);
  EXPECT_EQ(read->input_notes[1].usual, 1);
  EXPECT_TRUE(read->events.empty());
  ASSERT_EQ(read->forms.size(), 1U);
  EXPECT_EQ(read->forms[0].items[1].conditions, (std::vector<study::ItemCondition>{{"gel", "wet"}, {"way", "near"}}));
  const auto asked = questionnaires::questionnaire(*read, "probe-v1", "fr");
  ASSERT_TRUE(asked) << asked.error().message();
  EXPECT_EQ(asked->questions[0].text, "Sans gel. Tout près. Quelle force ?");
  EXPECT_EQ(asked->choices[1].label, "forte");
  EXPECT_EQ(questionnaires::wordingsOf(*read, "probe-v1"), std::vector<std::string>{"plain"});
}

TEST(Procedure, AsksAboutTheWayOutAndWhereToStop) {
  Small small;
  small.manifest["stop_question"] = true;
  small.form["items"].push_back({{"number", 3}, {"if", {{"direction", "out"}, {"way", "near"}}}});
  EXPECT_EQ(small.refusal(),
            "p/words.json: texts: found no words in 'fr' for 's.direction', 's.direction.out', "
            "wanted words for each");
  for (const char* id : {"s.direction", "s.direction.out"}) small.words["texts"][id] = {{"fr", "mot"}};
  EXPECT_EQ(small.refusal(),
            "probe/form.fr.json: /phrases: found no phrase for 'direction out' of item 3, wanted a "
            "phrase for each condition");
  small.wording["phrases"]["direction"] = {{"out", "En sortant."}};
  small.wording["order"] = {"direction", "way"};
  ASSERT_EQ(small.refusal(), "");
  const auto read = readProcedure(small.files(), "p");
  EXPECT_TRUE(read->stop_question);
  EXPECT_TRUE(study::isWayOut(read->forms[0].items[2]));
  EXPECT_FALSE(study::isWayOut(read->forms[0].items[0]));
  EXPECT_EQ(questionnaires::questionnaire(*read, "probe-v1", "fr")->questions[2].text,
            "En sortant. Tout près. Quelle force ?");
  small.form["items"][2]["if"]["direction"] = "in";
  EXPECT_EQ(small.refusal(),
            "p/form.json: /items/2/if: found 'direction in', wanted an input of the procedure and one "
            "of its words");
}

TEST(Procedure, HoldsForcesThatOthersPublished) {
  Small small;
  small.manifest["published_forces"] = {{{"label", {{"fr", "Retrait"}}},
                                         {"source", "Somebody 2000"},
                                         {"is_not", {{"fr", "Un retrait"}}},
                                         {"from_mm", 0},
                                         {"to_mm", 60},
                                         {"low_n", 0.8},
                                         {"high_n", 0.9}}};
  const auto read = readProcedure(small.files(), "p");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->published.size(), 1U);
  EXPECT_EQ(read->published[0].high_n, 0.9);
  small.manifest["published_forces"][0]["to_mm"] = 61;
  EXPECT_EQ(small.refusal().find("p/procedure.json: /published_forces/0/to_mm: found the number 61"), 0U)
      << small.refusal();
  small.manifest["published_forces"][0]["to_mm"] = 60;
  small.manifest["published_forces"][0].erase("is_not");
  EXPECT_EQ(small.refusal().find("p/procedure.json: /published_forces/0"), 0U) << small.refusal();
}

TEST(Procedure, HoldsFiguresThatOthersPublished) {
  Small small;
  small.manifest["figures"] = {{{"name", {{"fr", "Fig. 1"}}},
                                {"shows", {{"fr", "carte"}}},
                                {"at", Json::object()},
                                {"map", Json::array({"way", "gel"})}},
                               {{"name", {{"fr", "Fig. 2"}}},
                                {"shows", {{"fr", "le gel"}}},
                                {"at", {{"way", 20}}},
                                {"vary", {{"input", "gel"}, {"values", Json::array({0, 1})}}}}};
  const auto read = readProcedure(small.files(), "p");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->figures.size(), 2U);
  EXPECT_EQ(read->figures[0].map, (std::vector<std::string>{"way", "gel"}));
  EXPECT_EQ(read->figures[1].at, (std::map<std::string, double>{{"way", 20}}));
  EXPECT_EQ(read->figures[1].varied, "gel");
  EXPECT_EQ(read->figures[1].values, (std::vector<double>{0, 1}));

  const auto refusal = [&small](const char* place, const auto& wrong) {
    Small changed = small;
    changed.manifest[Json::json_pointer(place)] = wrong;
    return changed.refusal();
  };
  EXPECT_EQ(refusal("/figures/1/at", Json{{"neck", 20}}),
            "p/procedure.json: /figures/1/at: found 'neck', wanted an input of the procedure");
  EXPECT_EQ(refusal("/figures/1/at/way", 61), "p/procedure.json: /figures/1/at: found 61 for 'way', wanted 0 to 60");
  EXPECT_EQ(refusal("/figures/1/vary/values", Json::array({0, -1})),
            "p/procedure.json: /figures/1/vary/values: found -1 for 'gel', wanted 0 to 1");
  EXPECT_EQ(refusal("/figures/1/vary/values", Json::array()),
            "p/procedure.json: /figures/1/vary/values: found no values, wanted one for each curve");
  EXPECT_EQ(refusal("/figures/0/map", Json::array({"way", "way"})),
            "p/procedure.json: /figures/0/map: found 2 inputs, wanted two different inputs");
  EXPECT_EQ(refusal("/figures/0/map", Json::array({"way", "speed"})),
            "p/procedure.json: /figures/0/map: found 'speed', wanted an input of the procedure");
}

TEST(Procedure, TheHashIsOfTheFilesThatAreNamed) {
  const Small small;
  auto files = small.files();
  const auto sha256 = readProcedure(files, "p")->sha256;
  files["notes.txt"] = "not named";
  EXPECT_EQ(readProcedure(files, "p")->sha256, sha256);
  files["words.json"] += " ";
  EXPECT_NE(readProcedure(files, "p")->sha256, sha256);
}

TEST(Procedure, BrokenOnesAreRefusedInOneSentence) {
  const auto changed = [](auto change) {
    Small small;
    change(small);
    return small.refusal();
  };
  EXPECT_EQ(Small().refusal(), "");
  EXPECT_EQ(readProcedure({}, "p").error().message(),
            "p: found no procedure.json, wanted a pack: a folder or zip file with procedure.json");
  EXPECT_EQ(changed([](Small& s) { s.manifest["inputs"][1]["role"] = "way"; }),
            "p/procedure.json: /inputs/1/unit: found '1', wanted 'mm'");
  EXPECT_EQ(changed([](Small& s) {
              s.manifest["inputs"][1]["role"] = "way";
              s.manifest["inputs"][1]["unit"] = "mm";
            }),
            "p/procedure.json: /inputs/1/role: found a second input of the role 'way', wanted one");
  EXPECT_EQ(changed([](Small& s) { s.manifest["inputs"][1]["id"] = "direction"; }),
            "p/procedure.json: /inputs/1/id: found 'direction', wanted another id: this one stands for the way out");
  EXPECT_EQ(changed([](Small& s) { s.manifest["inputs"].erase(0); }),
            "p/procedure.json: /inputs: found no input of the role 'way', wanted one");
  const auto withEvents = [&](Json events) { return changed([&events](Small& s) { s.manifest["events"] = events; }); };
  EXPECT_EQ(withEvents({{{"term", "near"}, {"share", 0.6}}}), "");
  EXPECT_EQ(withEvents({{{"term", "dry"}, {"share", 0.6}}}),
            "p/procedure.json: /events/0/term: found 'dry', wanted a term of 'way': near, far");
  EXPECT_EQ(withEvents({{{"term", "near"}, {"share", 1}}}),
            "p/procedure.json: /events/0/share: found 1, wanted a number above 0 and below 1");
  EXPECT_EQ(withEvents({{{"term", "near"}, {"share", 0.5}}, {{"term", "near"}, {"share", 0.5}}}),
            "p/procedure.json: /events/1/term: found 'near' again, wanted each term once");
  EXPECT_EQ(withEvents(Json(9, {{"term", "near"}, {"share", 0.5}})),
            "p/procedure.json: /events: found 9 events, wanted at most 8");
  EXPECT_EQ(withEvents({{{"term", "near"}, {"share", 0.6}, {"often", true}}})
                .find("p/procedure.json: /events/0/often: found an unknown key, wanted "),
            0U);
  EXPECT_EQ(withEvents({{{"term", "near"}}}).find("p/procedure.json: /events/0: found no key 'share', wanted "), 0U);
  // A word that only one of the sets of the way has.
  EXPECT_EQ(changed([](Small& s) {
              Json& way = s.manifest["inputs"][0];
              way["term_sets"] = {{{"id", "two"}, {"label", "Two"}, {"terms", way["terms"]}},
                                  {{"id", "other"},
                                   {"label", "Other"},
                                   {"terms", {term("near", {0, 0, 20, 40}), term("end", {20, 40, 60, 60})}}}};
              way.erase("terms");
              s.words["texts"]["a.end"] = {{"fr", "mot"}};
              s.manifest["events"] = {{{"term", "far"}, {"share", 0.6}}};
            }),
            "p/procedure.json: /events/0/term: found 'far', wanted a term of 'way': near, end");
  EXPECT_EQ(changed([](Small& s) { s.manifest["inputs"][0].erase("id"); }),
            "p/procedure.json: /inputs/0: found no key 'id', wanted a key 'id' with a text that is not empty");
  EXPECT_EQ(changed([](Small& s) {
              s.manifest["colour"] = "red";
            }).find("p/procedure.json: /colour: found an unknown key, wanted "),
            0U);
  EXPECT_EQ(changed([](Small& s) { s.manifest["words"] = "../words.json"; }),
            "p/procedure.json: /words: found '../words.json', which leads out of the pack, wanted a file of the pack");
  EXPECT_EQ(changed([](Small& s) { s.manifest["forms"][0] = "no.json"; }),
            "p/procedure.json: /forms: found 'no.json', which is not there, wanted a file of the pack");
  EXPECT_EQ(changed([](Small& s) {
              s.manifest["inputs"][1]["terms"][0]["points"] = {0.9, 0, 0.4, 0.6};
            }).find("p/procedure.json: /inputs/1/terms/0/points"),
            0U);
  EXPECT_EQ(changed([](Small& s) { s.form["items"][0]["if"]["gel"] = "moist"; }),
            "p/form.json: /items/0/if: found 'gel moist', wanted an input of the procedure and one of its words");
  EXPECT_EQ(changed([](Small& s) { s.form["items"][1]["if"]["gel"] = "dry"; }),
            "p/form.json: /items/1/if: found the conditions of item 1 (gel dry, way near), wanted other conditions for "
            "each item");
  EXPECT_EQ(changed([](Small& s) { s.form["items"][1]["if"] = Json::object(); }),
            "p/form.json: /items/1/if: found no conditions, wanted at least one");
  EXPECT_EQ(changed([](Small& s) { s.form["answers"][0]["term"] = "middling"; }),
            "p/form.json: /answers/0/term: found 'middling', wanted a word of the output");
  EXPECT_EQ(
      changed([](Small& s) { s.wording["phrases"]["gel"].erase("wet"); }),
      "probe/form.fr.json: /phrases: found no phrase for 'gel wet' of item 2, wanted a phrase for each condition");
  EXPECT_EQ(
      changed([](Small& s) { s.wording["phrases"]["gel"]["moist"] = "Humide."; }),
      "probe/form.fr.json: /phrases: found a phrase for 'gel moist', wanted an input of the procedure and one of its "
      "words");
  EXPECT_EQ(changed([](Small& s) { s.wording["answers"]["middling"] = "moyenne"; }),
            "probe/form.fr.json: /answers: found 'middling', wanted an answer of the form");
  EXPECT_EQ(changed([](Small& s) { s.wording["language"] = "en"; }),
            "probe/form.fr.json: /language: found 'en', wanted one of fr");
  EXPECT_EQ(changed([](Small& s) { s.manifest["wordings"] = Json::array(); }),
            "probe/procedure.json: wordings: found no wording of 'probe-v1' in 'fr', wanted one");
  EXPECT_EQ(changed([](Small& s) { s.words["texts"].erase("w.low"); }),
            "p/words.json: texts: found no words in 'fr' for 'w.low', wanted words for each");
}

TEST(Procedure, AFolderIsReadWithinItsLimits) {
  const support::TempFolder folder;
  const std::string path = folder.file("probe");
  std::filesystem::create_directory(path);
  for (const auto& [name, bytes] : Small().files()) std::ofstream(path + "/" + name) << bytes;
  ASSERT_TRUE(readPackFolder(path)) << readPackFolder(path).error().message();
  std::filesystem::create_symlink("/etc/passwd", path + "/outside");
  EXPECT_FALSE(readPackFolder(path));
  std::filesystem::remove(path + "/outside");
  std::ofstream(path + "/huge.svg") << std::string(kMostFileBytes + 1, ' ');
  EXPECT_FALSE(readPackFolder(path));
  EXPECT_FALSE(readPackFolder(folder.file("nothing")));
}

TEST(Procedure, EveryPackOfTheProgramIsWhole) {
  for (const std::string& id : builtInIds()) {
    const auto procedure = builtIn(id);
    ASSERT_NE(procedure, nullptr);
    EXPECT_EQ(procedure->id, id);
    const auto worded = questionnaires::checkWordings(*procedure);
    EXPECT_TRUE(worded) << worded.error().message();
    if (procedure == defaultProcedure()) continue;
    for (const auto& language : questionnaires::languagesOf(*procedure, "usability-v1")) {
      const auto asked = questionnaires::questionnaire(*procedure, "usability-v1", language);
      ASSERT_TRUE(asked) << asked.error().message();
      EXPECT_EQ(asked->wording, "plain");
      for (const auto& question : asked->questions) {
        for (const char* word : {"NGT", "Magensonde", "鼻胃管"})
          EXPECT_EQ(question.text.find(word), std::string::npos) << question.text;
      }
    }
  }
  EXPECT_EQ(builtIn("other"), nullptr);
}

}  // namespace
}  // namespace tactus::procedure
