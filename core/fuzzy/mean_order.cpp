#include "core/fuzzy/mean_order.h"

#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {

MeanOrder meanOrder(const CompiledModel& model) {
  const ModelTables& tables = model.tables();
  MeanOrder out;
  for (const ExpertTable& expert : tables.experts) out.shares.push_back(expert.share);
  if (!tables.program.usable) return out;
  const PointProgram& point = tables.program.point;
  std::size_t seat = 0;
  for (const Team& team : point.teams) {
    MeanOrder::Team& own = out.teams.emplace_back();
    own.alone = team.layout == Team::Layout::kAlone;
    for (std::size_t k = 0; k < team.experts; ++k) own.experts.push_back(point.expert_at[seat++]);
  }
  return out;
}

}  // namespace tactus::fuzzy
