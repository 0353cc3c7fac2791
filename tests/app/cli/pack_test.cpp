// Procedures as data: the guide's example word by word, and a pack of another kind through the whole job.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/bundle/zip.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

namespace fs = std::filesystem;
using PackJson = nlohmann::ordered_json;

/// The work folder of a test, so that it can use the relative paths of the guide.
class InFolder : public testing::Test {
 protected:
  void SetUp() override { fs::current_path(folder_.file("")); }
  void TearDown() override { fs::current_path(before_); }

  support::TempFolder folder_;

 private:
  fs::path before_ = fs::current_path();
};

/// Words of nasogastric tube insertion in the text files below `folder`, each with its file.
std::string foreignWords(const fs::path& folder) {
  std::string found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".tactus") continue;
    const std::string text = base::lowered(readText(entry.path().string()));
    for (const char* word : {"naso", "nasal", "oesoph", "esoph", "nostril", "neck", "stomach", "lubric", "45 items"}) {
      if (text.find(word) != std::string::npos) found += entry.path().string() + ": " + word + "\n";
    }
  }
  return found;
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> out;
  for (std::string word; stream >> word;) out.push_back(word);
  return out;
}

class GuideOfPacks : public InFolder {};

TEST_F(GuideOfPacks, IsFollowedWordByWord) {
  std::istringstream page(readText(std::string(TACTUS_SOURCE_DIR) + "/docs/guide/own-procedure.md"));
  std::string named;  // the file whose content comes next
  int files = 0;
  int commands = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with('`') && line.ends_with("`:")) named = line.substr(1, line.size() - 3);
    if (!line.starts_with("```")) continue;
    const bool runs = line == "```sh";
    std::string block;
    while (std::getline(page, line) && line != "```") block += line + "\n";
    if (!runs) {
      if (named.empty()) continue;
      if (const auto parent = fs::path(named).parent_path(); !parent.empty()) fs::create_directories(parent);
      writeText(named, block);
      named.clear();
      ++files;
      continue;
    }
    std::istringstream lines(block);
    for (std::string command; std::getline(lines, command);) {
      auto words = wordsOf(command);
      ASSERT_FALSE(words.empty());
      ASSERT_EQ(words.front(), "tactus") << command;
      words.erase(words.begin());
      const ProgramRun run(words);
      EXPECT_EQ(run.status, 0) << command << "\n" << run.err;
      ++commands;
    }
  }
  EXPECT_GE(files, 8);
  EXPECT_GE(commands, 8);
  EXPECT_EQ(foreignWords("form"), "");
}

class Packs : public InFolder {
 protected:
  /// The example that `pack new` writes, without its rate, with four words, in French, without a picture.
  void makeAnother() {
    ASSERT_EQ(ProgramRun({"pack", "new", "other"}).status, 0);
    change("other/procedure.json", [](PackJson& json) {
      json["id"] = "sonde";
      json["title"] = {{"fr", "Sonde"}};
      json["languages"] = {"fr"};
      json["inputs"].erase(2);
      json["inputs"][1]["id"] = "way";
      json["output"]["terms"] = PackJson::array();
      for (int i = 0; i < 4; ++i) {
        const double from = i * 0.4;
        json["output"]["terms"].push_back(
            {{"id", "w" + std::to_string(i)},
             {"label", "W" + std::to_string(i)},
             {"points", {std::max(0.0, from - 0.1), i == 0 ? 0 : from, from + 0.3, i == 3 ? 1.5 : from + 0.4}}});
      }
      json["output"]["terms"][3]["points"][2] = 1.5;
      json["wordings"] = {"forms/form.fr.json"};
      json.erase("pictures");
      json["stop_question"] = true;
    });
    change("other/forms/form.json", [](PackJson& json) {
      json["answers"] = PackJson::array();
      for (int i = 0; i < 4; ++i)
        json["answers"].push_back({{"term", "w" + std::to_string(i)}, {"word", "W" + std::to_string(i)}});
      PackJson items = PackJson::array();
      for (auto& item : json["items"]) {
        if (!item["if"].contains("gel")) continue;
        item["if"] = {{"gel", item["if"]["gel"]}, {"way", item["if"]["depth"]}};
        items.push_back(item);
      }
      items.push_back({{"number", 99}, {"if", {{"direction", "out"}, {"way", "bend"}}}});
      json["items"] = items;
    });
    fs::rename("other/forms/form.en.json", "other/forms/form.fr.json");
    change("other/forms/form.fr.json", [](PackJson& json) {
      json["language"] = "fr";
      json["question"] = "Quelle est la force ?";
      json["phrases"] = {{"direction", {{"out", "La sonde sort."}}},
                         {"gel", {{"none", "Sonde sèche."}, {"plenty", "Sonde avec du gel."}}},
                         {"way", {{"entry", "À l'entrée."}, {"bend", "Dans la courbe."}, {"inside", "Dedans."}}}};
      json["answers"] = PackJson::object();
      for (int i = 0; i < 4; ++i) json["answers"]["w" + std::to_string(i)] = "mot " + std::to_string(i);
    });
    change("other/words.json", [](PackJson& json) {
      PackJson texts = PackJson::object();
      for (const auto& [id, text] : json["texts"].items()) texts[id] = {{"fr", text["en"]}};
      texts["s.direction"] = {{"fr", "Sens"}};
      texts["s.direction.out"] = {{"fr", "En sortant"}};
      for (int i = 0; i < 4; ++i) texts["w.w" + std::to_string(i)] = {{"fr", "mot " + std::to_string(i)}};
      json["texts"] = texts;
    });
  }

