#include "app/session/judged_forces.h"

#include <map>
#include <set>
#include <utility>

#include "core/store/entries.h"

namespace tactus::session {
namespace {

using study::RecordId;

/// `record` and the records that it corrects, the latest first.
std::vector<const study::JudgementRecord*> chainOf(const study::JudgementRecord& record,
                                                   const std::map<RecordId, const study::JudgementRecord*>& by_id) {
  std::vector<const study::JudgementRecord*> chain{&record};
  while (chain.back()->entry.supersedes) {
    const auto found = by_id.find(*chain.back()->entry.supersedes);
    if (found == by_id.end()) break;
    chain.push_back(found->second);
  }
  return chain;
}

}  // namespace

base::Result<std::vector<JudgedForce>> judgedForces(const store::StudyFile& file, const StudyView& view) {
  const auto all = store::judgements(file, {{}, {}, true});
  if (!all) return tl::unexpected(base::inFile(all.error(), file.path()));
  std::map<RecordId, const study::JudgementRecord*> by_id;
  std::set<RecordId> corrected;
  for (const auto& record : *all) {
    by_id[record.entry.id] = &record;
    if (record.entry.supersedes) corrected.insert(*record.entry.supersedes);
  }
  std::map<RecordId, std::string> counted_sessions;
  const std::set<RecordId> counted(view.judgement_ids.begin(), view.judgement_ids.end());
  for (std::size_t i = 0; i < view.judgement_ids.size(); ++i) {
    const auto found = by_id.find(view.judgement_ids[i]);
    if (found == by_id.end()) continue;
    counted_sessions[found->second->entry.session] = view.study.judgements[i].participant;
  }
  std::map<std::string, std::size_t> participants;
  for (const auto& one : view.study.participants) participants.emplace(one.code, participants.size());

  // By participant, then by the place of the first record: a correction stands where the judgement was.
  std::map<std::pair<std::size_t, const study::JudgementRecord*>, JudgedForce> ordered;
  for (const auto& record : *all) {
    const auto session = counted_sessions.find(record.entry.session);
    if (session == counted_sessions.end() || corrected.contains(record.entry.id)) continue;
    const auto chain = chainOf(record, by_id);
    JudgedForce judged{session->second, record, counted.contains(record.entry.id), {}};
    for (std::size_t i = chain.size(); i-- > 1;) judged.before.push_back({chain[i]->kind, chain[i]->term});
    ordered.emplace(std::pair(participants[session->second], chain.back()), std::move(judged));
  }
  std::vector<JudgedForce> out;
  for (auto& [key, judged] : ordered) out.push_back(std::move(judged));
  return out;
}

}  // namespace tactus::session
