// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::files::fault {

using namespace mapwright::fault;  // what all rooms share

// Map files.
/// path
inline constexpr FaultCode NoSuchFile{"files", QT_TRANSLATE_NOOP("files", "There is no file %1.")};
/// path
inline constexpr FaultCode NotAFile{"files", QT_TRANSLATE_NOOP("files", "%1 is not a file.")};
/// path
inline constexpr FaultCode FileNotReadable{
    "files", QT_TRANSLATE_NOOP("files", "You are not allowed to read the file %1.")};
/// path; because: why
inline constexpr FaultCode FileNotOpened{"files", QT_TRANSLATE_NOOP("files", "%1 cannot be opened")};
/// because: why
inline constexpr FaultCode PictureNotReadable{
    "files", QT_TRANSLATE_NOOP("files", "Its picture cannot be read."), FaultCode::Causes::Sentence};
/// path
inline constexpr FaultCode PictureOutsideFolder{
    "files", QT_TRANSLATE_NOOP("files", "Its picture is outside its folder: %1.")};
inline constexpr FaultCode ResolutionAssumed{
    "files", QT_TRANSLATE_NOOP("files",
                               "A picture alone does not tell the size of its cells. 0.05 m is assumed; "
                               "append ?resolution=0.05 to the path to change it.")};
/// file name
inline constexpr FaultCode YamlBesideUnused{
    "files",
    QT_TRANSLATE_NOOP(
        "files",
        "%1 in the same folder does not name this picture as its image, or is not a valid map.yaml.")};
/// file names
inline constexpr FaultCode SeveralYamls{
    "files",
    QT_TRANSLATE_NOOP("files",
                      "Several map.yaml files name this picture, so none is used: %1. Open the right one.")};
/// file names, how many more
inline constexpr FaultCode SeveralYamlsAndMore{
    "files",
    QT_TRANSLATE_NOOP(
        "files",
        "Several map.yaml files name this picture, so none is used: %1 and %2 more. Open the right one.")};
inline constexpr FaultCode YamlTooLong{"files", QT_TRANSLATE_NOOP("files", "It is too long for a map.yaml.")};
inline constexpr FaultCode YamlIsNone{
    "files", QT_TRANSLATE_NOOP("files", "It is not a map.yaml: image, resolution and origin are missing.")};
/// line
inline constexpr FaultCode YamlBroken{"files", QT_TRANSLATE_NOOP("files", "It is not YAML (line %1).")};
inline constexpr FaultCode YamlWithoutImage{"files",
                                            QT_TRANSLATE_NOOP("files", "It does not name an image.")};
inline constexpr FaultCode YamlWithoutResolution{
    "files",
    QT_TRANSLATE_NOOP(
        "files",
        "It has no resolution, so the position of the map is unknown. Add for example: resolution: 0.05")};
inline constexpr FaultCode YamlWithoutOrigin{
    "files",
    QT_TRANSLATE_NOOP(
        "files",
        "It has no origin, so the position of the map is unknown. Add for example: origin: [0.0, 0.0, 0.0]")};
inline constexpr FaultCode OriginNoList{
    "files", QT_TRANSLATE_NOOP("files", "Its origin is not a list of x, y and yaw.")};
inline constexpr FaultCode OriginHoldsNoNumber{
    "files", QT_TRANSLATE_NOOP("files", "Its origin contains something that is not a number.")};
inline constexpr FaultCode OriginTurnNoNumber{
    "files", QT_TRANSLATE_NOOP("files", "The yaw of its origin is not a number; 0 is used.")};
inline constexpr FaultCode OriginShort{
    "files", QT_TRANSLATE_NOOP(
                 "files", "Its origin has two numbers, but map_server needs three. A yaw of 0 is used.")};
/// how many, what they are
inline constexpr FaultCode OriginLong{
    "files", QT_TRANSLATE_NOOP(
                 "files", "Its origin has %1 numbers, but map_server takes three. They were read as %2.")};
/// how many
inline constexpr FaultCode OriginCount{
    "files", QT_TRANSLATE_NOOP("files", "Its origin has %1 numbers. It must have three: x, y and yaw.")};
inline constexpr FaultCode NegateMissing{
    "files", QT_TRANSLATE_NOOP("files", "negate is missing, but map_server needs it; 0 is assumed.")};
inline constexpr FaultCode NegateUnknown{"files",
                                         QT_TRANSLATE_NOOP("files", "Its negate is neither 0 nor 1.")};
inline constexpr FaultCode ModeUnknown{
    "files", QT_TRANSLATE_NOOP("files", "Its mode is unknown. It must be trinary, scale or raw.")};
/// member, the value taken
inline constexpr FaultCode ThresholdMissing{
    "files", QT_TRANSLATE_NOOP("files", "%1 is missing, but map_server needs it; %2 is assumed.")};
/// member
inline constexpr FaultCode ThresholdNeeded{
    "files", QT_TRANSLATE_NOOP("files", "%1 is missing or no number, but map_server needs it in any mode.")};
/// member
inline constexpr FaultCode ThresholdNoNumber{
    "files", QT_TRANSLATE_NOOP("files", "Its %1 is not a number from 0 to 1.")};
inline constexpr FaultCode ThresholdsCrossed{
    "files", QT_TRANSLATE_NOOP(
                 "files", "Its free_thresh is not below its occupied_thresh, so no cell can be unknown.")};
/// id
inline constexpr FaultCode WaypointTurnNoNumber{
    "files",
    QT_TRANSLATE_NOOP("files", "The yaw_rad of waypoint %1 is not a number. It is shown without a heading.")};

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
/// the library's words
inline constexpr FaultCode FileNotJson{"files", QT_TRANSLATE_NOOP("files", "it is not JSON (%1)")};
inline constexpr FaultCode NotAFeatureCollection{
    "files", QT_TRANSLATE_NOOP("files", "it is not a GeoJSON FeatureCollection")};
inline constexpr FaultCode SeveralFeatureLists{
    "files", QT_TRANSLATE_NOOP("files", "it has more than one list of features")};
inline constexpr FaultCode TwoFeatureLists{"files",
                                           QT_TRANSLATE_NOOP("files", "it has two lists of features")};
/// crs
inline constexpr FaultCode WaypointsInDegrees{
    "files",
    QT_TRANSLATE_NOOP("files",
                      "its coordinates are longitude and latitude (crs %1), not metres of the map. If "
                      "they are metres, remove \"crs\" from it")};
/// property
inline constexpr FaultCode WaypointHeadingUnread{
    "files", QT_TRANSLATE_NOOP("files",
                               "Headings in \"%1\" are not shown: a map's own list has them in yaw_rad. "
                               "Importing the file reads them.")};
/// the most
inline constexpr FaultCode WaypointsTooMany{"files",
                                            QT_TRANSLATE_NOOP("files", "it has more than %1 waypoints")};
/// path
inline constexpr FaultCode FolderWithoutMaps{
    "files", QT_TRANSLATE_NOOP("files", "There are no maps (map.yaml, PNG, PGM, BMP) in %1.")};

}  // namespace mapwright::robot::files::fault
