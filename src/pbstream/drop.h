// A state file with something left out: what is named goes, with all that refers to it. Every other record
// keeps its bytes. Source: docs/protocols/pbstream.md, "Safe edits". Accesses the disk; any thread.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "map/graph_parts.h"
#include "pbstream/state_file.h"

namespace mapwright::pbstream {

using Dropped = map::GraphParts;

/// What the new file lacks.
struct DropReceipt {
  std::size_t trajectories = 0, submaps = 0, nodes = 0;
  std::size_t inter = 0, intra = 0;  // constraints
  std::size_t records = 0;           // left out altogether
  std::size_t rewritten = 0;         // records with other bytes than before; all others have the same
  static constexpr std::size_t kMostDamaged = 5;
  /// Records that were copied as they are although they cannot be unpacked: "Record 1 at byte 2: why", and
  /// how many more there are.
  std::vector<Fault> damaged;
  std::size_t more_damaged = 0;
};

/// Writes a new file, `to`; nothing may be there. It is read again and compared before this succeeds. The
/// error says why there is none: among others that `from` is damaged, that there is no such thing in it, or
/// that something that stays would refer to what goes. `progressed` is told how much of it is done, 0 to 1.
tl::expected<DropReceipt, Fault> drop(const std::string& from, const Dropped& what, const std::string& to,
                                      const Cancelled& cancelled = {}, const Progressed& progressed = {});

}  // namespace mapwright::pbstream
