// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::cells::fault {

using namespace mapwright::fault;  // what all rooms share

// The cells of a slice.
/// bytes, as many as one byte a cell makes, as two make
inline constexpr FaultCode BytesUnexpected{
    "cells", QT_TRANSLATE_N_NOOP("cells", "%1 bytes where %2 (or %3) were expected")};
/// the most, as many as one byte a cell makes, as two make
inline constexpr FaultCode BytesTooMany{
    "cells", QT_TRANSLATE_NOOP("cells", "more than %1 bytes where %2 (or %3) were expected")};
/// its number
inline constexpr FaultCode CellFormatUnknown{
    "cells", QT_TRANSLATE_NOOP(
                 "cells", "cell format %1 is unknown: with one byte per cell only 0, 1 and 2 are supported")};
inline constexpr FaultCode GzipDamaged{"cells",
                                       QT_TRANSLATE_NOOP("cells", "the gzip data is damaged or cut off")};
inline constexpr FaultCode ZlibDamaged{"cells",
                                       QT_TRANSLATE_NOOP("cells", "the zlib data is damaged or cut off")};
/// size
inline constexpr FaultCode TextureEmpty{"cells",
                                        QT_TRANSLATE_NOOP("cells", "the texture claims to have %1 cells")};
/// size, the most cells
inline constexpr FaultCode TextureTooLarge{
    "cells", QT_TRANSLATE_NOOP("cells", "the texture claims to have %1 cells; at most %2 are allowed")};
inline constexpr FaultCode CellSizeNotPositive{
    "cells", QT_TRANSLATE_NOOP("cells", "the cell size is not a positive number of metres")};
inline constexpr FaultCode CellSizeTooSmall{"cells",
                                            QT_TRANSLATE_NOOP("cells", "the cell size is less than 0.1 mm")};
inline constexpr FaultCode CellSizeTooLarge{"cells",
                                            QT_TRANSLATE_NOOP("cells", "the cell size is more than 100 m")};
inline constexpr FaultCode PngNotRead{"cells", QT_TRANSLATE_NOOP("cells", "the PNG cannot be read")};
/// the library's words
inline constexpr FaultCode PngNotReadBy{"cells", QT_TRANSLATE_NOOP("cells", "the PNG cannot be read (%1)")};
inline constexpr FaultCode PngShort{"cells", QT_TRANSLATE_NOOP("cells", "the PNG header is cut off")};
inline constexpr FaultCode PngWithoutMemory{
    "cells", QT_TRANSLATE_NOOP("cells", "there is not enough memory to read the PNG")};
/// size, as announced
inline constexpr FaultCode PngOfOtherSize{"cells",
                                          QT_TRANSLATE_NOOP("cells", "the PNG is %1 but should be %2")};
/// bytes, size
inline constexpr FaultCode PngBytesTooFew{
    "cells", QT_TRANSLATE_NOOP("cells", "the PNG is cut off: %1 bytes are too few for %2 pixels")};

}  // namespace mapwright::cells::fault
