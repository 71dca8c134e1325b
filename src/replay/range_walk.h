// The ranges of a bag one after the other, each as soon as it has been read: for whoever wants to see all of
// a stretch of it once. Asks for nothing else.
#pragma once

#include <optional>

#include "replay/reading.h"

namespace mapwright::replay {

/// Asking for it again would not help.
bool isFinal(const Cell& cell);

class RangeWalk {
 public:
  /// Those that hold something of `from_s` to `to_s`; without them all, whatever the told times are.
  /// `reading` is opened, reads for nobody else (and does not look back), and outlives this.
  RangeWalk(Reading& reading, std::optional<double> from_s, std::optional<double> to_s);

  /// All have been told.
  bool over() const { return !next_s_; }
  /// The next one, once it has been read: until then null. Reading::changed() tells when to ask again.
  ChunkPtr next();
  /// The one that is waited for, as it is now: its failure, where it has one. nullptr: over.
  const Cell* waitsFor() const;
  /// How much of the stretch has been told, 0..1.
  double share() const;

 private:
  void wantNext(const Cell* cell);

  Reading& reading_;
  std::optional<double> from_s_, to_s_, next_s_;
};

}  // namespace mapwright::replay
