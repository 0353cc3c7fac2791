#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "app/bundle/zip.h"
#include "app/cli/study_commands.h"
#include "app/report/printed_form.h"
#include "app/session/study_procedure.h"
#include "app/webform/pictures.h"
#include "app/webform/web_form.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"
#include "questionnaires/survey.h"

namespace tactus::cli {

std::vector<std::pair<std::string_view, std::string_view>> examplePack();  // embedded from app/cli/example_pack

namespace {

namespace fs = std::filesystem;
using base::JsonWriter;
using base::Result;
using procedure::Procedure;

constexpr auto kInline = JsonWriter::Layout::kInline;

std::string range(const fuzzy::Variable& variable) {
  return base::formatNumber(variable.min) + " to " + base::formatNumber(variable.max) +
         (variable.unit == "1" ? "" : " " + variable.unit);
}

std::string_view directionOf(procedure::Direction direction) {
  return direction == procedure::Direction::kFalls ? "falls" : direction == procedure::Direction::kRises ? "rises" : "";
}

/// Places in the universe of `variable` where no term, or none above one half, holds: a person would find no word.
std::vector<std::string> gapsOf(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms,
                                const std::string& what) {
  constexpr int kPlaces = 2000;
  std::vector<std::string> out;
  std::optional<double> from;
  const auto close = [&](double to) {
    if (!from) return;
    out.push_back(what + ": no word has more than nothing from " + base::roundedNumber(*from) + " to " +
                  base::roundedNumber(to) + " " + variable.unit);
    from.reset();
  };
  double last = variable.min;
  for (int i = 0; i <= kPlaces; ++i) {
    const double x = variable.min + (variable.max - variable.min) * i / kPlaces;
    const bool covered = std::any_of(terms.begin(), terms.end(),
                                     [x](const auto& term) { return fuzzy::MembershipFunction::of(term)(x) > 0; });
    if (covered) close(last);
    if (!covered && !from) from = x;
    last = x;
  }
  close(variable.max);
  return out;
}

/// What is allowed and yet a person should look at.
std::vector<std::string> findingsOf(const Procedure& procedure) {
  std::vector<std::string> out;
  const auto add = [&](std::vector<std::string> more) { out.insert(out.end(), more.begin(), more.end()); };
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const fuzzy::Variable& input = procedure.inputs[i];
    if (i == procedure.way()) {
      for (const auto& set : procedure.way_terms) add(gapsOf(input, set.terms, input.id + ", " + set.id));
    } else {
      add(gapsOf(input, input.terms, input.id));
    }
  }
  add(gapsOf(procedure.output, procedure.output.terms, procedure.output.id));
  for (const std::string& language : procedure.languages) {
    std::vector<std::string> missing;
    for (const auto& [id, texts] : procedure.words) {
      if (!texts.contains(language)) missing.push_back(id);
    }
    if (!missing.empty()) out.push_back("words in " + language + " are missing for " + base::listed(missing));
    for (const auto& form : procedure.forms) {
      const auto known = questionnaires::languagesOf(procedure, form.id);
      if (std::find(known.begin(), known.end(), language) == known.end())
        out.push_back("no wording of " + form.id + " in " + language);
    }
  }
  for (const auto& picture : procedure.pictures) {
    if (picture.outline.empty())
      out.push_back(picture.file + ": no path 'outline' of the whole body, so the 3-D view does not show this picture");
  }
  for (const std::string& language : procedure.unreviewed)
    out.push_back("the words in " + language + " were read by nobody who speaks it at work");
  return out;
}

/// Reads the pack; `files` beside the named ones are findings too.
Result<session::ProcedurePtr> read(const std::string& pack, std::vector<std::string>& findings) {
  TACTUS_TRY(auto procedure, packNamed(pack));
  findings = findingsOf(*procedure);
  std::error_code ignored;
  if (!fs::is_directory(pack, ignored)) return procedure;
  for (const auto& entry : fs::recursive_directory_iterator(pack, ignored)) {
    const std::string path = entry.path().lexically_relative(pack).generic_string();
    const bool is_note = path.starts_with("README") || path.starts_with('.');
    if (entry.is_regular_file(ignored) && !procedure->files.contains(path) && !is_note)
      findings.push_back(path + ": the manifest does not name it, so it is no part of the pack");
  }
  return procedure;
}

/// Writes files by their path below `folder`; their whole paths.
template <class Files>
Result<std::vector<std::string>> writeBelow(const std::string& folder, const Files& files) {
  std::vector<std::string> out;
  for (const auto& [path, bytes] : files) {
    const auto target = fs::path(folder) / path;
    if (auto ok = base::makeFolder(target.parent_path().string()); !ok) return tl::unexpected(std::move(ok).error());
    if (auto ok = base::writeFileAtomically(target.string(), bytes); !ok) return tl::unexpected(std::move(ok).error());
    out.push_back(target.string());
  }
  return out;
}

std::string summary(const Procedure& procedure) {
  std::string out = procedure.titleIn("en") + " (" + procedure.id + ", version " + std::to_string(procedure.version) +
                    ")\n  " + std::to_string(procedure.inputs.size()) +
                    (procedure.inputs.size() == 1 ? " input, " : " inputs, ") +
                    std::to_string(procedure.wayInput().terms.size()) + " regions, " +
                    std::to_string(procedure.output.terms.size()) + " words for the force, ";
  std::vector<std::string> forms;
  for (const auto& form : procedure.forms)
    forms.push_back(form.id + " (" + std::to_string(form.items.size()) + " items)");
  out += base::joined(forms, ", ") + "\n";
  for (const fuzzy::TubeEvent& event : procedure.events)
    out += "  puncture: " + eventText(procedure.wayInput(), event) + "\n";
  out += "  languages " + base::joined(procedure.languages, ", ");
  return out + "\n  SHA-256 " + procedure.sha256 + "\n";
}

void writeSummary(const Procedure& procedure, JsonWriter& json) {
  json.key("id").value(procedure.id).key("pack_version").value(static_cast<std::size_t>(procedure.version));
  json.key("sha256").value(procedure.sha256).key("title").value(procedure.titleIn("en"));
  json.key("languages").values(procedure.languages).key("unreviewed_languages").values(procedure.unreviewed);
  json.key("inputs").beginArray();
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const fuzzy::Variable& input = procedure.inputs[i];
    json.beginObject(kInline).key("id").value(input.id).key("role").value(name(fuzzy::roleOf(input)));
    json.key("unit").value(input.unit).key("min").value(input.min).key("max").value(input.max);
    json.key("declared_direction").value(directionOf(procedure.input_notes[i].direction)).key("terms").beginArray();
    for (const auto& term : input.terms) json.value(term.id);
    json.endArray().endObject();
  }
  json.endArray().key("output").beginObject(kInline).key("id").value(procedure.output.id);
  json.key("max").value(procedure.output.max).key("terms").beginArray();
  for (const auto& term : procedure.output.terms) json.value(term.id);
  json.endArray().endObject().key("events").beginArray();
  for (const fuzzy::TubeEvent& event : procedure.events)
    json.beginObject(kInline).key("term").value(event.term).key("share").value(event.share).endObject();
  json.endArray().key("forms").beginArray();
  for (const auto& form : procedure.forms) {
    json.beginObject(kInline).key("id").value(form.id).key("items").value(form.items.size()).endObject();
  }
  json.endArray();
}

