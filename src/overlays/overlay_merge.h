// What one version of a document of overlays changes against another, and the three-way merge. Each member of
// a feature is merged on its own, and each of its properties; a geometry only as a whole. Pure functions.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "overlays/overlay_document.h"

namespace mapwright::overlays {

/// A member of a feature or of the collection, one of its properties, or all of it.
struct Part {
  enum class Of { Whole, Member, Property };
  Of of = Of::Whole;
  std::string name;
  /// "geometry", "properties.name"; empty for all of it.
  std::string text() const { return of == Of::Property ? "properties." + name : name; }
  auto operator<=>(const Part&) const = default;
};

/// A part before and after, as JSON; nullopt: it is not there.
struct PartChange {
  Part part;
  std::optional<std::string> before, after;
};

enum class ChangeKind { Add, Change, Remove };

/// A changed feature, or what is changed of the collection.
struct OverlayChange {
  ChangeKind kind = ChangeKind::Change;
  bool collection = false;
  std::string id, name;                 // empty: none. Untrusted plain text
  std::vector<PartChange> parts;        // of Change
  std::optional<std::size_t> from, to;  // its indices in the two documents
};

/// Features are the same by id; those without one by what they contain, by name and type, or by where they
/// lie. Only another order is no change, nor is another notation of the same values.
std::vector<OverlayChange> changesBetween(const OverlayDocument& before, const OverlayDocument& after);

/// Of each feature in `a` the same one in `b`, found in that way; nullopt: it is not there.
std::vector<std::optional<std::size_t>> matchesOf(const OverlayDocument& a, const OverlayDocument& b);
/// The same by id, or without one by all that they contain: nothing is guessed.
std::vector<std::optional<std::size_t>> equalOf(const std::vector<Feature>& a, const std::vector<Feature>& b);
/// The members of the collection besides its features; a bare list says as much as a collection without any.
Feature collectionOf(const OverlayDocument& document);

/// The parts in which two versions of a feature differ.
std::vector<PartChange> changesOf(const Feature& before, const Feature& after);
/// Robots give an id to features that have none.
bool onlyNewId(const std::vector<PartChange>& changes);
/// Whether they are the same, or one lies within the other.
bool meet(const Part& a, const Part& b);
/// As JSON; nullopt: it is not there.
std::optional<std::string> partOf(const Feature& feature, const Part& part);
/// `value`: JSON; nullopt: removed. Without effect on what is no object.
Feature withPart(const Feature& feature, const Part& part, const std::optional<std::string>& value);
/// With the changes that lead to `after`; all else keeps its bytes.
Feature withChanges(Feature onto, const std::vector<PartChange>& changes, const Feature& after);

/// A feature; nullopt: it is not there.
using Version = std::optional<Feature>;
bool areSame(const Version& a, const Version& b);
/// Theirs with what I changed. `clash` is told the parts that both changed differently, of which mine stays;
/// Whole: one of them deleted it. What both added is merged part by part, too.
Version merged(const Version& base, const Version& mine, const Version& theirs,
               const std::function<void(const Part&)>& clash);

/// Both changed the same part in different ways. JSON; nullopt: it is not there.
struct OverlayConflict {
  std::string id, name;
  Part part;  // Whole: one of them removed the feature
  std::optional<std::string> base, mine, theirs;
};

struct OverlayMerge {
  OverlayDocument document;           // theirs, with my changes that are not in conflict
  std::vector<OverlayChange> mine;    // all that I changed against the base
  std::vector<OverlayChange> theirs;  // all that they did
  std::vector<OverlayConflict> conflicts;
};
/// By the rules of an EditingDocument that others changed meanwhile.
OverlayMerge merge(const OverlayDocument& base, const OverlayDocument& mine, const OverlayDocument& theirs);

}  // namespace mapwright::overlays
