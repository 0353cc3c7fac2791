#include "app/workbench/participant/kit/pages.h"

#include <utility>
#include <vector>

namespace tactus::workbench {
namespace {

using nurse::phrase;
using AboutQuestion = AboutYouState::Question;

QString idOf(AboutQuestion question) {
  switch (question) {
    case AboutQuestion::kYears: return QStringLiteral("you.years");
    case AboutQuestion::kHand: return QStringLiteral("you.hand");
    case AboutQuestion::kGloves: return QStringLiteral("you.gloves");
    case AboutQuestion::kHaptic: return QStringLiteral("you.haptic");
    case AboutQuestion::kComfort: break;
  }
  return QStringLiteral("you.comfort");
}

QStringList answerIds(AboutQuestion question) {
  switch (question) {
    case AboutQuestion::kYears:
      return {QStringLiteral("years_1"), QStringLiteral("years_2"), QStringLiteral("years_3"),
              QStringLiteral("years_4")};
    case AboutQuestion::kHand: return {QStringLiteral("left"), QStringLiteral("right"), QStringLiteral("both")};
    case AboutQuestion::kHaptic:
      return {QStringLiteral("haptic_0"), QStringLiteral("haptic_1"), QStringLiteral("haptic_2")};
    case AboutQuestion::kGloves:
    case AboutQuestion::kComfort: break;
  }
  return {QStringLiteral("yes"), QStringLiteral("no")};
}

PageCard notSay() { return {QString::fromLatin1(kNotSay), phrase(QStringLiteral("you.not_say")), true}; }

/// `ends`: the word book has the meaning of both ends below this id.
PageState scalePage(const QString& sentence, const QString& ends, const QString& chosen) {
  PageState page;
  page.sentence = phrase(sentence);
  page.low = phrase(ends + QStringLiteral(".low"));
  page.high = phrase(ends + QStringLiteral(".high"));
  for (int points = 1; points <= kScalePoints; ++points) {
    const QString id = QString::number(points);
    page.cards.push_back({id, nurse::plain(id)});
  }
  page.chosen = chosen;
  page.wanted = phrase(QStringLiteral("err.points"));
  page.primary = phrase(QStringLiteral("nav.confirm"));
  return page;
}

}  // namespace

PageState aboutYouPage(const AboutYouState& asked) {
  PageState page;
  page.title = phrase(QStringLiteral("you.title"));
  page.sentence = phrase(idOf(asked.question));
  const bool unwell = asked.question == AboutQuestion::kComfort && asked.chosen == QLatin1String("no");
  if (unwell) page.remark = phrase(QStringLiteral("you.comfort_no"));
  const QString prefix = asked.question == AboutQuestion::kHand ? QStringLiteral("you.hand_") : QStringLiteral("you.");
  for (const QString& id : answerIds(asked.question)) page.cards.push_back({id, phrase(prefix + id)});
  // Which hand guides the tube must be known: the picture and the device follow it.
  if (asked.question != AboutQuestion::kHand) page.cards.push_back(notSay());
  page.chosen = asked.chosen;
  page.wanted = phrase(QStringLiteral("err.answer"));
  return page;
}

PageState restPage(bool begins_to_count) {
  PageState page;
  page.picture = begins_to_count ? PageState::Picture::kPush : PageState::Picture::kCup;
  page.title = phrase(begins_to_count ? QStringLiteral("cnt.title") : QStringLiteral("nav.rest"));
  page.sentence = phrase(begins_to_count ? QStringLiteral("cnt.line") : QStringLiteral("rest.line"));
  page.remark = phrase(begins_to_count ? QStringLiteral("for.nothing") : QStringLiteral("rest.ready"));
  page.primary = phrase(QStringLiteral("nav.continue"));
  return page;
}

PageState ratingPage(const QString& sentence, const QString& chosen) {
  PageState page = scalePage(sentence, sentence, chosen);
  page.cards.push_back(notSay());
  page.title = phrase(QStringLiteral("rate.title"));
  return page;
}

PageState statementPage(int item, int position, int count, const QString& chosen) {
  PageState page = scalePage(QStringLiteral("u.%1").arg(item), QStringLiteral("u"), chosen);
  page.title = phrase(QStringLiteral("u.title"), {QString::number(position), QString::number(count)});
  page.instructions = phrase(QStringLiteral("u.instructions"));
  if (position == count) page.primary = phrase(QStringLiteral("nav.seal"));
  return page;
}

PageState stoppedPage(StopReason why, const QString& code) {
  PageState page;
  page.title = phrase(QStringLiteral("thx.title"));
  switch (why) {
    case StopReason::kForToday: page.sentence = phrase(QStringLiteral("off.stop_kept"), {code}); break;
    case StopReason::kWithdrawn: page.sentence = phrase(QStringLiteral("off.deleted")); break;
    case StopReason::kNoConsent: page.sentence = phrase(QStringLiteral("con.declined")); break;
  }
  page.primary = phrase(QStringLiteral("nav.continue"));
  page.is_end = true;
  return page;
}

}  // namespace tactus::workbench
