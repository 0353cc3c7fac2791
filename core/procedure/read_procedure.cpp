#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/json/json_members.h"
#include "core/base/text.h"
#include "core/fuzzy/validate.h"
#include "core/procedure/procedure.h"

namespace tactus::procedure {
namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::JsonValue;
using base::required;
using base::Result;
using Problem = std::optional<base::Error>;

constexpr base::NumberRange kFromOne{1, 1'000'000};
constexpr std::size_t kMostInputs = 6;
constexpr std::size_t kMostWords = 5;
constexpr std::size_t kMostRegions = 16;
constexpr std::size_t kLongestId = 40;

constexpr std::array<std::string_view, 3> kRoleNames = {"condition", "way", "rate"};
constexpr std::array<std::string_view, 4> kPictureNames = {"bars", "drops", "arrows", "pose"};
constexpr std::array<std::string_view, 2> kBesideNames = {"whole", "regions"};
constexpr std::array<std::string_view, 2> kDirectionNames = {"falls", "rises"};

/// An id is a part of the names of texts, columns, paths and symbols.
bool isId(std::string_view id, char separator) {
  return !id.empty() && id.size() <= kLongestId && std::all_of(id.begin(), id.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || base::isDigit(c) || c == separator;
  });
}

void readId(JsonMembers& json, std::string& id, char separator) {
  json.text(required("id"), id);
  if (id.empty() || isId(id, separator)) return;
  json.refuse("id", base::quoted(id), "at most 40 small letters, digits and '" + std::string(1, separator) + "'");
}

Texts readTexts(JsonMembers& json, std::string_view key) {
  std::vector<JsonMembers::NamedText> texts;
  json.texts(required(key), texts);
  return {texts.begin(), texts.end()};
}

std::vector<fuzzy::Term> readTerms(JsonMembers& json, Problem& error, std::size_t least, std::size_t most) {
  std::vector<fuzzy::Term> terms;
  std::set<std::string> ids;
  for (const JsonValue value : json.elements(required("terms"))) {
    JsonMembers members(value, error);
    fuzzy::Term& term = terms.emplace_back();
    readId(members, term.id, '_');
    members.text(required("label"), term.label);
    members.numbers(required("points"), term.points);
    members.refuseOthers();
    if (!ids.insert(term.id).second) members.refuse("id", base::quoted(term.id) + " again", "each id once");
  }
  if (terms.size() < least || terms.size() > most) {
    json.refuse("terms", std::to_string(terms.size()) + (terms.size() == 1 ? " word" : " words"),
                std::to_string(least) + " to " + std::to_string(most));
  }
  return terms;
}

fuzzy::Variable readVariable(JsonMembers& json) {
  fuzzy::Variable out;
  readId(json, out.id, '_');
  json.text(required("label"), out.label);
  json.text(required("unit"), out.unit);
  json.number(required("min"), out.min);
  json.number(required("max"), out.max);
  return out;
}

void wantUnit(JsonMembers& json, const fuzzy::Variable& variable, const char* unit) {
  if (!variable.unit.empty() && variable.unit != unit)
    json.refuse("unit", base::quoted(variable.unit), base::quoted(unit));
}

std::vector<TermSet> readTermSets(JsonMembers& json, Problem& error) {
  std::vector<TermSet> out;
  std::set<std::string> ids;
  for (const JsonValue value : json.elements("term_sets")) {
    JsonMembers members(value, error);
    TermSet& set = out.emplace_back();
    readId(members, set.id, '_');
    members.text(required("label"), set.label);
    set.terms = readTerms(members, error, 2, kMostRegions);
    members.refuseOthers();
    if (!ids.insert(set.id).second) members.refuse("id", base::quoted(set.id) + " again", "each id once");
  }
  return out;
}