std::string termsText(const std::vector<fuzzy::Term>& terms) {
  std::string out;
  for (const auto& term : terms) {
    std::vector<std::string> points;
    for (const double point : term.points) points.push_back(base::formatNumber(point));
    out += "      " + term.id + " (" + term.label + ")  " + base::joined(points, " ") + "\n";
  }
  return out;
}

std::string details(const Procedure& procedure) {
  std::string out = summary(procedure) + "\n" + procedure.about + "\n\nInputs\n";
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const fuzzy::Variable& input = procedure.inputs[i];
    const auto direction = directionOf(procedure.input_notes[i].direction);
    out += "  " + input.id + " (" + input.label + "), " + std::string(name(fuzzy::roleOf(input))) + ", " +
           range(input) + (direction.empty() ? "" : ", the force " + std::string(direction)) + "\n" +
           termsText(input.terms);
    if (i != procedure.way()) continue;
    for (std::size_t s = 1; s < procedure.way_terms.size(); ++s)
      out += "    or, " + procedure.way_terms[s].id + " (" + procedure.way_terms[s].label + ")\n" +
             termsText(procedure.way_terms[s].terms);
  }
  out += "Force\n  " + procedure.output.id + ", " + range(procedure.output) + "\n" + termsText(procedure.output.terms);
  for (const auto& form : procedure.forms) {
    out += "Form " + form.id + "\n";
    const auto asked = questionnaires::questionnaire(procedure, form.id, procedure.languages.front());
    for (std::size_t i = 0; i < form.items.size(); ++i)
      out += "  " + std::to_string(form.items[i].number) + "  " + (asked ? asked->questions[i].text : "") + "\n";
  }
  return out;
}

/// The texts of the participant's screens in the languages of the pack, as a table.
std::string textTable(const Procedure& procedure) {
  std::string out = "id\t" + base::joined(procedure.languages, "\t") + "\n";
  std::vector<std::map<std::string, std::string>> by_language;
  for (const std::string& language : procedure.languages)
    by_language.push_back(webform::screenTexts(procedure, language));
  for (const auto& [id, text] : by_language.front()) {
    out += id;
    for (const auto& texts : by_language) {
      const auto found = texts.find(id);
      out += "\t" + (found == texts.end() ? std::string() : found->second);
    }
    out += "\n";
  }
  return out;
}

}  // namespace

