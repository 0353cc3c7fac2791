#include "app/workbench/study/study_review.h"

#include <memory>
#include <utility>

#include "app/session/study_view.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/study/review_notes.h"
#include "core/store/model_versions.h"

namespace tactus::workbench {
namespace {

// The text of the version that `version` was made of by edits.
std::optional<std::string> firstText(const store::StudyFile& file, const study::RecordId& version) {
  const auto before = store::modelAncestors(file, version);
  if (!before) return std::nullopt;
  const auto first = store::modelVersion(file, before->empty() ? version : before->back().id);
  return first ? std::optional(first->text) : std::nullopt;
}

}  // namespace

StudyReview::StudyReview(StudyWorker& worker, CallQueue& answers, QObject* parent)
    : QObject(parent), worker_(worker), answers_(answers) {}

void StudyReview::begin(const std::optional<study::RecordId>& model) {
  clear();
  busy_ = true;
  worker_.post([this, number = newest_, model](StudyWorker::Desk& desk) {
    if (!desk.file) return;
    auto view = session::studyForElicitation(*desk.file);
    if (!view) {
      // Two persons with one code, or a record that is damaged: no build is possible.
      const QString sentence = text(view.error().message());
      answers_.post([this, number, sentence] {
        if (number == newest_) take({{{sentence, {}}}, {}});
      });
      return;
    }
    const auto read = std::make_shared<const ReadStudy>(ReadStudy{std::move(view->study), std::move(view->notes)});
    const auto first = model ? firstText(*desk.file, *model) : std::nullopt;
    answers_.post([this, number, read, first] {
      if (number != newest_) return;
      background_.run([this, read, first](const std::stop_token&) -> Background::Deliver {
        return [this, notes = reviewed(*read, first)] { take(notes); };
      });
    });
  });
}

void StudyReview::set(BuildNotes notes) {
  ++newest_;
  background_.drop();
  take(std::move(notes));
}

void StudyReview::take(BuildNotes notes) {
  busy_ = false;
  if (notes == notes_) return;
  notes_ = std::move(notes);
  emit changed();
}

}  // namespace tactus::workbench
