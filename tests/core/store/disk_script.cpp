#include "tests/core/store/disk_script.h"

#include "core/store/entries.h"
#include "core/store/study_info.h"

namespace tactus::store {

DiskScript::Kind DiskScript::kindOf(int number) {
  if (number % 5 == 2) return Kind::kStroke;
  return number % 5 == 4 ? Kind::kJudgement : Kind::kAnswer;
}

base::Result<void> DiskScript::write(StudyFile& file, int number) const {
  auto samples = sampleFor(number);
  switch (kindOf(number)) {
    case Kind::kStroke: return append(file, samples.stroke(session_, samples_));
    case Kind::kJudgement: return append(file, samples.judgement(session_));
    case Kind::kAnswer: break;
  }
  return append(file, samples.answer(session_, number));
}

int DiskScript::intactRecords(const StudyFile& file, std::string& complaint) const {
  const Selection all = {.session = session_, .history = true};
  const auto found_answers = answers(file, all);
  const auto found_strokes = strokes(file, all);
  const auto found_judgements = judgements(file, all);
  const auto findings = checkStudy(file);
  if (!found_answers || !found_strokes || !found_judgements || !findings) {
    complaint = "the study cannot be read";
    return -1;
  }
  if (!findings->empty()) complaint = findings->front();

  // A gap would shift everything behind it, so comparing one by one finds what is lost, doubled or out of order.
  const auto count = static_cast<int>(found_answers->size() + found_strokes->size() + found_judgements->size());
  std::size_t answer = 0;
  std::size_t stroke = 0;
  std::size_t judgement = 0;
  for (int number = 0; number < count; ++number) {
    auto samples = sampleFor(number);
    bool same = false;
    switch (kindOf(number)) {
      case Kind::kAnswer:
        same = answer < found_answers->size() && (*found_answers)[answer] == samples.answer(session_, number);
        ++answer;
        break;
      case Kind::kStroke:
        same = stroke < found_strokes->size() && (*found_strokes)[stroke] == samples.stroke(session_, samples_);
        ++stroke;
        break;
      case Kind::kJudgement:
        same = judgement < found_judgements->size() && (*found_judgements)[judgement] == samples.judgement(session_);
        ++judgement;
        break;
    }
    if (!same) complaint = "record " + std::to_string(number) + " of " + std::to_string(count) + " is not as written";
  }
  return count;
}

}  // namespace tactus::store
