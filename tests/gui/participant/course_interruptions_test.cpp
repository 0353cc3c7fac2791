// The program is killed, the disk is full, the device is unplugged: on each screen. Nothing acknowledged is missing,
// and it goes on at the right place.
#include <QFile>
#include <atomic>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/store/persons.h"
#include "core/store/study_info.h"

#include "tests/gui/participant/course_test.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using Screen = ParticipantScreen;

/// A place of the session.
struct Place {
  std::string name;
  Screen screen;
  bool feels_force = false;
};

void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }

/// The `wanted` screens; the practice comes twice.
std::vector<Place> places(bool (*wanted)(const ScreenFacts&)) {
  std::vector<Place> out;
  for (const ScreenFacts& facts : kScreenFacts) {
    if (!wanted(facts)) continue;
    const std::string id = facts.id;
    const bool practice = facts.screen == Screen::kPractice;
    if (practice) out.push_back({id + "_speed", facts.screen});
    out.push_back({practice ? id + "_force" : id, facts.screen, practice || facts.screen == Screen::kForce});
  }
  return out;
}

std::string nameOf(const testing::TestParamInfo<Place>& place) { return place.param.name; }

struct Stored {
  std::size_t profiles = 0;
  std::size_t strokes = 0;
  std::size_t judgements = 0;
  std::size_t answers = 0;
  std::size_t ratings = 0;
  bool operator==(const Stored&) const = default;
};

Stored storedIn(const store::StudyFile& file) {
  const store::Selection all{{}, {}, true};
  return {store::profiles(file, all)->size(), store::strokes(file, all, store::Recordings::kLeaveOut)->size(),
          store::judgements(file, all)->size(), store::answers(file, all)->size(), store::ratings(file, all)->size()};
}

class InterruptedCourse : public CourseTest, public testing::WithParamInterface<Place> {
 protected:
  bool isAt(const Place& place) const {
    const bool feels = screen() == Screen::kPractice && at().feels_force;
    return screen() == place.screen && (place.screen != Screen::kPractice || feels == place.feels_force);
  }

  // What a nurse does on the screen that is shown; counts what was acknowledged.
  void doIt() {
    switch (screen()) {
      case Screen::kWelcome: return newHereAndOn();
      case Screen::kAboutYou:
        answer(at().about.question == AboutYouState::Question::kYears  ? "years_3"
               : at().about.question == AboutYouState::Question::kHand ? "left"
                                                                       : "not_say");
        if (screen() != Screen::kAboutYou) ++acknowledged.profiles;
        return;
      case Screen::kDeviceCheck: return checkDevice();
      case Screen::kPractice:
      case Screen::kSpeed:
        if (!at().feels_force) {
          insert();
          ++acknowledged.strokes;
          return;
        }
        [[fallthrough]];
      case Screen::kForce:
        feel();
        answer("small");
        ++acknowledged.judgements;
        return;
      case Screen::kRating: ++acknowledged.ratings; return rate();
      case Screen::kQuestion:
        answer("medium");
        ++acknowledged.answers;
        return;
      case Screen::kOwnModel: pushOwnModel(); return answer("right");
      default: {
        const auto& cards = at().page.cards;
        return cards.empty() ? next() : answer(cards.front().id.toUtf8());
      }
    }
  }
  void newHereAndOn() {
    newHere();
    code = at().code;
    next();
  }
  void walkTo(const Place& place) {
    for (int steps_left = 200; steps_left > 0 && !isAt(place); --steps_left) ASSERT_NO_FATAL_FAILURE(doIt());
    ASSERT_TRUE(isAt(place)) << place.name;
  }
  void comeBack() {
    look();
    nurse->enterCode(code);
    ASSERT_TRUE(comesTrue([&] { return at().code == code; }));
    next();
  }
  // The file as a killed program leaves it: with its journal.
  QString killed() {
    const QString copy = folder.filePath(QStringLiteral("killed.tactus"));
    for (const char* end : {"", "-wal"}) {
      const QLatin1String part(end);
      if (!QFile::exists(path + part)) continue;
      EXPECT_TRUE(QFile::copy(path + part, copy + part));
    }
    return copy;
  }

