#include <algorithm>
#include <array>
#include <cmath>

#include "app/session/profile_questions.h"
#include "app/webform/pictures.h"
#include "app/webform/web_form.h"
#include "core/base/check.h"
#include "core/base/json/json_writer.h"
#include "core/store/person_codes.h"

namespace tactus::webform {

// Embedded from page/.
std::string_view pageTemplate();
std::string_view screenStyle();
std::string_view paperStyle();
std::string_view kitScript();
std::string_view runScript();
std::string_view pictureScript();
std::string_view screensScript();
std::string_view finishScript();
std::string_view paperScript();
std::string_view startScript();

namespace {

using base::JsonWriter;
constexpr auto kInline = JsonWriter::Layout::kInline;

/// The texts of the participant's screens that the page uses, by the beginning of their ids.
constexpr std::array<std::string_view, 15> kUsed = {"nav.", "wel.", "code.", "con.", "you.", "glo.", "rev.", "thx.",
                                                    "err.", "a.",   "s.",    "u.",   "w.",   "acc.", "web."};

void addWords(const FormLanguage& language, JsonWriter& json) {
  json.key("words").beginObject();
  for (const auto& [id, text] : language.words) {
    const std::string_view name = id;
    if (std::any_of(kUsed.begin(), kUsed.end(), [&](std::string_view used) { return name.starts_with(used); }))
      json.key(id).value(text);
  }
  json.endObject();
}

/// `text` without the question with which it ends.
std::string situationOf(const std::string& text, const std::string& question) {
  if (question.empty() || !text.ends_with(question)) return text;
  std::string out = text.substr(0, text.size() - question.size());
  while (out.ends_with(' ')) out.pop_back();
  return out;
}

void addLanguage(const FormLanguage& language, JsonWriter& json) {
  json.beginObject().key("id").value(language.id).key("title").value(language.asked.title);
  json.key("instructions").value(language.asked.instructions).key("question").value(language.question);
  json.key("items").beginObject();
  for (const auto& question : language.asked.questions)
    json.key(std::to_string(question.number)).value(situationOf(question.text, language.question));
  json.endObject().key("terms").beginObject();
  for (const auto& choice : language.asked.choices) json.key(choice.value).value(choice.label);
  json.endObject().key("scale").beginObject(kInline);
  for (const auto& question : language.scale.questions) json.key(std::to_string(question.number)).value(question.text);
  json.endObject().key("points").beginObject(kInline);
  for (const auto& choice : language.scale.choices) json.key(choice.value).value(choice.label);
  json.endObject().key("consent").values(language.consent);
  addWords(language, json);
  json.endObject();
}

/// The place of the word among those of its input, from 1.
std::size_t levelOf(const procedure::Procedure& procedure, const study::ItemCondition& condition) {
  for (const auto& input : procedure.inputs) {
    if (input.id != condition.input) continue;
    const auto term =
        std::find_if(input.terms.begin(), input.terms.end(), [&](const auto& one) { return one.id == condition.term; });
    return static_cast<std::size_t>(term - input.terms.begin()) + 1;
  }
  return 1;
}

/// Of each item: its number and, where it has conditions, what it is about.
void addItems(const FormContent& content, JsonWriter& json) {
  const study::Form* const rules = content.about().form(content.form);
  json.key("items").beginArray();
  for (const auto& question : content.languages.front().asked.questions) {
    json.beginObject(kInline).key("number").value(question.number).key("block").value(question.block);
    for (const study::FormItem& item : rules == nullptr ? std::vector<study::FormItem>() : rules->items) {
      if (item.number != question.number) continue;
      for (const study::ItemCondition& condition : item.conditions) {
        if (condition.input == content.about().wayInput().id) {
          json.key("region").value(condition.term);
        } else {
          json.key("input").value(condition.input).key("term").value(condition.term);
          json.key("posture")
              .value(postureOf(content.about(), condition))
              .key("level")
              .value(levelOf(content.about(), condition));
        }
      }
    }
    json.endObject();
  }
  json.endArray();
}

/// What the words of the form are explained by, its regions, and how levels are drawn.
void addGlossary(const FormContent& content, JsonWriter& json) {
  const procedure::Procedure& about = content.about();
  const study::Form* const rules = about.form(content.form);
  json.key("glossary").values(glossaryOf(about));
  json.key("regions").values(rules == nullptr ? std::vector<std::string>() : procedure::regionsOf(about, *rules));
  json.key("usual").value(pictures(about).front().posture).key("signs").beginObject(kInline);
  for (std::size_t i = 0; i < about.inputs.size(); ++i) {
    const auto picture = about.input_notes[i].picture;
    if (i == about.way() || picture == procedure::LevelPicture::kPose) continue;
    json.key(about.inputs[i].id)
        .beginObject()
        .key("shape")
        .value(picture == procedure::LevelPicture::kDrops    ? "drop"
               : picture == procedure::LevelPicture::kArrows ? "arrow"
                                                             : "bar");
    json.key("of").value(about.inputs[i].terms.size()).endObject();
  }
  json.endObject();
}

double tenth(double value) { return std::round(value * 10) / 10; }

void addPictures(const procedure::Procedure& procedure, JsonWriter& json) {
  json.key("pictures").beginObject();
  for (const Picture& picture : pictures(procedure)) {
    json.key(picture.posture).beginObject().key("drawing").value(picture.drawing);
    const auto box = [&](const char* name, const std::array<double, 4>& values) {
      json.key(name).beginArray(kInline);
      for (const double value : values) json.value(tenth(value));
      json.endArray();
    };
    box("box", picture.box);
    box("near", picture.near);
    json.key("tube").beginArray(kInline);
    for (const Point& point : picture.tube) json.value(tenth(point.x)).value(tenth(point.y));
    json.endArray().key("regions").beginObject();
    for (const PictureRegion& region : picture.regions) {
      json.key(region.id).beginObject(kInline).key("outline").value(region.outline).key("end").value(region.end);
      json.key("far").value(region.far);
      json.key("tip").beginArray(kInline).value(tenth(region.tip.x)).value(tenth(region.tip.y)).endArray().endObject();
    }
    json.endObject().endObject();
  }
  json.endObject();
}

void addProfile(JsonWriter& json) {
  json.key("profile").beginArray();
  for (const session::ProfileQuestion& question : session::profileQuestions()) {
    if (question.field == "comfort") continue;  // of a session with a device
    json.beginObject(kInline).key("field").value(std::string(question.field));
    json.key("words").value(std::string(question.words)).key("may_not_say").value(question.may_not_say);
    json.key("offers").beginArray(kInline);
    for (const session::ProfileOffer& offer : question.offers) {
      json.beginObject(kInline).key("stored").value(std::string(offer.stored));
      json.key("words").value(std::string(offer.words)).endObject();
    }
    json.endArray().endObject();
  }
  json.endArray();
}

void addCodes(JsonWriter& json) {
  const store::PersonCodes codes(0);
  const auto add = [&](const char* name, const std::vector<std::string_view>& words) {
    json.key(name).values(std::vector<std::string>(words.begin(), words.end()));
  };
  json.key("codes").beginObject();
  add("first", codes.firstWords());
  add("second", codes.secondWords());
  json.endObject();
}

std::string contentJson(const FormContent& content) {
  JsonWriter json;
  json.beginObject().key("study").value(toText(content.study)).key("study_name").value(content.study_name);
  json.key("form").value(content.form).key("form_version").value(content.form_version);
  json.key("wording").value(content.wording).key("form_sha256").value(content.sha256);
  json.key("consent_version").value(content.consent_version).key("contact").value(content.contact);
  json.key("minutes").value(content.minutes).key("order").value(name(content.order));
  addItems(content, json);
  addProfile(json);
  json.key("languages").beginArray();
  for (const FormLanguage& language : content.languages) addLanguage(language, json);
  json.endArray();
  addCodes(json);
  addGlossary(content, json);
  addPictures(content.about(), json);
  return json.endObject().text();
}

/// JSON inside of a script: no text in it can end the script.
std::string forScript(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

void put(std::string& page, std::string_view place, std::string_view text) {
  const auto at = page.find(place);
  TACTUS_CHECK(at != std::string::npos);
  page.replace(at, place.size(), text);
}

}  // namespace

std::string webPage(const FormContent& content) {
  const FormLanguage& first = content.languages.front();
  std::string without_script;
  for (const FormLanguage& language : content.languages)
    without_script += "<p lang=\"" + language.id + "\">" + escaped(language.words.at("web.no_script")) + "</p>";
  std::string script;
  for (const std::string_view part :
       {kitScript(), runScript(), pictureScript(), screensScript(), finishScript(), paperScript(), startScript()})
    script += part;
  std::string page(pageTemplate());
  // The data come last: no text of the study is searched for a place.
  put(page, "{{language}}", first.id);
  put(page, "{{title}}", escaped(first.asked.title));
  put(page, "{{style}}", std::string(screenStyle()) + std::string(paperStyle()));
  put(page, "{{noscript}}", without_script);
  put(page, "{{script}}", script);
  put(page, "{{content}}", forScript(contentJson(content)));
  return page;
}

std::string webReadme(const FormContent& content) {
  std::string languages;
  for (const FormLanguage& language : content.languages) languages += (languages.empty() ? "" : ", ") + language.id;
  std::string out = "The form of the study \"" + content.study_name + "\" as a web page\n\n";
  out += "form.html  the whole form: consent, profile, questions, pictures. Languages: " + languages +
         ".\n\n"
         "1. Give form.html to the participants: on a USB stick, by e-mail, or from a folder that all can read.\n"
         "   It opens in the browser of a computer or phone, needs no network and sends nothing.\n"
         "2. A participant can close the page and go on later in the same browser.\n"
         "3. At the end the page saves a file CODE.tactus-answers.json and shows a check code. Ask for both.\n"
         "   A text that was copied from the page instead is the same: save it as a file with this ending.\n"
         "4. Read the files into the study, any number at once. A file that is read twice changes nothing:\n"
         "     tactus study import STUDY.tactus *.tactus-answers.json\n"
         "5. On paper: open form.html and print it, on A4 or Letter.\n\n";
  out += "Form " + content.form + ", wording " + content.wording + ", consent version " +
         (content.consent_version.empty() ? std::string("none: for trying only") : content.consent_version) +
         ".\nSHA-256 of what is asked: " + content.sha256 + "\n";
  return out;
}

}  // namespace tactus::webform