Result<session::ProcedurePtr> packNamed(const std::string& pack) {
  std::error_code ignored;
  if (!bundle::isZipName(pack) || !fs::is_regular_file(pack, ignored)) return session::readPack(pack);
  TACTUS_TRY(const auto files, bundle::unzipped(pack));
  return session::readPack(procedure::PackFiles(files.begin(), files.end()), pack);
}

Result<Output> packNew(const PackOptions& options) {
  std::error_code ignored;
  if (fs::exists(options.pack, ignored)) {
    return base::inFile({base::ErrorCode::kIo, {}, {}, "something of this name", "the name of a new folder"},
                        options.pack);
  }
  TACTUS_TRY(const auto files, writeBelow(options.pack, examplePack()));
  if (options.json) {
    JsonWriter json;
    json.beginObject().key("folder").value(options.pack).key("files").values(files).endObject();
    return Output{json.text(), {}};
  }
  return Output{"Made a pack to begin with in " + base::oneLine(options.pack) +
                    ": change it, and look at it again with `tactus pack check`\n",
                {}};
}

Result<Output> packCheck(const PackOptions& options) {
  std::vector<std::string> findings;
  TACTUS_TRY(const auto procedure, read(options.pack, findings));
  if (options.json) {
    JsonWriter json;
    json.beginObject();
    writeSummary(*procedure, json);
    json.key("findings").values(findings).endObject();
    return Output{json.text(), {}};
  }
  std::string text = summary(*procedure) + "  findings " + std::to_string(findings.size()) + "\n";
  for (const auto& finding : findings) text += "    " + base::oneLine(finding) + "\n";
  return Output{std::move(text), {}};
}

Result<Output> packShow(const PackOptions& options) {
  if (options.pack.empty()) {
    std::string text;
    JsonWriter json;
    json.beginObject().key("procedures").beginArray();
    for (const std::string& id : procedure::builtInIds()) {
      const auto carried = procedure::builtIn(id);
      text += id + "  " + carried->titleIn("en") + "\n";
      json.beginObject(kInline).key("id").value(id).key("title").value(carried->titleIn("en")).endObject();
    }
    json.endArray().endObject();
    return Output{options.json ? json.text() : text, {}};
  }
  std::vector<std::string> findings;
  TACTUS_TRY(const auto procedure, read(options.pack, findings));
  if (options.texts) return Output{textTable(*procedure), {}, true};
  if (!options.json) return Output{details(*procedure), {}};
  JsonWriter json;
  json.beginObject();
  writeSummary(*procedure, json);
  json.key("about").value(procedure->about).key("items").beginArray();
  for (const auto& form : procedure->forms) {
    for (const auto& item : form.items) {
      json.beginObject(kInline).key("form").value(form.id).key("number").value(item.number).key("if").beginObject();
      for (const auto& condition : item.conditions) json.key(condition.input).value(condition.term);
      json.endObject().endObject();
    }
  }
  json.endArray().endObject();
  return Output{json.text(), {}};
}

Result<Output> packPreview(const PackOptions& options) {
  std::vector<std::string> findings;
  TACTUS_TRY(const auto procedure, read(options.pack, findings));
  std::vector<std::pair<std::string, std::string>> files;
  session::StudyProtocol protocol;
  TACTUS_TRY(protocol, session::firstProtocol(procedure));
  for (const auto& form : procedure->forms) {
    protocol.settings.form = form.id;
    TACTUS_TRY(const auto content, webform::formContent({}, procedure->titleIn("en"), protocol, {}));
    files.emplace_back(form.id + ".html", webform::webPage(content));
    for (const auto& language : content.languages) {
      TACTUS_TRY(auto survey, questionnaires::survey(*procedure, form.id, language.id));
      survey.opening = webform::openingOf(content, language);
      files.emplace_back("print/" + form.id + "." + language.id + ".html",
                         report::printedForm(survey, webform::regionsPicture(*procedure, form)));
    }
  }
  const auto pictures = webform::pictures(*procedure);
  for (const auto& picture : pictures) {
    for (const auto& region : picture.regions) {
      files.emplace_back("pictures/" + std::string(picture.posture) + "_" + region.id + ".svg",
                         webform::pictureFile(picture, {{region.id, ""}}));
    }
  }
  TACTUS_TRY(const auto paths, writeBelow(options.out, files));
  if (options.json) {
    JsonWriter json;
    json.beginObject().key("id").value(procedure->id).key("files").values(paths).endObject();
    return Output{json.text(), std::move(findings)};
  }
  return Output{"Wrote " + std::to_string(paths.size()) + " files to " + base::oneLine(options.out) + "\n",
                std::move(findings)};
}

}  // namespace tactus::cli
