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

StudyReview::StudyReview(StudyConnection& study, QObject* parent) : QObject(parent), study_(study) {}

void StudyReview::begin(const std::optional<study::RecordId>& model) {
  clear();
  busy_ = true;
  const auto closed = [this, number = newest_] {
    if (number == newest_) take({});
  };
  const auto read = [this, number = newest_, model](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto view = session::studyForElicitation(file);
    if (!view) {
      // Two persons with one code, or a record that is damaged: no build is possible.
      return [this, number, sentence = text(view.error().message())] {
        if (number == newest_) take({{{sentence, {}}}, {}});
      };
    }
    const auto study = std::make_shared<const ReadStudy>(ReadStudy{std::move(view->study), std::move(view->notes)});
    return [this, number, study, first = model ? firstText(file, *model) : std::nullopt] {
      if (number != newest_) return;
      background_.run([this, study, first](const std::stop_token&) -> Background::Deliver {
        return [this, notes = reviewed(*study, first)] { take(notes); };
      });
    };
  };
  study_.read(*this, read, closed);
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
