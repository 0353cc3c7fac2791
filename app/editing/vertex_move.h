// Moves vertices of one term list together, as far as they can go. Internal to membership_edits.
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

/// Vertices of one list that move by the same distance. In a partition, vertices of neighboring terms at the same place
/// move together.
class VertexMove {
 public:
  /// `list` must not move. `order`: of a partition; null if the terms need not sum to one.
  VertexMove(const OpenList& list, bool is_output, const TermOrder* order);

  /// Adds the vertex and all vertices at the same place.
  void add(const Vertex& vertex);
  const std::vector<Vertex>& vertices() const { return moving_; }

  /// Moves all vertices by `by`, or until one of them is stopped; that one ends exactly at its stop.
  void run(double by);
  /// Moves vertices that are all at one place exactly to `to`, or until they are stopped.
  void runTo(double to);

  /// Why the vertices stopped short; empty if they did not.
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
  /// The range of the vertex. It always contains the current place.
  Bounds boundsOf(const Vertex& vertex) const;
  void bound(const Vertex& vertex, Bounds& bounds) const;
  void boundByNeighbors(const Vertex& vertex, Bounds& bounds) const;
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
