// A form on paper: an HTML page to print and fill in with a pen.
#pragma once

#include <string>

#include "questionnaires/survey.h"

namespace tactus::report {

/// The page. Each choice of each question is a box; the code of the participant is written by hand.
std::string printedForm(const questionnaires::Survey& survey);

}  // namespace tactus::report