void readInput(JsonMembers json, Procedure& out, Problem& error) {
  fuzzy::Variable input = readVariable(json);
  if (input.id == study::kWayOut.input)
    json.refuse("id", base::quoted(input.id), "another id: this one stands for the way out");
  InputNotes notes;
  const auto role = json.word(required("role"), kRoleNames);
  input.role = fuzzy::kRoles[role.value_or(0)];
  if (input.role == fuzzy::Role::kWay) {
    wantUnit(json, input, "mm");
    if (!out.way_terms.empty()) json.refuse("role", "a second input of the role 'way'", "one");
    if (json.has("term_sets")) {
      out.way_terms = readTermSets(json, error);
      if (out.way_terms.empty()) json.refuse("term_sets", "no sets", "at least one");
    } else {
      out.way_terms = {{"regions", input.label, readTerms(json, error, 2, kMostRegions)}};
    }
    if (!out.way_terms.empty()) input.terms = out.way_terms.front().terms;
  } else {
    if (input.role == fuzzy::Role::kRate) {
      wantUnit(json, input, "mm/s");
      if (fuzzy::rateOf(out.inputs)) json.refuse("role", "a second input of the role 'rate'", "at most one");
    }
    input.terms = readTerms(json, error, 1, kMostWords);
  }
  const auto direction = json.word("declared_direction", kDirectionNames);
  if (direction) notes.direction = *direction == 0 ? Direction::kFalls : Direction::kRises;
  if (const auto picture = json.word("level_picture", kPictureNames)) notes.picture = kLevelPictures[*picture];
  notes.usual = (input.min + input.max) / 2;
  json.number("usual", notes.usual, {input.min, input.max});
  json.text("own_model", notes.own_model);
  if (!notes.own_model.empty() && fuzzy::findTerm(input.terms, notes.own_model) == nullptr)
    json.refuse("own_model", base::quoted(notes.own_model), "a word of the input", ErrorCode::kReference);
  json.refuseOthers();
  // Said only where the id does not say it, as in model files.
  const fuzzy::Role said = std::exchange(input.role, fuzzy::Role::kUnsaid);
  if (fuzzy::roleOf(input) != said) input.role = said;
  out.inputs.push_back(std::move(input));
  out.input_notes.push_back(std::move(notes));
}

std::vector<Step> readSteps(JsonMembers& json, Problem& error) {
  std::vector<Step> out;
  for (const JsonValue value : json.elements("steps")) {
    JsonMembers members(value, error);
    Step step;
    step.title = readTexts(members, "title");
    step.text = readTexts(members, "text");
    members.number("from_mm", step.from_mm);
    members.refuseOthers();
    if (!out.empty() && out.back().from_mm && (!step.from_mm || *step.from_mm <= *out.back().from_mm))
      members.refuse("from_mm", "a step that does not begin behind the one before", "places that rise");
    out.push_back(std::move(step));
  }
  return out;
}

std::vector<Landmark> readLandmarks(JsonMembers& json, Problem& error) {
  std::vector<Landmark> out;
  for (const JsonValue value : json.elements("landmarks")) {
    JsonMembers members(value, error);
    Landmark& mark = out.emplace_back();
    mark.name = readTexts(members, "name");
    mark.what = readTexts(members, "what");
    members.number(required("from_mm"), mark.from_mm);
    members.number(required("to_mm"), mark.to_mm, {mark.from_mm, 1e9});
    members.text(required("source"), mark.source);
    members.refuseOthers();
  }
  return out;
}

std::vector<PublishedForce> readPublished(JsonMembers& json, const Procedure& procedure, Problem& error) {
  std::vector<PublishedForce> out;
  for (const JsonValue value : json.elements("published_forces")) {
    JsonMembers members(value, error);
    PublishedForce& force = out.emplace_back();
    force.label = readTexts(members, "label");
    members.text(required("source"), force.source);
    force.is_not = readTexts(members, "is_not");
    const fuzzy::Variable* const way = error ? nullptr : &procedure.wayInput();
    members.number(required("from_mm"), force.from_mm, {way != nullptr ? way->min : 0, way != nullptr ? way->max : 0});
    members.number(required("to_mm"), force.to_mm, {force.from_mm, way != nullptr ? way->max : force.from_mm});
    members.number(required("low_n"), force.low_n, {0, 1e3});
    members.number(required("high_n"), force.high_n, {force.low_n, 1e3});
    members.refuseOthers();
  }
  return out;
}

const fuzzy::Variable* inputOf(const Procedure& procedure, std::string_view id) {
  const auto found = std::find_if(procedure.inputs.begin(), procedure.inputs.end(),
                                  [id](const fuzzy::Variable& input) { return input.id == id; });
  return found == procedure.inputs.end() ? nullptr : &*found;
}

