// The form of a study as one web page: no network, no other file, every language of the study.
#pragma once

#include <string>

#include "app/webform/form_content.h"

namespace tactus::webform {

/// The page, in HTML. It keeps progress in the browser under the form's hash, gives an answer file (answer_file.h) at
/// the end and prints as a form on paper.
std::string webPage(const FormContent& content);

/// What to do with the page, for the researcher, in plain text.
std::string webReadme(const FormContent& content);

}  // namespace tactus::webform
