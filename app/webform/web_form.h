// What the form of a study says, for every medium, in each language of the study; and the form as a web page.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/study_protocol.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"
#include "questionnaires/questionnaire.h"
#include "questionnaires/questionnaire_run.h"
#include "questionnaires/survey.h"

namespace tactus::webform {

/// The form in one language.
struct FormLanguage {
  std::string id;                            ///< `zh-Hant`
  questionnaires::Questionnaire asked;       ///< the study's form
  std::string question;                      ///< with which each item ends; empty where items are worded as a whole
  questionnaires::Questionnaire scale;       ///< what a clinical teacher thinks of the simulator
  std::vector<std::string> consent;          ///< paragraphs
  std::map<std::string, std::string> words;  ///< by id, of the participant's screens and of this page
};

struct FormContent {
  std::shared_ptr<const procedure::Procedure> procedure;  ///< of the study; null: the default one
  study::RecordId study;
  std::string study_name;
  std::string form;  ///< form id
  int form_version = 1;
  std::string wording;
  std::string consent_version;  ///< empty: the study has no protocol, so the form is for trying only
  std::string contact;
  int minutes = 0;                                                      ///< about how long it takes
  questionnaires::ItemOrder order = questionnaires::ItemOrder::kFixed;  ///< as the protocol wants
  std::vector<FormLanguage> languages;

  /// SHA-256 of what participants agree to and are asked: study, form, wording, languages, the study's consent texts,
  /// items and answers. It names the form in answer files, and stays when only other words of the page change.
  std::string sha256;

  const FormLanguage* language(std::string_view id) const;
  const procedure::Procedure& about() const { return procedure::orDefault(procedure); }
};

/// The form of a study under `protocol`. `wording`: empty, the form's usual one. Languages in which the form is not
/// written in these words are left out. Returns an error if none remains.
base::Result<FormContent> formContent(const study::RecordId& study, const std::string& name,
                                      const session::StudyProtocol& protocol, const std::string& wording);

/// The same for the current protocol of `file`, or the default one.
base::Result<FormContent> currentForm(const store::StudyFile& file, const std::string& wording);

/// All forms that the study can have given to participants: of each record of its protocol and each wording, and those
/// before it had one.
base::Result<std::vector<FormContent>> formsOf(const store::StudyFile& file);

/// The ids of the sentences that explain the words of the procedure's forms: force, then each condition.
std::vector<std::string> glossaryOf(const procedure::Procedure& procedure);

/// The texts of the participant's screens in `language`, by id: the pack's own over those of the program. A text that
/// the language lacks is in the first language of the pack, or in English.
std::map<std::string, std::string> screenTexts(const procedure::Procedure& procedure, const std::string& language);

/// The consent, profile and picture of the form in one language, as the parts that survey systems and paper show before
/// the items.
questionnaires::SurveyOpening openingOf(const FormContent& content, const FormLanguage& language);

// The form as one web page: no network, no other file, every language of the study.

/// The page, in HTML. It keeps progress in the browser under the form's hash, gives an answer file (answers.h) at
/// the end and prints as a form on paper.
std::string webPage(const FormContent& content);

/// What to do with the page, for the researcher, in plain text.
std::string webReadme(const FormContent& content);

}  // namespace tactus::webform