bool isWithin(const fuzzy::Variable& input, double value) { return value >= input.min && value <= input.max; }

std::vector<Figure> readFigures(JsonMembers& json, const Procedure& procedure, Problem& error) {
  std::vector<Figure> out;
  for (const JsonValue value : json.elements("figures")) {
    JsonMembers members(value, error);
    Figure& figure = out.emplace_back();
    figure.name = readTexts(members, "name");
    figure.shows = readTexts(members, "shows");
    const auto wanted = [&procedure](JsonMembers& at, std::string_view key, const std::string& id) {
      const fuzzy::Variable* const input = inputOf(procedure, id);
      if (input == nullptr) at.refuse(key, base::quoted(id), "an input of the procedure", ErrorCode::kReference);
      return input;
    };
    const auto within = [](JsonMembers& at, std::string_view key, const fuzzy::Variable* input, double number) {
      if (input == nullptr || isWithin(*input, number)) return;
      at.refuse(key, base::formatNumber(number) + " for " + base::quoted(input->id),
                base::formatNumber(input->min) + " to " + base::formatNumber(input->max));
    };
    members.numbers(required("at"), figure.at, base::kAnyNumber);
    for (const auto& [id, number] : figure.at) within(members, "at", wanted(members, "at", id), number);
    if (const auto vary = members.object("vary")) {
      JsonMembers of(*vary, error);
      of.text(required("input"), figure.varied);
      of.numbers(required("values"), figure.values);
      const fuzzy::Variable* const input = figure.varied.empty() ? nullptr : wanted(of, "input", figure.varied);
      if (!error && figure.values.empty()) of.refuse("values", "no values", "one for each curve");
      for (const double number : figure.values) within(of, "values", input, number);
      of.refuseOthers();
    }
    if (members.has("map")) {
      members.texts("map", figure.map);
      for (const std::string& id : figure.map) wanted(members, "map", id);
      if (!error && (figure.map.size() != 2 || figure.map[0] == figure.map[1]))
        members.refuse("map", std::to_string(figure.map.size()) + " inputs", "two different inputs");
    }
    members.refuseOthers();
  }
  return out;
}

/// The events of a model of each set of terms; `checkVariables` looks at them.
std::vector<fuzzy::TubeEvent> readEvents(JsonMembers& json, Problem& error) {
  std::vector<fuzzy::TubeEvent> out;
  for (const JsonValue value : json.elements("events")) {
    JsonMembers members(value, error);
    fuzzy::TubeEvent& event = out.emplace_back();
    members.text(required("term"), event.term);
    members.number(required("share"), event.share);
    members.refuseOthers();
  }
  return out;
}

/// Paths of files that must be in the pack.
void wantFile(JsonMembers& json, std::string_view key, const std::string& path, const PackFiles& files) {
  if (path.empty() || files.contains(path)) return;
  const bool outside =
      path.starts_with('/') || path.find("..") != std::string::npos || path.find('\\') != std::string::npos;
  json.refuse(
      key, outside ? base::quoted(path) + ", which leads out of the pack" : base::quoted(path) + ", which is not there",
      "a file of the pack", ErrorCode::kReference);
}

/// A manifest before the files that it names are read.
struct Named {
  std::vector<std::string> forms;
  std::string words;
};

