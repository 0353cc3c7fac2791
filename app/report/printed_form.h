// A form on paper: an HTML page to print and fill in with a pen.
#pragma once

#include <string>
#include <string_view>

#include "questionnaires/survey.h"

namespace tactus::report {

/// The page. Each choice of each question is a box; the code of the participant is written by hand. With the survey's
/// opening it begins with consent and profile, and each table asks for the code. `picture`: SVG text, may be empty.
std::string printedForm(const questionnaires::Survey& survey, std::string_view picture = {});

}  // namespace tactus::report
