#include "app/workbench/participant/kit/look.h"

#include <QScreen>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tactus::workbench::nurse {

void keepSpacing(const Look& look, QLayout& layout, double steps) {
  layout.setContentsMargins(0, 0, 0, 0);
  const auto set = [&look, &layout, steps] { layout.setSpacing(look.gap(steps)); };
  set();
  QObject::connect(&look, &Look::changed, &layout, set);
}

namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kPointsPerInch = 72;
constexpr double kTextPoints = 22;
constexpr double kLeastDots = 80;
constexpr double kMostDots = 220;
// The densest screen (force perception) needs 180 mm of height and 18 heights of text; a smaller window shrinks both.
constexpr double kWindowMm = 180;
constexpr double kWindowTexts = 18;
constexpr double kWindowTextsWide = 32;

}  // namespace

Look::Look(QObject* parent) : QObject(parent) {}

void Look::setAbout(std::shared_ptr<const procedure::Procedure> about, const QString& form) {
  if (about == nullptr) about = procedure::defaultProcedure();
  const study::Form* asked = about->form(form.toStdString());
  if (asked == nullptr) asked = &about->forms.front();
  if (about == about_ && asked == form_) return;
  about_ = std::move(about);
  form_ = asked;
  words_ = Wordbook(*about_, form_->id);
  emit changed();
}

void Look::setLanguage(const Language& language) {
  if (language_ == language) return;
  language_ = language;
  emit changed();
}

void Look::setTextPercent(int percent) {
  if (text_percent_ == percent) return;
  text_percent_ = percent;
  emit changed();
}

void Look::setScreen(double dots_per_inch, const QSize& window) {
  const double clamped = std::clamp(dots_per_inch, kLeastDots, kMostDots);
  if (dots_per_inch_ == clamped && window_ == window) return;
  dots_per_inch_ = clamped;
  window_ = window;
  emit changed();
}

void Look::setScreen(const QScreen& screen) { setScreen(screen.physicalDotsPerInch(), screen.size()); }

int Look::mm(double length) const {
  const double dots = std::min(dots_per_inch_ / kMmPerInch, window_.height() / kWindowMm);
  return static_cast<int>(std::lround(length * dots));
}

int Look::textPx() const {
  const double wanted = kTextPoints / kPointsPerInch * dots_per_inch_ * text_percent_ / 100;
  return static_cast<int>(
      std::lround(std::min({wanted, window_.height() / kWindowTexts, window_.width() / kWindowTextsWide})));
}

QFont Look::font(const Language& language, double factor, bool bold) const {
  QFont font;
  font.setFamilies(fontFamilies(language));
  font.setPixelSize(static_cast<int>(std::lround(textPx() * factor)));
  font.setBold(bold);
  return font;
}

}  // namespace tactus::workbench::nurse