Procedure readManifest(JsonMembers& json, Problem& error, const PackFiles& files, Named& named) {
  Procedure out;
  json.format("tactus-procedure");
  json.version(required("version"));
  readId(json, out.id, '-');
  json.integer(required("pack_version"), out.version, kFromOne);
  out.title = readTexts(json, "title");
  json.texts(required("languages"), out.languages);
  json.texts("unreviewed_languages", out.unreviewed);
  json.text(required("about"), out.about);
  json.texts("sources", out.sources);
  if (!error && out.languages.empty()) json.refuse("languages", "no language", "at least one");
  for (const std::string& language : out.unreviewed) {
    if (std::find(out.languages.begin(), out.languages.end(), language) == out.languages.end())
      json.refuse("unreviewed_languages", base::quoted(language), "one of 'languages'");
  }
  for (const JsonValue value : json.elements(required("inputs"))) readInput({value, error}, out, error);
  if (!error && (out.inputs.empty() || out.inputs.size() > kMostInputs))
    json.refuse("inputs", std::to_string(out.inputs.size()) + " inputs", "one to six");
  if (!error && out.way_terms.empty()) json.refuse("inputs", "no input of the role 'way'", "one");
  if (const auto value = json.object(required("output"))) {
    JsonMembers members(*value, error);
    out.output = readVariable(members);
    wantUnit(members, out.output, "N");
    if (!error && out.output.min != 0) members.refuse("min", base::formatNumber(out.output.min), "0");
    out.output.terms = readTerms(members, error, 1, kMostWords);
    members.refuseOthers();
  }
  json.texts(required("forms"), named.forms);
  if (!error && named.forms.empty()) json.refuse("forms", "no form", "at least one");
  for (const std::string& path : named.forms) wantFile(json, "forms", path, files);
  json.texts(required("wordings"), out.wordings);
  for (const std::string& path : out.wordings) wantFile(json, "wordings", path, files);
  json.text("words", named.words);
  wantFile(json, "words", named.words, files);
  for (const JsonValue value : json.elements("pictures")) {
    JsonMembers members(value, error);
    Picture& picture = out.pictures.emplace_back();
    members.text(required("file"), picture.file);
    wantFile(members, "file", picture.file, files);
    if (const auto pose = members.object("pose")) {
      JsonMembers of(*pose, error);
      of.text(required("input"), picture.pose.input);
      of.text(required("term"), picture.pose.term);
      of.refuseOthers();
    }
    members.refuseOthers();
  }
  for (const JsonValue value : json.elements("other_views")) {
    JsonMembers members(value, error);
    OtherView& view = out.other_views.emplace_back();
    members.text(required("file"), view.file);
    wantFile(members, "file", view.file, files);
    members.text(required("word"), view.word);
    view.of_regions = members.word(required("beside"), kBesideNames) == 1U;
    members.refuseOthers();
  }
  out.steps = readSteps(json, error);
  out.landmarks = readLandmarks(json, error);
  out.published = readPublished(json, out, error);
  out.figures = readFigures(json, out, error);
  out.events = readEvents(json, error);
  if (const auto protocol = json.object("protocol")) out.protocol = protocol->json();
  json.number("device_scale", out.device_scale, {1, 20});
  json.flag("stop_question", out.stop_question);
  json.refuseOthers();
  return out;
}

// Forms

std::string inWords(const std::vector<study::ItemCondition>& conditions) {
  std::vector<std::string> parts;
  for (const auto& condition : conditions) parts.push_back(condition.input + " " + condition.term);
  return base::joined(parts, ", ");
}

/// Whether an input of the procedure has the word; of the way in the set `regions`.
bool isKnown(const Procedure& procedure, const TermSet& regions, const study::ItemCondition& condition) {
  if (condition == study::kWayOut) return true;
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const fuzzy::Variable& input = procedure.inputs[i];
    if (input.id != condition.input) continue;
    return fuzzy::findTerm(i == procedure.way() ? regions.terms : input.terms, condition.term) != nullptr;
  }
  return false;
}

void readItems(JsonMembers& json, const Procedure& procedure, const TermSet& regions, study::Form& form,
               Problem& error) {
  for (const JsonValue value : json.elements(required("items"))) {
    JsonMembers members(value, error);
    study::FormItem item;
    members.integer(required("number"), item.number, kFromOne);
    members.text("text", item.text);
    std::vector<JsonMembers::NamedText> conditions;
    members.texts(required("if"), conditions);
    members.refuseOthers();
    if (error) return;
    for (auto& [input, term] : conditions) {
      item.conditions.push_back({input, term});
      if (!isKnown(procedure, regions, item.conditions.back()))
        members.refuse("if", base::quoted(input + " " + term), "an input of the procedure and one of its words");
    }
    if (conditions.empty()) members.refuse("if", "no conditions", "at least one");
    for (const study::FormItem& earlier : form.items) {
      if (earlier.number == item.number)
        members.refuse("number", std::to_string(item.number) + " again", "each number once");
      if (earlier.conditions == item.conditions) {
        members.refuse(
            "if", "the conditions of item " + std::to_string(earlier.number) + " (" + inWords(item.conditions) + ")",
            "other conditions for each item");
      }
    }
    form.items.push_back(std::move(item));
  }
  if (form.items.empty()) json.refuse("items", "no items", "at least one item");
}

