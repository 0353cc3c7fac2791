// How far vertices of one list of terms can move together, and the list after it. Internal to membership_edits.
#pragma once

#include <string>
#include <vector>

#include "app/editing/partition.h"
#include "app/editing/term_list.h"

namespace tactus::editing {

/// A vertex by the index of its term in the list and its index in Term::points.
struct Vertex {
  std::size_t term = 0;
  std::size_t point = 0;

  bool operator==(const Vertex&) const = default;
};

/// Vertices of one list that move by the same way. Where the terms sum to one, vertices of neighbouring terms that lie
/// on each other move together.
class VertexMove {
 public:
  /// `list` must stay where it is. `order`: of terms that sum to one, or null where they need not.
  VertexMove(const OpenList& list, bool is_output, const TermOrder* order);

  /// Takes the vertex and all that lie on it along.
  void add(const Vertex& vertex);
  const std::vector<Vertex>& vertices() const { return moving_; }

  /// Moves all by `by`, or as far as it goes; the one that stops ends exactly where it is stopped.
  void run(double by);
  /// Moves vertices that all lie at one place to `to`, exactly, or as far as it goes.
  void runTo(double to);

  /// Why the vertices stopped before; empty where they did not.
  const std::string& stopped() const { return stopped_; }

 private:
  struct Bounds {
    double low;
    double high;
    std::string why_low;
    std::string why_high;

    void raise(double value, const std::string& why);
    void lower(double value, const std::string& why);
  };

  bool isMoving(const Vertex& vertex) const;
  const fuzzy::Term& termOf(const Vertex& vertex) const { return (*list_.terms)[vertex.term]; }
  double& at(const Vertex& vertex) { return (*list_.terms)[vertex.term].points[vertex.point]; }
  std::vector<Vertex> liesOn(const Vertex& vertex) const;
  /// Between which values the vertex may lie; its own place is always one of them.
  Bounds boundsOf(const Vertex& vertex) const;
  void bound(const Vertex& vertex, Bounds& bounds) const;
  void boundByNeighbours(const Vertex& vertex, Bounds& bounds) const;
  void boundByPartition(const Vertex& vertex, Bounds& bounds) const;
  void boundByOutput(const Vertex& vertex, Bounds& bounds) const;
  bool inOrder() const;

  OpenList list_;
  bool is_output_;
  const TermOrder* order_;
  double range_;
  double narrowest_;
  std::vector<Vertex> moving_;
  std::string stopped_;
};

}  // namespace tactus::editing
