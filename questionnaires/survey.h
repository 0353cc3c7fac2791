// A form for people who answer it outside of this program: fields, codes and matrices, in one language.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "questionnaires/questionnaire.h"

namespace tactus::questionnaires {

struct SurveyChoice {
  std::string code;    ///< at most 5 characters, letters and digits
  std::string term;    ///< stored value; empty for the answer `cannot tell`
  std::string status;  ///< of an answer, as in answers.csv: `answered`, `cant_tell`
  std::string label;
};

struct SurveyField {
  std::string name;  ///< `q01`: the form's item number
  int item = 0;
  std::string text;
  std::vector<study::ItemCondition> conditions;  ///< none for a statement
};

/// Consecutive fields that share a condition (well lubricated, in five regions), shown as one table.
struct SurveyMatrix {
  std::string name;  ///< `m01`
  std::vector<SurveyField> fields;
};

/// What is shown and asked before the items; the same words as on the participant's screens.
struct SurveyOpening {
  struct Offer {
    std::string code;  ///< stored value: letters, digits and `_`
    std::string label;
  };
  struct Question {
    std::string name;  ///< of the field: `years`, `handedness`
    std::string text;
    std::vector<Offer> offers;
  };

  std::string consent_title;
  std::vector<std::string> consent;  ///< paragraphs; none: the study has no consent yet, and nothing asks for it
  std::string consent_version;
  std::string agree;
  std::string decline;
  std::string profile_title;
  std::vector<Question> profile;
  std::string picture;                ///< what the picture of the form shows
  std::vector<std::string> glossary;  ///< one sentence for each word that the items use
};

struct Survey {
  std::string form;  ///< form id
  int version = 1;
  std::string name;     ///< of files and instruments: a to z, 0 to 9, `_`; `ngt_force`, `ngt_force_published`
  std::string wording;  ///< id of the words
  std::string language;
  std::string title;
  std::string instructions;  ///< may be empty
  std::string code_label;    ///< `Participant code`
  std::vector<SurveyChoice> choices;
  std::vector<SurveyMatrix> matrices;
  std::optional<SurveyOpening> opening = {};  ///< nothing: the items alone
};

/// The form `form` of the procedure in `language`; `wording` as for `questionnaire`. Returns an error for an unknown
/// form, language or wording.
base::Result<Survey> survey(const procedure::Procedure& procedure, std::string_view form, std::string_view language,
                            std::string_view wording = {});

/// Two tables that lead from responses back to answers: `field,form,item` and one column per input; `code,term,status`.
std::string fieldTable(const Survey& survey);
std::string codeTable(const Survey& survey);

// A survey as files that hospitals' survey systems read.

/// The data dictionary (CSV) of a new REDCap project: the record id, a descriptive row, and each matrix as radio rows.
/// The 18 columns are those of REDCap 13.
std::string redcapDictionary(const Survey& survey);

/// The code under which LimeSurvey knows a language: `zh-Hant-TW` for `zh-Hant`, otherwise the same.
std::string limeSurveyLanguage(std::string_view language);

/// A survey structure for LimeSurvey (tab-separated), the first language as its base. All are of one form.
std::string limeSurveyStructure(std::span<const Survey> languages);

}  // namespace tactus::questionnaires
