#include <QString>
#include <optional>
#include <vector>

#include "app/session/simulated_nurse.h"
#include "app/session/study_protocol.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/collect/monitor_window.h"
#include "app/workbench/collect/protocol_view.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/collect/withdrawal_dialog.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/screen_pictures.h"
#include "app/workbench/session/nurse_view.h"
#include "app/workbench/workbench.h"
#include "core/base/error.h"
#include "core/store/persons.h"
#include "core/store/research_key.h"
#include "core/store/sessions.h"

namespace tactus::workbench {
namespace {

using base::Result;

const QString kArea = QStringLiteral("collect");
constexpr std::int64_t kBegin = 1'763'971'200'000;  // 2025-11-24 08:00 UTC: the same in each picture
constexpr const char* kChinese = "zh-Hant";

/// A participant of the pictures and how many steps of a session they have done.
struct Guest {
  const char* code;
  const char* language;
  int steps;
};

// Each step is one record, done as the screens do it.
Result<void> doSteps(session::Session& session, int steps, const session::NurseTraits& traits) {
  session::SimulatedNurse nurse(traits, session.record().seed);
  for (int i = 0; i < steps && session.part() != session::SessionPart::kFinished; ++i) {
    if (auto ok = nurse.doNext(session); !ok) return ok;
  }
  return {};
}

Result<void> addGuest(store::StudyFile& file, study::RecordIds& ids, const Guest& guest, int day,
                      const session::NurseTraits& traits) {
  const study::Person person{ids.next(), guest.code, false};
  if (auto ok = store::append(file, person); !ok) return ok;
  if (guest.steps == 0) return {};
  const auto seed = static_cast<std::uint64_t>(day) + 1;
  TACTUS_TRY(const auto start, session::startUnderProtocol(file, person.id, guest.language, seed));
  const study::Moment when{kBegin + day * std::int64_t{86'400'000}, 0};
  auto session = session::Session::begin(file, start, {[when] { return when; }, study::RecordIds(seed)});
  if (!session) return tl::unexpected(session.error());
  return doSteps(*session, guest.steps, traits);
}

// Everybody in it is another way along.
Result<void> makeStudy(const QString& path) {
  study::RecordIds ids(11);
  TACTUS_TRY(auto file, store::StudyFile::create(path.toStdString(), {ids.next(), "Ward 7", kBegin, "pictures"}));
  session::StudyProtocol protocol;
  protocol.languages = {"en", kChinese};
  protocol.consent_version = "2025-11";
  protocol.consent = {{"en", "This study is run by the School of Nursing. Questions: ask the researcher."},
                      {kChinese, "本研究由護理學院主持。如有疑問，請洽研究人員。"}};
  protocol.device = {"touch", 0.26, 2, 0.88};
  session::SessionTools tools{[] { return study::Moment{kBegin, 0}; }, study::RecordIds(12)};
  if (auto set = session::setProtocol(file, protocol, "lee", {}, tools); !set) return tl::unexpected(set.error());
  if (auto set = store::setResearchKey(file, "pictures", kBegin); !set) return set;
  const Guest guests[] = {{"amber-crow", kChinese, 400},
                          {"blue-fox", "en", 27},
                          {"calm-heron", kChinese, 60},
                          {"dusty-lark", "en", 9},
                          {"early-finch", "en", 0}};
  const session::NurseTraits traits = session::simulatedNurseCalled("S1", session::kDefaultSeed);
  int day = 0;
  for (const Guest& guest : guests) {
    if (auto ok = addGuest(file, ids, guest, day++, traits); !ok) return ok;
  }
  return file.close();
}

// A session at the forces, as the monitor sees it.
Result<void> addMonitor(PictureAlbum& album, Workbench& bench) {
  SessionProxy proxy(bench.study);
  const auto* const row = &bench.collect.overview().rows.at(1);
  std::optional<study::RecordId> session;
  bench.study.read(bench.study, [&session, person = row->person](const store::StudyFile& file) {
    const auto sessions = store::sessions(file, person);
    return [&session, found = sessions && !sessions->empty() ? std::optional(sessions->back().id) : std::nullopt] {
      session = found;
    };
  });
  waitFor([&] { return session.has_value(); });
  if (!session) return {};
  proxy.resume(*session);
  waitFor([&] { return proxy.snapshot() != nullptr; });
  std::int64_t now_ms = kBegin + 1'234'000;
  MonitorController monitor(proxy, bench.study, [&now_ms] { return now_ms += 8'000; });
  for (int i = 0; i < 3 && proxy.snapshot() && proxy.snapshot()->part == session::SessionPart::kForce; ++i) {
    experiments::ForceAnswer answer{study::ForceJudgement::Kind::kTerm, i == 0 ? "very_small" : "small"};
    answer.forward_mm = 40;
    answer.forward_speed_mm_s = 60;
    answer.delivered_share = i == 1 ? 0.82 : 1.0;
    const std::size_t lines = monitor.lines().size();
    if (!proxy.judge(proxy.snapshot()->step, answer)) break;
    waitFor([&] { return monitor.lines().size() > lines; });
  }
  monitor.note(MonitorWindow::tr("Grip changed"));
  ParticipantState state;
  state.code = row->code;
  state.screen = ParticipantScreen::kForce;
  state.device = DeviceStep::kReady;
  state.force.phase = ForceState::Phase::kFeel;
  const auto snapshot = proxy.snapshot();
  NurseView view = nurseView(state, snapshot && snapshot->force ? &*snapshot->force : nullptr);
  monitor.show(view);
  std::vector<haptics::Sample> samples(12'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time_s = static_cast<double>(i) * 1e-3;
    const double wanted_n = std::fmod(time_s, 6) < 3 ? (time_s < 6 ? 0.6 : 0.7) : 0;
    samples[i].time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    samples[i].source_force_n = wanted_n;
    samples[i].force_n = wanted_n * (1 - std::exp(-std::fmod(time_s, 6) / 0.08));
  }
  monitor.add(samples);
  MonitorWindow window(monitor);
  window.show();
  if (auto ok = album.add(kArea, QStringLiteral("monitor"), window.windowTitle(), window); !ok) return ok;
  view.called = view.force_off = true;
  monitor.show(view);
  auto added = album.add(kArea, QStringLiteral("monitor_called"), window.windowTitle(), window);
  window.hide();
  proxy.leave();
  waitFor([&] { return !proxy.isSaving(); });
  return added;
}

}  // namespace

Result<void> addCollectPictures(PictureAlbum& album, Workbench& bench, const QString& folder) {
  const auto home = [&](const char* screen) {
    bench.window.banner().hide();
    return album.add(kArea, QLatin1String(screen), stageName(Stage::kCollect), bench.window);
  };
  const auto settled = [&] {
    return !bench.study.isOpening() && bench.collect.isCurrent() && bench.protocol.isReady();
  };
  bench.window.enter(Stage::kCollect);
  if (auto ok = home("home_simulated"); !ok) return ok;

  const QString path = folder + QStringLiteral("/ward-7.tactus");
  if (auto made = makeStudy(path); !made) return made;
  bench.files.open(path);
  waitFor([&] { return bench.study.path() == path && settled() && bench.collect.overview().rows.size() == 5; });
  bench.window.enter(Stage::kCollect);
  StudyHome& list = bench.views.collect->home();
  list.select(bench.collect.overview().rows.at(1).person);
  if (auto ok = home("home"); !ok) return ok;
  bench.views.collect->showProtocol();
  if (auto ok = home("protocol"); !ok) return ok;
  bench.views.collect->protocolPage().showSection(2);
  if (auto ok = home("protocol_forces"); !ok) return ok;
  bench.views.collect->protocolPage().showSection(4);
  if (auto ok = home("protocol_consent"); !ok) return ok;
  bench.protocol.set("force.ladder.highest_n", QStringLiteral("2.4"));
  bench.views.collect->protocolPage().showSection(2);
  if (auto ok = home("protocol_refused"); !ok) return ok;
  bench.protocol.discard();
  bench.views.collect->showHome();
  WithdrawalDialog dialog(bench.collect, bench.collect.overview().rows.at(1).person, &bench.window);
  dialog.show();
  waitFor([&] { return dialog.isCounted(); });
  if (auto ok = album.add(kArea, QStringLiteral("withdrawal"), dialog.windowTitle(), dialog); !ok) return ok;
  dialog.hide();
  if (auto ok = addMonitor(album, bench); !ok) return ok;

  const QString empty = folder + QStringLiteral("/new-study.tactus");
  bench.study.create(empty);
  waitFor([&] { return bench.study.path() == empty && settled(); });
  bench.window.enter(Stage::kCollect);
  return home("home_empty");
}

}  // namespace tactus::workbench
