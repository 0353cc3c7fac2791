#include "app/workbench/study/version_texts.h"

#include <QPointer>
#include <algorithm>
#include <utility>

#include "core/store/model_versions.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kAtOnce = 20;  // few, so that edits are stored in between

}  // namespace

VersionTexts::VersionTexts(StudyConnection& study, QObject* parent)
    : QObject(parent), study_(study), shelf_(std::make_shared<Shelf>()) {}

void VersionTexts::begin(const std::vector<study::ModelVersion>& versions, std::size_t most_ahead_bytes) {
  shelf_ = std::make_shared<Shelf>();
  shelf_->most_bytes = most_ahead_bytes;
  for (auto version = versions.rbegin(); version != versions.rend(); ++version) shelf_->ahead.push_back(version->id);
  readAhead(0);
}

EditController::VersionReader VersionTexts::reader() {
  return [texts = QPointer(this), shelf = shelf_](const study::RecordId& id) -> Read {
    const auto found = shelf->read.find(id);
    if (found != shelf->read.end()) return found->second;
    if (texts && texts->shelf_ == shelf) texts->ask(id);
    return base::fail(base::ErrorCode::kIo, "model version " + study::toText(id), "not read from the study yet",
                      "another try in a moment");
  };
}

void VersionTexts::ask(const study::RecordId& id) {
  if (shelf_->asked.insert(id).second) read({id}, [] {});
}

void VersionTexts::readAhead(std::size_t next) {
  const auto& ahead = shelf_->ahead;
  if (next >= ahead.size() || shelf_->bytes >= shelf_->most_bytes) return;
  const std::size_t end = std::min(next + kAtOnce, ahead.size());
  read({ahead.begin() + static_cast<std::ptrdiff_t>(next), ahead.begin() + static_cast<std::ptrdiff_t>(end)},
       [this, end] { readAhead(end); });
}

void VersionTexts::read(std::vector<study::RecordId> wanted, std::function<void()> then) {
  study_.read(*this,
              [this, wanted = std::move(wanted), then = std::move(then),
               shelf = shelf_](const store::StudyFile& file) -> StudyConnection::Deliver {
                std::vector<std::pair<study::RecordId, Read>> found;
                for (const study::RecordId& id : wanted) found.emplace_back(id, store::modelVersion(file, id));
                return [this, then, shelf, found = std::move(found)] {
                  if (shelf != shelf_) return;
                  bool wanted_now = false;
                  for (const auto& [id, version] : found) {
                    if (version && shelf->read.emplace(id, version).second) shelf->bytes += version->text.size();
                    if (!version) shelf->read.emplace(id, version);
                    wanted_now |= shelf->asked.erase(id) > 0;
                  }
                  if (wanted_now) emit arrived();
                  then();
                };
              });
}

}  // namespace tactus::workbench