study::Form readForm(JsonMembers& json, const Procedure& procedure, Problem& error) {
  study::Form form;
  json.format("tactus-form");
  json.text(required("id"), form.id);
  json.text(required("title"), form.title);
  json.text(required("source"), form.source);
  json.integer(required("version"), form.version, kFromOne);
  form.depth_terms = procedure.way_terms.front().id;
  json.text("depth_terms", form.depth_terms);
  const TermSet* const regions = procedure.wayTerms(form.depth_terms);
  if (regions == nullptr) json.refuse("depth_terms", base::quoted(form.depth_terms), "a set of terms of the way");
  for (const JsonValue value : json.elements(required("answers"))) {
    JsonMembers members(value, error);
    study::AnswerWord& answer = form.answers.emplace_back();
    members.text(required("term"), answer.term);
    members.text(required("word"), answer.word);
    members.refuseOthers();
    if (fuzzy::findTerm(procedure.output.terms, answer.term) == nullptr)
      members.refuse("term", base::quoted(answer.term), "a word of the output", ErrorCode::kReference);
  }
  if (!error && form.answers.empty()) json.refuse("answers", "no answers", "at least one");
  if (regions != nullptr) readItems(json, procedure, *regions, form, error);
  json.refuseOthers();
  return form;
}

// What the files say together

/// The procedure as a model without rules, so that the checks of models hold here too.
Result<void> checkVariables(const Procedure& procedure) {
  for (const TermSet& set : procedure.way_terms) {
    fuzzy::ForceModel model;
    model.name = procedure.id;
    model.inputs = procedure.inputs;
    model.inputs[procedure.way()].terms = set.terms;
    model.output = procedure.output;
    model.events = procedure.events;
    const fuzzy::Rule rule{{{model.inputs.front().id, model.inputs.front().terms.front().id}},
                           model.output.terms.front().id};
    model.experts = {{"expert", "expert", 1, {}, {rule}}};
    if (auto ok = fuzzy::validate(model); !ok) return ok;
  }
  return {};
}

}  // namespace

Result<Procedure> readProcedure(PackFiles files, const std::string& name) {
  const auto manifest = files.find(std::string(kManifest));
  if (manifest == files.end()) {
    return base::inFile(
        {ErrorCode::kReference, {}, {}, "no procedure.json", "a pack: a folder or zip file with procedure.json"}, name);
  }
  const auto in = [&](std::string_view path) { return name + "/" + std::string(path); };
  Named named;
  TACTUS_TRY(Procedure out, base::readJson(manifest->second, in(kManifest), [&](JsonMembers& json, Problem& error) {
               return readManifest(json, error, files, named);
             }));
  if (auto ok = checkVariables(out); !ok) return base::inFile(std::move(ok).error(), in(kManifest));
  for (const std::string& path : named.forms) {
    TACTUS_TRY(auto form, base::readJson(files.at(path), in(path), [&](JsonMembers& json, Problem& error) {
                 return readForm(json, out, error);
               }));
    if (out.form(form.id) != nullptr) {
      return base::inFile({ErrorCode::kReference, {}, "/id", base::quoted(form.id) + " again", "each form once"},
                          in(path));
    }
    out.forms.push_back(std::move(form));
  }
  if (auto ok = readWords(out, files, named.words, name); !ok) return tl::unexpected(std::move(ok).error());
  // What the manifest does not name is no part of the pack.
  PackFiles kept;
  const auto keep = [&](const std::string& path) { kept.emplace(path, files.at(path)); };
  keep(std::string(kManifest));
  for (const std::string& path : named.forms) keep(path);
  for (const std::string& path : out.wordings) keep(path);
  if (!named.words.empty()) keep(named.words);
  for (const Picture& picture : out.pictures) keep(picture.file);
  for (const OtherView& view : out.other_views) keep(view.file);
  out.files = std::move(kept);
  out.sha256 = packSha256(out.files);
  if (auto ok = readPictures(out); !ok) return base::inFile(std::move(ok).error(), name);
  return out;
}

}  // namespace tactus::procedure
