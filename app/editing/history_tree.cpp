#include "app/editing/history_tree.h"

#include <utility>

namespace tactus::editing {
namespace {

using Place = HistoryRow::Place;

class Rows {
 public:
  explicit Rows(const EditHistory& history)
      : history_(history), children_(history.states().size()), places_(history.states().size(), Place::kBranch) {
    const auto& states = history_.states();
    for (StateId state = 0; state < states.size(); ++state) {
      if (states[state].parent) children_[*states[state].parent].push_back(state);
    }
    Place place = Place::kDone;
    for (const StateId state : history_.line()) {
      if (state == history_.current()) {
        places_[state] = Place::kCurrent;
        place = Place::kUndone;
      } else {
        places_[state] = place;
      }
    }
  }

  std::vector<HistoryRow> all() {
    const auto& states = history_.states();
    for (StateId state = 0; state < states.size(); ++state) {
      if (!states[state].parent) add(state);
    }
    addMarks();
    return std::move(rows_);
  }

 private:
  struct Chain {
    StateId state;
    std::size_t level;
    bool starts;
  };

  // Chains wait on a stack, the one to come next on top: a history may be deeper than a call stack.
  void add(StateId root) {
    std::vector<Chain> waiting = {{root, 0, true}};
    while (!waiting.empty()) {
      const Chain chain = waiting.back();
      waiting.pop_back();
      const auto& next = history_.states()[chain.state].redo;
      HistoryRow row;
      row.state = chain.state;
      row.place = places_[chain.state];
      row.level = chain.level;
      row.starts = chain.starts;
      row.goes_on = next.has_value();
      rows_.push_back(std::move(row));
      if (next) waiting.push_back({*next, chain.level, false});
      const auto& children = children_[chain.state];
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        if (*child != next) waiting.push_back({*child, chain.level + 1, true});
      }
    }
  }

  void addMarks() {
    std::vector<std::size_t> row_of(rows_.size());
    for (std::size_t row = 0; row < rows_.size(); ++row) row_of[rows_[row].state] = row;
    const auto& events = history_.events();
    for (std::size_t e = 0; e < events.size(); ++e) {
      const EventKind kind = events[e].kind;
      if (kind == EventKind::kSnapshot || kind == EventKind::kSignOff)
        rows_[row_of[events[e].state]].marks.push_back(e);
    }
  }

  const EditHistory& history_;
  std::vector<std::vector<StateId>> children_;
  std::vector<Place> places_;
  std::vector<HistoryRow> rows_;
};

}  // namespace

std::vector<HistoryRow> historyRows(const EditHistory& history) { return Rows(history).all(); }

}  // namespace tactus::editing
