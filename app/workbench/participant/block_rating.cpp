#include "app/workbench/participant/block_rating.h"

namespace tactus::workbench {
namespace {

constexpr auto kNotSaid = "not_say";
constexpr int kMostPoints = 7;

}  // namespace

std::optional<int> scalePoints(const QString& id) {
  bool number = false;
  const int points = id.toInt(&number);
  return number && points >= 1 && points <= kMostPoints ? std::optional(points) : std::nullopt;
}

std::optional<int> BlockRating::points() const { return scalePoints(chosen_); }

void BlockRating::choose(const QString& id) {
  if (scalePoints(id) || id == QLatin1String(kNotSaid)) chosen_ = id;
}

bool BlockRating::next() {
  if (!isAnswered()) return false;
  if (isFirst()) {
    effort_ = points();
    if (effort()) chosen_.clear();
    return !effort();
  }
  comfort_ = points();
  return true;
}

void BlockRating::back() {
  if (isFirst()) return;
  chosen_ = effort() ? QString::number(*effort()) : QString();
  effort_.reset();
}

ScaleState BlockRating::state() const {
  ScaleState out;
  out.sentence = isFirst() ? QStringLiteral("rate.effort") : QStringLiteral("rate.comfort");
  out.position = isFirst() ? 1 : 2;
  out.count = 2;
  out.chosen = chosen_;
  out.may_not_say = true;
  return out;
}

}  // namespace tactus::workbench
