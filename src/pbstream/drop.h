// A state file with something left out: what is named goes, with all that refers to it. Every other record
// keeps its bytes. Source: docs/protocols/pbstream.md, "Safe edits". Accesses the disk; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "pbstream/state_file.h"

namespace mapwright::pbstream {

struct Dropped {
  std::set<std::int32_t> trajectories;
  std::set<map::SubmapId> submaps;
  /// Loop closures (ConstraintKind::Inter) between a submap and a node.
  std::set<std::pair<map::SubmapId, map::NodeId>> closures;
  bool empty() const { return trajectories.empty() && submaps.empty() && closures.empty(); }
};

/// What the new file lacks.
struct DropReceipt {
  std::size_t trajectories = 0, submaps = 0, nodes = 0;
  std::size_t inter = 0, intra = 0;  // constraints
  std::size_t records = 0;           // left out altogether
  std::size_t rewritten = 0;         // records with other bytes than before; all others have the same
};

/// Writes a new file, `to`; nothing may be there. It is read again and compared before this succeeds. The
/// error says why there is none: among others that `from` is damaged, that there is no such thing in it, or
/// that something that stays would refer to what goes.
tl::expected<DropReceipt, Fault> drop(const std::string& from, const Dropped& what, const std::string& to,
                                      const Cancelled& cancelled = {});

}  // namespace mapwright::pbstream