  template <class Change>
  static void change(const std::string& path, Change change) {
    PackJson json = PackJson::parse(readText(path));
    change(json);
    writeText(path, json.dump(2));
  }
};

TEST_F(Packs, TheOneToBeginWithIsWhole) {
  ASSERT_EQ(ProgramRun({"pack", "new", "mine"}).status, 0);
  const ProgramRun check({"pack", "check", "mine", "--json"});
  ASSERT_EQ(check.status, 0) << check.err;
  const PackJson said = PackJson::parse(check.out);
  EXPECT_EQ(said["findings"].size(), 0U);
  EXPECT_EQ(said["inputs"][1]["role"], "way");
  EXPECT_EQ(said["forms"][0]["items"], 15);
  EXPECT_NE(ProgramRun({"pack", "new", "mine"}).status, 0) << "never over something";
}

TEST_F(Packs, AnotherKindGoesThroughTheWholeJob) {
  ASSERT_NO_FATAL_FAILURE(makeAnother());
  const ProgramRun check({"pack", "check", "other"});
  ASSERT_EQ(check.status, 0) << check.err;
  ASSERT_EQ(ProgramRun({"study", "new", "s.tactus", "--pack", "other"}).status, 0);
  fs::remove_all("other");  // the study keeps the pack
  const ProgramRun info({"study", "info", "s.tactus", "--json"});
  EXPECT_EQ(PackJson::parse(info.out)["procedure"]["id"], "sonde");
  const auto protocol = ProgramRun({"study", "protocol", "s.tactus"}).out;
  EXPECT_NE(protocol.find("blocks = force,form"), std::string::npos) << protocol;
  for (const char* to : {"web", "print", "redcap", "limesurvey"}) {
    const ProgramRun form({"study", "form", "s.tactus", "--to", to, "--out", std::string("form-") + to});
    EXPECT_EQ(form.status, 0) << to << form.err;
    EXPECT_EQ(foreignWords(std::string("form-") + to), "") << to;
  }
  EXPECT_NE(readText("form-print/my_form.fr.html").find("Quelle est la force"), std::string::npos);

  const ProgramRun simulated({"study", "simulate", "s.tactus", "--nurses", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const ProgramRun plan({"study", "plan", "s.tactus", "--studies", "5", "--most-nurses", "3"});
  EXPECT_EQ(plan.status, 0) << plan.err;
  const ProgramRun build({"build", "s.tactus", "--out", "m.tactus.json"});
  ASSERT_EQ(build.status, 0) << build.err;
  const PackJson model = PackJson::parse(readText("m.tactus.json"));
  EXPECT_EQ(model["inputs"][1]["role"], "way");
  EXPECT_EQ(model["inputs"].size(), 2U);
  EXPECT_EQ(model["provenance"]["settings"]["procedure"]["id"], "sonde");
  const ProgramRun bundle({"bundle", "m.tactus.json", "--out", "b"});
  ASSERT_EQ(bundle.status, 0) << bundle.err;
  EXPECT_NE(bundle.err.find("procedure/ is left out"), std::string::npos) << bundle.err;
  const ProgramRun whole({"bundle", "m.tactus.json", "--out", "b", "--study", "s.tactus"});
  EXPECT_EQ(whole.err.find("procedure/"), std::string::npos) << whole.err;
  EXPECT_EQ(ProgramRun({"verify", "b"}).status, 0);
  EXPECT_EQ(PackJson::parse(ProgramRun({"pack", "check", "b/procedure", "--json"}).out)["sha256"],
            model["provenance"]["settings"]["procedure"]["sha256"]);
  EXPECT_EQ(foreignWords("b"), "");
  for (const auto& expert : model["experts"]) EXPECT_EQ(expert["rules"].size(), 6U) << "the way out is no rule";
  const ProgramRun report({"report", "s.tactus", "--out", "report/r.html"});
  fs::create_directory("report");
  const ProgramRun again({"report", "s.tactus", "--out", "report/r.html"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(foreignWords("report"), "");
  for (const char* section : {"Where they would stop", "On the way out"})
    EXPECT_NE(readText("report/r.html").find(section), std::string::npos) << section;

  // The tables carry the pack, so another machine builds the same.
  ASSERT_EQ(ProgramRun({"study", "export", "s.tactus", "tables"}).status, 0);
  const ProgramRun other_build({"build", "tables", "--out", "n.tactus.json"});
  ASSERT_EQ(other_build.status, 0) << other_build.err;
  for (const std::vector<std::string>& command : {std::vector<std::string>{"vote", "tables/judgements.csv", "--json"},
                                                  {"agreement", "tables/answers.csv", "--json"}}) {
    const ProgramRun run(command);
    EXPECT_EQ(run.status, 0) << command[0] << run.err;
    EXPECT_NE(run.out.find("w3"), std::string::npos) << run.out;
  }
  EXPECT_EQ(ProgramRun({"vote", "s.tactus", "--pack", "nasopharyngeal-swab"}).status, 1);
  const auto stops = base::CsvTable::read("tables/stop_forces.csv");
  ASSERT_TRUE(stops) << stops.error().message();
  EXPECT_EQ(stops->rowCount(), base::CsvTable::read("tables/judgements.csv")->rowCount());
  ASSERT_EQ(ProgramRun({"study", "export", "s.tactus", "shared", "--shareable"}).status, 0);
  EXPECT_EQ(base::CsvTable::read("shared/stop_forces.csv")->rowCount(), stops->rowCount());
  EXPECT_EQ(PackJson::parse(readText("n.tactus.json"))["experts"], model["experts"]);
}

TEST_F(Packs, ForcesBeyondADeviceHaveAScale) {
  ASSERT_EQ(ProgramRun({"pack", "new", "mine"}).status, 0);
  change("mine/procedure.json", [](PackJson& json) {
    json["device_scale"] = 3;
    json["output"]["max"] = 8;
    json["output"]["terms"].back()["points"][2] = 8;
    json["output"]["terms"].back()["points"][3] = 8;
    json.erase("protocol");
  });
  const ProgramRun made({"study", "new", "s.tactus", "--pack", "mine"});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto protocol = ProgramRun({"study", "protocol", "s.tactus"}).out;
  EXPECT_NE(protocol.find("force.ladder.highest_n = 8"), std::string::npos) << protocol;
  const ProgramRun simulated({"study", "simulate", "s.tactus", "--nurses", "2"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const ProgramRun report({"report", "s.tactus", "--out", "r.html"});
  ASSERT_EQ(report.status, 0) << report.err;
  EXPECT_NE(readText("r.html").find("in the hand they were 1 : 3"), std::string::npos);
  change("mine/procedure.json", [](PackJson& json) { json["device_scale"] = 0.5; });
  const ProgramRun broken({"pack", "check", "mine"});
  EXPECT_EQ(broken.status, 1);
  EXPECT_NE(broken.err.find("/device_scale"), std::string::npos) << broken.err;
}

TEST_F(Packs, AZipFileIsOneToo) {
  ASSERT_EQ(ProgramRun({"pack", "new", "mine"}).status, 0);
  bundle::PackedFiles files;
  for (const auto& entry : fs::recursive_directory_iterator("mine")) {
    if (entry.is_regular_file())
      files.emplace_back(entry.path().lexically_relative("mine").generic_string(), readText(entry.path().string()));
  }
  const auto zip = bundle::zipped(files, "mine");
  ASSERT_TRUE(zip);
  writeText("mine.zip", *zip);
  const PackJson folder = PackJson::parse(ProgramRun({"pack", "check", "mine", "--json"}).out);
  const PackJson file = PackJson::parse(ProgramRun({"pack", "check", "mine.zip", "--json"}).out);
  EXPECT_EQ(file["sha256"], folder["sha256"]);
  EXPECT_EQ(ProgramRun({"study", "new", "s.tactus", "--pack", "mine.zip"}).status, 0);
}

/// A cannula into a vein: four regions, two punctures.
class PunctureOfAPack : public Packs {
 protected:
  void makeCannula() {
    ASSERT_EQ(ProgramRun({"pack", "new", "cannula"}).status, 0);
    const std::vector<std::string> regions = {"skin", "subcutis", "vein_wall", "lumen"};
    change("cannula/procedure.json", [](PackJson& json) {
      json["id"] = "peripheral-cannula";
      json["inputs"][1]["max"] = 12;
      json["inputs"][1]["terms"] = {{{"id", "skin"}, {"label", "Skin"}, {"points", {0, 0, 1.5, 2}}},
                                    {{"id", "subcutis"}, {"label", "Subcutis"}, {"points", {1.5, 2, 4, 4.5}}},
                                    {{"id", "vein_wall"}, {"label", "Vein wall"}, {"points", {4, 4.5, 5.5, 6}}},
                                    {{"id", "lumen"}, {"label", "Lumen"}, {"points", {5.5, 6, 12, 12}}}};
      json["events"] = {{{"term", "skin"}, {"share", 0.25}}, {{"term", "vein_wall"}, {"share", 0.6}}};
      json.erase("pictures");
    });
    change("cannula/forms/form.json", [&](PackJson& json) {
      PackJson items = PackJson::array();
      for (const auto& [input, terms] : {std::pair("gel", std::vector<std::string>{"none", "plenty"}),
                                         std::pair("speed", std::vector<std::string>{"slow", "medium", "fast"})}) {
        for (const std::string& term : terms) {
          for (const std::string& region : regions)
            items.push_back({{"number", items.size() + 1}, {"if", {{input, term}, {"depth", region}}}});
        }
      }
      json["items"] = items;
    });
    change("cannula/forms/form.en.json", [&](PackJson& json) {
      json["phrases"]["depth"] = PackJson::object();
      for (const std::string& region : regions) json["phrases"]["depth"][region] = "The tip is in the " + region + ".";
    });
    change("cannula/words.json", [&](PackJson& json) {
      for (const std::string& region : regions) json["texts"]["a." + region] = {{"en", region}};
    });
  }
};

TEST_F(PunctureOfAPack, IsFeltInTheBundleThatComesOfIt) {
  ASSERT_NO_FATAL_FAILURE(makeCannula());
  const std::string line = "puncture: vein wall, 60 % of the force is lost\n";
  for (const char* command : {"check", "show"}) {
    const ProgramRun run({"pack", command, "cannula"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find(line), std::string::npos) << run.out;
  }
  EXPECT_EQ(PackJson::parse(ProgramRun({"pack", "check", "cannula", "--json"}).out)["events"],
            PackJson::parse(R"([{"term": "skin", "share": 0.25}, {"term": "vein_wall", "share": 0.6}])"));
  ASSERT_EQ(ProgramRun({"study", "new", "s.tactus", "--pack", "cannula"}).status, 0);
  ASSERT_EQ(ProgramRun({"study", "simulate", "s.tactus", "--nurses", "2"}).status, 0);
  const ProgramRun build({"build", "s.tactus", "--out", "m.tactus.json"});
  ASSERT_EQ(build.status, 0) << build.err;
  PackJson model = PackJson::parse(readText("m.tactus.json"));
  EXPECT_EQ(model["events"], PackJson::parse(readText("cannula/procedure.json"))["events"]);

  const ProgramRun bundle({"bundle", "m.tactus.json", "--out", "b", "--table-error", "0.2"});
  ASSERT_EQ(bundle.status, 0) << bundle.err;
  EXPECT_NE(readText("b/checks_tube.csv").find("\npuncture_2,"), std::string::npos);
  EXPECT_NE(readText("b/report.html").find("Puncture: vein wall, 60 % of the force is lost"), std::string::npos);
  EXPECT_EQ(PackJson::parse(readText("b/model.tactus.json"))["events"], model["events"]);
  const ProgramRun verify({"verify", "b", "--json"});
  EXPECT_EQ(verify.status, 0) << verify.out << verify.err;
  const ProgramRun certify(
      {"certify", TACTUS_SIMULATOR, "--model", "b", "--points", "50", "--json", "--", "b/model.tactus.json", "", "1"});
  ASSERT_EQ(certify.status, 0) << certify.err;
  const PackJson said = PackJson::parse(certify.out);
  EXPECT_EQ(said["steps"]["right"], said["steps"]["asked"]);

  // Another share is another tube, and no other force.
  writeText("mine.json", [&] {
    model["events"][1]["share"] = 0.5;
    return model.dump();
  }());
  const ProgramRun diff({"diff", "m.tactus.json", "mine.json", "--json"});
  ASSERT_EQ(diff.status, 0) << diff.err;
  const PackJson found = PackJson::parse(diff.out);
  ASSERT_EQ(found["changes"].size(), 1U) << diff.out;
  EXPECT_EQ(found["changes"][0]["place"], "puncture at 'vein_wall'");
  EXPECT_EQ(found["force"]["largest_n"], 0);
  EXPECT_EQ(
      ProgramRun({"certify", TACTUS_SIMULATOR, "--model", "b", "--points", "50", "--", "mine.json", "", "1"}).status,
      1);
  const ProgramRun convert({"convert", "m.tactus.json", "--to", "fis", "--out", "fis"});
  EXPECT_EQ(convert.status, 0);
  EXPECT_NE(convert.err.find("not in these files: puncture, vein wall, 60 % of the force is lost"), std::string::npos)
      << convert.err;
}

TEST_F(Packs, StudiesOfTwoAreNeverMerged) {
  ASSERT_EQ(ProgramRun({"study", "new", "a.tactus"}).status, 0);
  ASSERT_EQ(ProgramRun({"study", "new", "b.tactus", "--pack", "male-urethral-catheter"}).status, 0);
  for (const auto& [into, from] : {std::pair("a.tactus", "b.tactus"), std::pair("b.tactus", "a.tactus")}) {
    const ProgramRun merge({"study", "merge", into, from});
    EXPECT_EQ(merge.status, 1);
    EXPECT_NE(merge.err.find("that of the study it is merged into"), std::string::npos) << merge.err;
  }
}

TEST_F(Packs, BrokenOnesGetOneSentence) {
  ASSERT_EQ(ProgramRun({"pack", "new", "mine"}).status, 0);
  const std::string whole = readText("mine/procedure.json");
  const auto refusal = [&](auto change_manifest) {
    writeText("mine/procedure.json", whole);
    change("mine/procedure.json", change_manifest);
    const ProgramRun run({"pack", "check", "mine"});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    return run.err;
  };
  EXPECT_NE(refusal([](PackJson& json) { json["inputs"][0]["role"] = "way"; }).find("/inputs/"), std::string::npos);
  EXPECT_NE(refusal([](PackJson& json) { json["forms"] = {"/etc/passwd"}; }).find("leads out of the pack"),
            std::string::npos);
  EXPECT_NE(refusal([](PackJson& json) { json["protocol"] = {{"force", {{"ladder", {{"step_n", -1}}}}}}; }), "");
  writeText("mine/procedure.json", whole);
  writeText("mine/pictures/side.svg", "<svg viewBox='0 0 1 1'><script/></svg>");
  const ProgramRun run({"study", "new", "s.tactus", "--pack", "mine"});
  EXPECT_EQ(run.status, 1);
  EXPECT_FALSE(fs::exists("s.tactus"));
}

}  // namespace
}  // namespace tactus::cli
