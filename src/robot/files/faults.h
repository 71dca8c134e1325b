// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::files::fault {

using namespace mapwright::fault;  // what all rooms share

// Map files.
/// path
inline constexpr FaultCode NoSuchFile{"files", QT_TRANSLATE_NOOP("files", "There is no file %1.")};
/// because: why
inline constexpr FaultCode PictureNotReadable{
    "files", QT_TRANSLATE_NOOP("files", "Its picture cannot be read."), FaultCode::Causes::Sentence};
/// file names
inline constexpr FaultCode SeveralYamls{
    "files",
    QT_TRANSLATE_NOOP("files",
                      "Several map.yaml files name this picture, so none is used: %1. Open the right one.")};
/// line
inline constexpr FaultCode YamlBroken{"files", QT_TRANSLATE_NOOP("files", "It is not YAML (line %1).")};
/// how many
inline constexpr FaultCode OriginCount{
    "files", QT_TRANSLATE_NOOP("files", "Its origin has %1 numbers. It must have three: x, y and yaw.")};

// Files with waypoints.
inline constexpr FaultCode NoSuchMap{"files", QT_TRANSLATE_NOOP("files", "There is no such map.")};
/// path; because: why
inline constexpr FaultCode WaypointFileNotRead{"files", QT_TRANSLATE_NOOP("files", "%1 cannot be read")};
/// path
inline constexpr FaultCode FileChanged{"files",
                                       QT_TRANSLATE_NOOP("files", "%1 has changed on disk in the meantime.")};
/// the most, with its unit
inline constexpr FaultCode FileTooLarge{"files", QT_TRANSLATE_NOOP("files", "it is larger than %1")};
inline constexpr FaultCode FileEmpty{"files", QT_TRANSLATE_NOOP("files", "it is empty")};
inline constexpr FaultCode NotAFeatureCollection{
    "files", QT_TRANSLATE_NOOP("files", "it is not a GeoJSON FeatureCollection")};
/// how many
inline constexpr FaultCode WaypointsUnread{
    "files",
    QT_TRANSLATE_N_NOOP("files", "%1 features are not points that can be read. They are not shown.")};
/// property
inline constexpr FaultCode WaypointHeadingUnread{
    "files", QT_TRANSLATE_NOOP("files",
                               "Headings in \"%1\" are not shown: a map's own list has them in yaw_rad. "
                               "Importing the file reads them.")};

}  // namespace mapwright::robot::files::fault
