// What robots can be asked for, and why one cannot. Values; the sentences are made by the room `sentences`.
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
    NotOfThisKind,  // robots of this kind have nothing of the sort
    ReadOnly,       // the maker opens no interface for changing anything; arguments[0] is the maker
    NotYetHere,     // robots of this kind have it, this version of the program does not ask for it yet
    FirmwareLacks,  // this one was asked, and does not know it; arguments[0] is what it answered
    LocalFiles,     // there is no robot
    NoService,      // others of the kind run a service for it; arguments[0] is what this one lacks
  };
  Reason reason = Reason::NotOfThisKind;
  std::vector<std::string> arguments = {};
  bool operator==(const Absence&) const = default;
};

}  // namespace mapwright::robot
