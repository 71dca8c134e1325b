// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::grids::fault {

using namespace mapwright::fault;  // what all rooms share

// The pictures of whole maps. Sizes are texts: "400 x 300".
inline constexpr FaultCode PictureEmpty{"grids",
                                        QT_TRANSLATE_NOOP("grids", "It is empty: it contains no picture.")};
/// path; because: why
inline constexpr FaultCode PictureFileNotOpened{"grids",
                                                QT_TRANSLATE_NOOP("grids", "The file %1 cannot be opened")};
/// size, the most along an edge, in all
inline constexpr FaultCode PictureTooLarge{
    "grids",
    QT_TRANSLATE_NOOP("grids",
                      "Its header says %1 pixels. A map may have at most %2 along an edge and %3 in total.")};
/// rows that came, size; because: what ends it
inline constexpr FaultCode PictureEndsEarly{
    "grids", QT_TRANSLATE_N_NOOP(
                 "grids", "Its header says %2 pixels, but %3 after %1 rows. The rest is shown as unknown.")};
/// the same
inline constexpr FaultCode PictureEndsEarlyUnused{
    "grids", QT_TRANSLATE_N_NOOP("grids", "Its header says %2 pixels, but %3 after %1 rows.")};
inline constexpr FaultCode DataEnds{"grids", QT_TRANSLATE_NOOP("grids", "its data ends")};
inline constexpr FaultCode DataDamaged{"grids", QT_TRANSLATE_NOOP("grids", "its data is damaged")};
inline constexpr FaultCode PixelChecksumWrong{
    "grids", QT_TRANSLATE_NOOP("grids", "the checksum of its pixels is wrong")};
inline constexpr FaultCode BmpHeaderShort{"grids",
                                          QT_TRANSLATE_NOOP("grids", "It is a BMP whose header is cut off.")};
inline constexpr FaultCode PngHeaderShort{"grids",
                                          QT_TRANSLATE_NOOP("grids", "It is a PNG whose header is cut off.")};
inline constexpr FaultCode PngEndsBeforePixels{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PNG that is cut off before the first pixel.")};

// Making and writing pictures.
inline constexpr FaultCode WritingStopped{"grids",
                                          QT_TRANSLATE_NOOP("grids", "Cancelled; nothing was written.")};
/// path
inline constexpr FaultCode EncoderFailed{
    "grids", QT_TRANSLATE_NOOP("grids", "The PNG %1 cannot be written: the encoder failed.")};
/// path
inline constexpr FaultCode PictureOfOtherSize{
    "grids", QT_TRANSLATE_NOOP("grids", "The size of the picture %1 has changed.")};

// Messages of ROS.
/// how many
inline constexpr FaultCode RosCellsOutOfRange{
    "grids",
    QT_TRANSLATE_N_NOOP("grids", "%1 cells are outside the range of -1 to 100. They are shown as unknown.")};

// Small pictures for lists.
/// how many cells
inline constexpr FaultCode TooLargeForThumbnail{
    "grids", QT_TRANSLATE_NOOP("grids", "it has %1 cells, too many for a preview in a list")};

}  // namespace mapwright::grids::fault