  Stored acknowledged;
  QString code;
};

class KilledCourse : public InterruptedCourse {};

class FullDiskCourse : public InterruptedCourse {
 protected:
  // What she does on the screen while nothing can be stored.
  void actWithoutRoom() {
    switch (screen()) {
      case Screen::kDeviceCheck: return checkDevice();
      case Screen::kPractice:
      case Screen::kForce:
        if (!at().feels_force && screen() == Screen::kPractice) return push();
        feel();
        look();
        nurse->choose(QStringLiteral("small"));
        return nurse->next();
      case Screen::kSpeed: return push();
      case Screen::kThanks: return;  // nothing is left to do
      case Screen::kOwnModel: pushOwnModel(); [[fallthrough]];
      default:
        look();
        for (const char* id : {"not_say", "3", "medium", "right"}) nurse->choose(QLatin1String(id));
        nurse->next();
    }
  }
  void push() {
    look();
    steps->moveTo(*device, 0, 200);
    advance(400);
    steps->moveTo(*device, 70, 60);
    advance(1000);
  }
};

class UnpluggedCourse : public InterruptedCourse {};

TEST_P(KilledCourse, KeepsWhatWasAcknowledgedAndGoesOnThere) {
  ASSERT_NO_FATAL_FAILURE(walkTo(GetParam()));
  const QString left = killed();
  getUp();
  path = left;
  {
    const auto file = tests::lookInto(path);
    EXPECT_TRUE(store::checkStudy(file)->empty());
    EXPECT_EQ(storedIn(file), acknowledged);
    if (acknowledged.profiles == 0 && GetParam().screen != Screen::kAboutYou) {
      EXPECT_TRUE(store::persons(file)->empty()) << "without consent nothing is kept";
      return;
    }
  }
  sitDown(time);
  ASSERT_NO_FATAL_FAILURE(comeBack());
  // What she passes again after each start.
  const auto again = [this] {
    return screen() == Screen::kDeviceCheck || screen() == Screen::kGlossary || beginsToCount() ||
           (screen() == Screen::kReview && at().review.sealed);
  };
  while (!isAt(GetParam()) && again()) ASSERT_NO_FATAL_FAILURE(doIt());
  // The rest was hers already; its thanks come after the own model, which is felt again.
  const Place expected = GetParam().screen == Screen::kRest     ? Place{"", Screen::kPractice, true}
                         : GetParam().screen == Screen::kThanks ? Place{"", Screen::kOwnModel}
                                                                : GetParam();
  EXPECT_TRUE(isAt(expected)) << static_cast<int>(screen());
  EXPECT_TRUE(refused.isEmpty()) << refused.toStdString();
  ASSERT_NO_FATAL_FAILURE(walkTo({"thanks", Screen::kThanks}));
  getUp();
  EXPECT_EQ(storedIn(tests::lookInto(path)), acknowledged);
}

INSTANTIATE_TEST_SUITE_P(Screens, KilledCourse, testing::ValuesIn(places(isOfANurse)), nameOf);

