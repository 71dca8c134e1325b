// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::pbstream::fault {

using namespace mapwright::fault;  // what all rooms share

/// path
inline constexpr FaultCode NoStateFile{"pbstream",
                                       QT_TRANSLATE_NOOP("pbstream", "%1 is not a Cartographer state file.")};
/// format version
inline constexpr FaultCode VersionNotSupported{
    "pbstream",
    QT_TRANSLATE_NOOP("pbstream",
                      "It is a Cartographer state file of version %1. Versions 1 and 2 can be read. "
                      "cartographer_migrate_serialization_format converts older ones.")};
inline constexpr FaultCode NotReadable{
    "pbstream", QT_TRANSLATE_NOOP("pbstream", "it is not the message that it should be")};
/// number of the field
inline constexpr FaultCode WrongType{
    "pbstream", QT_TRANSLATE_NOOP("pbstream", "field %1 has another type than in Cartographer's own files")};
/// record, byte
inline constexpr FaultCode CutOff{
    "pbstream",
    QT_TRANSLATE_NOOP("pbstream", "The file is cut off in record %1 at byte %2: what follows is missing.")};
inline constexpr FaultCode Cancelled{"pbstream", QT_TRANSLATE_NOOP("pbstream", "it was cancelled")};

}  // namespace mapwright::pbstream::fault
