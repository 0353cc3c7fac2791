// A survey as files that hospitals' survey systems read.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "questionnaires/survey.h"

namespace tactus::questionnaires {

/// The data dictionary (CSV) of a new REDCap project: the record id, a descriptive row, and each matrix as radio rows.
/// The 18 columns are those of REDCap 13.
std::string redcapDictionary(const Survey& survey);

/// The code under which LimeSurvey knows a language: `zh-Hant-TW` for `zh-Hant`, otherwise the same.
std::string limeSurveyLanguage(std::string_view language);

/// A survey structure for LimeSurvey (tab-separated), the first language as its base. All are of one form.
std::string limeSurveyStructure(std::span<const Survey> languages);

}  // namespace tactus::questionnaires