TEST_P(FullDiskCourse, SaysItInOneSentenceAndGoesOnOnceThereIsRoom) {
  ASSERT_NO_FATAL_FAILURE(walkTo(GetParam()));
  if (screen() == Screen::kAboutYou) {
    for (int question = 0; question < 4; ++question) doIt();
  }
  const auto full = std::make_shared<std::atomic<bool>>(true);
  study->order([full](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
    if (*full) return base::fail(base::ErrorCode::kIo, "disk", "no space left", "free space");
    return {};
  });
  const Screen before = screen();
  ASSERT_NO_FATAL_FAILURE(actWithoutRoom());
  ASSERT_TRUE(comesTrue([this] { return !study->failure().isEmpty(); }));
  EXPECT_FALSE(study->failure().contains(QLatin1Char('\n')));
  // Sealing asks for the ratings of the part first.
  const bool stores = before != Screen::kDeviceCheck && before != Screen::kGlossary && before != Screen::kReview &&
                      before != Screen::kThanks;
  if (stores) {
    ASSERT_TRUE(comesTrue([this] { return at().failed; }));
    // What was not stored is not left.
    EXPECT_TRUE(before == Screen::kRating || before == Screen::kRest || screen() == before);
  }
  *full = false;
  study->storeNow();
  ASSERT_TRUE(stored());
  EXPECT_FALSE(at().failed);
  ASSERT_NO_FATAL_FAILURE(walkTo({"thanks", Screen::kThanks}));
  getUp();
  const auto file = tests::lookInto(path);
  EXPECT_TRUE(store::checkStudy(file)->empty());
  const Stored all = storedIn(file);
  EXPECT_EQ(all.profiles, 1U);
  EXPECT_EQ(all.strokes, 3U);
  EXPECT_EQ(all.judgements, 3U);
  EXPECT_EQ(all.answers, 45U);
  EXPECT_EQ(all.ratings, 3U);
}

// The welcome has nothing to store yet.
// There is no participant yet at the welcome.
INSTANTIATE_TEST_SUITE_P(Screens, FullDiskCourse, testing::ValuesIn(places([](const ScreenFacts& facts) {
                           return isOfANurse(facts) && facts.screen != Screen::kWelcome;
                         })),
                         nameOf);

TEST_P(UnpluggedCourse, HasNoForceSaysItAndComesBackToTheSameScreen) {
  // Once to know when she is there, once with the fault at that moment.
  ASSERT_NO_FATAL_FAILURE(walkTo(GetParam()));
  if (GetParam().feels_force) feel();
  const double there_s = static_cast<double>(steps->nowNs() - device_since_ns) * 1e-9;
  getUp();
  acknowledged = {};
  path = folder.filePath(QStringLiteral("again.tactus"));
  tests::makeStudyFile(path);
  haptics::VirtualDeviceSettings settings;
  settings.faults = {{haptics::InjectedFault::kUnplugged, there_s + 0.4, 1e6}};
  tests::SteppedFeel faulty(settings);
  sitDown(faulty);
  for (int steps_left = 200; steps_left > 0 && !isAt(GetParam()); --steps_left) doIt();
  ASSERT_TRUE(isAt(GetParam()));
  const Stored before = acknowledged;
  nurse->painted(at().serial);
  device->setHeld(true);
  for (int i = 0; i < 200 && screen() != Screen::kDeviceCheck; ++i) advance(100);
  ASSERT_EQ(screen(), Screen::kDeviceCheck);
  EXPECT_EQ(device->latest().force_n, 0);
  EXPECT_TRUE(at().device == DeviceStep::kWrong || at().device == DeviceStep::kLost);
  EXPECT_TRUE(at().can_go_on) << "once more";
  device->setHeld(false);
  next();
  steps->moveTo(*device, 0, 200);
  checkDevice();
  EXPECT_TRUE(isAt(GetParam())) << static_cast<int>(screen());
  getUp();
  const Stored after = storedIn(tests::lookInto(path));
  EXPECT_EQ(after.strokes, before.strokes);
  EXPECT_EQ(after.judgements, before.judgements);
  EXPECT_EQ(after.answers, before.answers);
}

INSTANTIATE_TEST_SUITE_P(Screens, UnpluggedCourse, testing::ValuesIn(places([](const ScreenFacts& facts) {
                           return facts.uses_device && facts.screen != Screen::kDeviceCheck;
                         })),
                         nameOf);

}  // namespace
}  // namespace tactus::workbench
