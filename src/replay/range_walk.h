// Iterates over the ranges of a bag in order, each as soon as it has been read: for a single pass over a part
// of it. Requests nothing else.
#pragma once

#include <optional>

#include "replay/reading.h"

namespace mapwright::replay {

/// Another request would not help.
bool isFinal(const Cell& cell);

class RangeWalk {
 public:
  /// The ranges that overlap `from_s` to `to_s`; without limits all of them, whatever times are stated.
  /// `reading` is open, used by nobody else (and does not look back), and outlives this.
  RangeWalk(Reading& reading, std::optional<double> from_s, std::optional<double> to_s);

  /// All ranges were returned.
  bool over() const { return !next_s_; }
  /// The next one; null until it has been read. Reading::changed() tells when to ask again.
  ChunkPtr next();
  /// The range it is waiting for, with its failure if there is one. nullptr: over.
  const Cell* waitsFor() const;
  /// The share of the part returned so far, 0..1.
  double share() const;

 private:
  void wantNext(const Cell* cell);

  Reading& reading_;
  std::optional<double> from_s_, to_s_, next_s_;
};

}  // namespace mapwright::replay
