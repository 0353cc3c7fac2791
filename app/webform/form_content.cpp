#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/session/profile_questions.h"
#include "app/session/study_procedure.h"
#include "app/webform/web_form.h"
#include "core/base/check.h"
#include "core/base/files/checksums.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/store/study_info.h"
#include "core/store/study_records.h"

namespace tactus::webform {

std::string_view screenWords();  // app/workbench/participant/kit/strings.tsv
std::string_view webWords();     // words.tsv

namespace {

using base::Result;

constexpr int kMinuteStep = 5;
constexpr std::string_view kScale = "usability-v1";

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> out;
  for (std::size_t from = 0; from <= text.size();) {
    const auto to = std::min(text.find(separator, from), text.size());
    out.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return out;
}

/// Adds the texts of a table `id, en, zh-Hant, …` in `language`, or in English where the table has no such language.
void addWords(std::string_view table, const std::string& language, std::map<std::string, std::string>& words) {
  std::size_t column = 0;
  for (const std::string_view line : split(table, '\n')) {
    if (line.empty() || line.front() == '#') continue;
    const auto fields = split(line, '\t');
    if (column == 0) {
      column = static_cast<std::size_t>(std::find(fields.begin(), fields.end(), language) - fields.begin());
      if (column == fields.size()) column = 1;
      continue;
    }
    words.emplace(fields[0], fields[column]);
  }
}

std::string textIn(const std::map<std::string, std::string>& texts, const std::string& language) {
  const auto found = texts.find(language);
  return found == texts.end() ? std::string() : std::string(base::trimmed(found->second));
}

void addLines(const std::string& text, std::vector<std::string>& out) {
  for (const std::string_view line : split(text, '\n')) {
    if (!base::trimmed(line).empty()) out.emplace_back(base::trimmed(line));
  }
}

/// As on the consent screen, of a form without a device. What only the page does is left to it.
std::vector<std::string> consentOf(const FormContent& content, const session::StudyProtocol& protocol,
                                   const FormLanguage& language) {
  std::vector<std::string> out;
  const std::string statements = textIn(protocol.statements, language.id);
  if (statements.empty()) {
    const auto add = [&](const char* id, const std::string& value = {}) {
      out.push_back(base::replaced(language.words.at(id), {{"%1", value}}));
    };
    add(content.form == kScale ? "u.purpose" : "con.purpose");
    add("web.what");
    add("con.minutes", std::to_string(content.minutes));
    add("con.voluntary");
    add("con.stop");
    add("web.data");
    add("con.withdraw");
  } else {
    addLines(statements, out);
  }
  out.push_back(language.words.at("web.sends"));
  addLines(textIn(protocol.consent, language.id), out);
  if (!protocol.contact.empty())
    out.push_back(base::replaced(language.words.at("con.contact"), {{"%1", protocol.contact}}));
  return out;
}

std::string digestOf(const FormContent& content, const session::StudyProtocol& protocol) {
  base::JsonWriter json;
  json.beginObject().key("study").value(toText(content.study)).key("form").value(content.form);
  json.key("form_version").value(content.form_version).key("wording").value(content.wording);
  json.key("consent_version").value(content.consent_version).key("languages").beginArray();
  for (const FormLanguage& language : content.languages) {
    json.beginObject().key("language").value(language.id).key("consent").value(textIn(protocol.consent, language.id));
    json.key("instructions").value(language.asked.instructions).key("items").beginArray();
    for (const auto& question : language.asked.questions) json.value(question.number).value(question.text);
    json.endArray().key("choices").beginArray();
    for (const auto& choice : language.asked.choices) json.value(choice.value).value(choice.label);
    json.endArray().endObject();
  }
  return base::sha256(json.endArray().endObject().text());
}

}  // namespace

const FormLanguage* FormContent::language(std::string_view id) const {
  const auto found =
      std::find_if(languages.begin(), languages.end(), [&](const FormLanguage& one) { return one.id == id; });
  return found == languages.end() ? nullptr : &*found;
}

Result<FormContent> formContent(const study::RecordId& study, const std::string& name,
                                const session::StudyProtocol& protocol, const std::string& wording) {
  FormContent out;
  out.procedure = protocol.settings.procedure;
  const procedure::Procedure& about = out.about();
  out.study = study;
  out.study_name = name;
  out.form = protocol.settings.form;
  const auto wordings = questionnaires::wordingsOf(about, out.form);
  if (wordings.empty()) {
    return base::fail(base::ErrorCode::kReference, "form", base::quoted(out.form),
                      "one of " + base::joined(questionnaires::questionnaireIds(about), ", "));
  }
  out.wording = wording.empty() ? wordings.front() : wording;
  out.consent_version = protocol.consent_version;
  out.contact = std::string(base::trimmed(protocol.contact));
  out.order = protocol.settings.item_order;
  session::SessionSettings settings = protocol.settings;
  settings.blocks = {session::Block::kForm};
  out.minutes = static_cast<int>(std::ceil(session::expectedMinutes(settings) / kMinuteStep)) * kMinuteStep;
  const auto known = questionnaires::languagesOf(about, out.form, out.wording);
  for (const std::string& id : protocol.languages) {
    if (std::find(known.begin(), known.end(), id) == known.end()) continue;
    FormLanguage language;
    language.id = id;
    TACTUS_TRY(language.asked, questionnaires::questionnaire(about, out.form, id, out.wording));
    const auto scales = questionnaires::languagesOf(about, kScale);
    const bool has_scale = std::find(scales.begin(), scales.end(), id) != scales.end();
    TACTUS_TRY(language.scale, questionnaires::questionnaire(about, kScale, has_scale ? id : "en"));
    if (out.form != kScale && out.wording != questionnaires::kPublishedWording) {
      TACTUS_TRY(const auto plain, questionnaires::composedWording(about, out.form, id));
      language.question = plain.question;
    }
    language.words = screenTexts(about, id);
    language.consent = consentOf(out, protocol, language);
    out.form_version = language.asked.version;
    out.languages.push_back(std::move(language));
  }
  if (out.languages.empty()) {
    return base::fail(
        base::ErrorCode::kReference, "--wording",
        base::quoted(out.wording) + " in " + base::joined(protocol.languages, ", "),
        known.empty() ? "a wording of " + base::quoted(out.form) : "a study in " + base::joined(known, " or "));
  }
  out.sha256 = digestOf(out, protocol);
  return out;
}

Result<FormContent> currentForm(const store::StudyFile& file, const std::string& wording) {
  TACTUS_TRY(const auto info, store::studyInfo(file));
  TACTUS_TRY(const auto protocol, session::currentProtocol(file));
  return formContent(info.id, info.name, protocol.value_or(session::StudyProtocol{}), wording);
}

Result<std::vector<FormContent>> formsOf(const store::StudyFile& file) {
  TACTUS_TRY(const auto info, store::studyInfo(file));
  TACTUS_TRY(const auto records, store::protocols(file));
  std::vector<session::StudyProtocol> protocols = {session::StudyProtocol{}};
  for (const auto& record : records) {
    TACTUS_TRY(auto protocol, session::protocolOf(file, record));
    protocols.push_back(std::move(protocol));
  }
  std::vector<FormContent> out;
  std::set<std::string> seen;
  for (const auto& protocol : protocols) {
    for (const std::string& wording : questionnaires::wordingsOf(protocol.settings.about(), protocol.settings.form)) {
      auto one = formContent(info.id, info.name, protocol, wording);
      // A wording that none of the study's languages has gives no form.
      if (one && seen.insert(one->sha256).second) out.push_back(*std::move(one));
    }
  }
  return out;
}

std::vector<std::string> glossaryOf(const procedure::Procedure& procedure) {
  std::vector<std::string> out = {"glo.force"};
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    if (i != procedure.way()) out.push_back("glo." + procedure.inputs[i].id);
  }
  return out;
}

