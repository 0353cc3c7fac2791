#include "tests/fuzz/answers_fuzzer.h"

#include <vector>

#include "app/webform/answers.h"
#include "core/base/check.h"

namespace tactus::fuzz {

void fuzzAnswers(std::string_view bytes) {
  const auto answers = webform::parseAnswerFile(bytes, "fuzzed");
  if (!answers) {
    TACTUS_CHECK(!answers.error().wanted.empty() && answers.error().file == "fuzzed");
    return;
  }
  TACTUS_CHECK(webform::checkCodeOf(*answers).size() == 9);
  static const std::vector<webform::FormContent> kForms = {
      *webform::formContent(study::RecordId{}, "fuzzed", session::StudyProtocol{}, "")};
  const auto form = webform::formAnswered(*answers, kForms, "fuzzed");
  TACTUS_CHECK(form.has_value() || !form.error().wanted.empty());
}

}  // namespace tactus::fuzz
