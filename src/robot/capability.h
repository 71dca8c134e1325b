// What robots can be asked for, and why one cannot. Values; the room `sentences` makes the texts.
#pragma once

#include <string>
#include <vector>

namespace mapwright::robot {

enum class Capability {
  Submaps,          // SubmapSource
  Catalogue,        // MapCatalogue
  WholeMaps,        // WholeMapSource
  Overview,         // OverviewSource
  Waypoints,        // WaypointSource
  WaypointEditing,  // WaypointStore
  Live,             // LiveTopics
  Administration,   // MapAdministration
  PictureEditing,   // PictureStore
  Bags,             // BagLibrary
  Dispatch,         // MapDispatch
};

/// Why a robot lacks a capability.
struct Absence {
  enum class Reason {
    NotOfThisKind,  // robots of this kind never have it
    ReadOnly,       // the maker's interface is read-only; arguments[0] is the maker
    NotYetHere,     // robots of this kind have it, but this version of the program does not support it
    FirmwareLacks,  // this one answered that it does not support it; arguments[0] is its answer
    LocalFiles,     // there is no robot
    NoService,      // others of the kind run a service for it; arguments[0] is what is missing here
  };
  Reason reason = Reason::NotOfThisKind;
  std::vector<std::string> arguments = {};
  bool operator==(const Absence&) const = default;
};

}  // namespace mapwright::robot