std::map<std::string, std::string> screenTexts(const procedure::Procedure& procedure, const std::string& language) {
  std::map<std::string, std::string> out;
  addWords(screenWords(), language, out);
  addWords(webWords(), language, out);
  for (const auto& [id, texts] : procedure.words) {
    for (const std::string& wanted : {language, procedure.languages.front()}) {
      const auto text = texts.find(wanted);
      if (text == texts.end()) continue;
      out[id] = text->second;
      break;
    }
  }
  // What is inserted stands in the texts as this.
  const std::string tool = out.contains("tool") ? out.at("tool") : std::string();
  for (auto& [id, text] : out) text = base::replaced(std::move(text), {{"%tool", tool}});
  return out;
}

questionnaires::SurveyOpening openingOf(const FormContent& content, const FormLanguage& language) {
  questionnaires::SurveyOpening out;
  out.consent_title = language.words.at("con.title");
  // Without a protocol nobody has said to what participants agree.
  if (!content.consent_version.empty()) out.consent = language.consent;
  std::erase(out.consent, language.words.at("web.sends"));
  out.consent_version = content.consent_version;
  out.agree = language.words.at("con.agree");
  out.decline = language.words.at("con.decline");
  out.profile_title = language.words.at("you.title");
  for (const session::ProfileQuestion& asked : session::profileQuestions()) {
    if (asked.field == "comfort") continue;  // of a session with a device
    questionnaires::SurveyOpening::Question question{
        std::string(asked.field), language.words.at(std::string(asked.words)), {}};
    for (const session::ProfileOffer& offer : asked.offers)
      question.offers.push_back({std::string(offer.stored), language.words.at(std::string(offer.words))});
    out.profile.push_back(std::move(question));
  }
  out.picture = language.words.at("glo.way");
  for (const std::string& id : glossaryOf(content.about())) out.glossary.push_back(language.words.at(id));
  return out;
}

}  // namespace tactus::webform
