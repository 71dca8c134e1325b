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
/// because: why
inline constexpr FaultCode NotRead{"grids", QT_TRANSLATE_NOOP("grids", "It cannot be read.")};
inline constexpr FaultCode PictureKindUnknown{
    "grids",
    QT_TRANSLATE_NOOP("grids", "It is not a picture format that can be read as a map: PNG, PGM or BMP.")};
inline constexpr FaultCode PictureIsPointer{
    "grids", QT_TRANSLATE_NOOP(
                 "grids", "It is a pointer of Git LFS, not the picture itself (git lfs pull fetches it).")};
/// size
inline constexpr FaultCode PictureWithoutPixels{
    "grids", QT_TRANSLATE_NOOP("grids", "Its header says %1 pixels: it is empty.")};
/// size, the most along an edge, in all
inline constexpr FaultCode PictureTooLarge{
    "grids",
    QT_TRANSLATE_NOOP("grids",
                      "Its header says %1 pixels. A map may have at most %2 along an edge and %3 in total.")};
/// size, the most
inline constexpr FaultCode PictureTooLargeForLayer{
    "grids", QT_TRANSLATE_NOOP("grids", "It is %1 pixels, but at most %2 can be read.")};
/// rows that came, size; because: what ends it
inline constexpr FaultCode PictureEndsEarly{
    "grids", QT_TRANSLATE_N_NOOP(
                 "grids", "Its header says %2 pixels, but %3 after %1 rows. The rest is shown as unknown.")};
/// the same
inline constexpr FaultCode PictureEndsEarlyUnused{
    "grids", QT_TRANSLATE_N_NOOP("grids", "Its header says %2 pixels, but %3 after %1 rows.")};
/// size; because: what is wrong
inline constexpr FaultCode PictureDoubtful{
    "grids",
    QT_TRANSLATE_NOOP("grids", "It is %1 pixels and all rows are present, but %2. Some of it may be wrong.")};
inline constexpr FaultCode DataEnds{"grids", QT_TRANSLATE_NOOP("grids", "its data ends")};
inline constexpr FaultCode DataDamaged{"grids", QT_TRANSLATE_NOOP("grids", "its data is damaged")};
inline constexpr FaultCode PixelChecksumWrong{
    "grids", QT_TRANSLATE_NOOP("grids", "the checksum of its pixels is wrong")};
/// near which byte
inline constexpr FaultCode ChecksumWrong{
    "grids", QT_TRANSLATE_NOOP("grids", "a checksum in it is wrong (near byte %1)")};
inline constexpr FaultCode ReadingStopped{"grids", QT_TRANSLATE_NOOP("grids", "reading was cancelled")};
inline constexpr FaultCode NumberBeyondGreatest{
    "grids", QT_TRANSLATE_NOOP("grids", "a number exceeds the maximum in the header")};
inline constexpr FaultCode NotANumber{"grids", QT_TRANSLATE_NOOP("grids", "something in it is not a number")};
inline constexpr FaultCode BmpHeaderShort{"grids",
                                          QT_TRANSLATE_NOOP("grids", "It is a BMP whose header is cut off.")};
/// bytes of its header
inline constexpr FaultCode BmpHeaderUnknown{
    "grids", QT_TRANSLATE_NOOP(
                 "grids", "This kind of BMP is not supported (its header has %1 bytes). Save it as PNG.")};
inline constexpr FaultCode BmpWidthNegative{"grids",
                                            QT_TRANSLATE_NOOP("grids", "It is a BMP with a negative width.")};
/// bits a pixel
inline constexpr FaultCode BmpBitsUnknown{
    "grids", QT_TRANSLATE_NOOP("grids",
                               "It is a BMP with %1 bits per pixel; only 1, 4, 8, 24 and 32 bits, "
                               "uncompressed, are supported. Save it as PNG.")};
/// bits a pixel
inline constexpr FaultCode BmpCompressed{
    "grids", QT_TRANSLATE_NOOP("grids",
                               "It is a compressed BMP with %1 bits per pixel; only 1, 4, 8, 24 and 32 bits, "
                               "uncompressed, are supported. Save it as PNG.")};
inline constexpr FaultCode BmpColoursUneven{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a BMP whose colours are not whole bytes. Save it as PNG.")};
inline constexpr FaultCode BmpPaletteShort{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a BMP whose palette is cut off.")};
inline constexpr FaultCode PgmHeaderBroken{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PGM whose header is cut off or invalid.")};
/// its greatest gray
inline constexpr FaultCode PgmGreatestWrong{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PGM with a maximum gray of %1; it must be 1 to 65535.")};
inline constexpr FaultCode PngHeaderShort{"grids",
                                          QT_TRANSLATE_NOOP("grids", "It is a PNG whose header is cut off.")};
inline constexpr FaultCode PngHeaderMisplaced{
    "grids", QT_TRANSLATE_NOOP("grids", "It starts like a PNG, but its header is not in the right place.")};
inline constexpr FaultCode PngHeaderDamaged{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PNG with a damaged header (wrong checksum).")};
/// colour type, bits a sample
inline constexpr FaultCode PngKindUnknown{
    "grids",
    QT_TRANSLATE_NOOP(
        "grids", "It is a PNG of colour type %1 with %2 bits per sample, which the format does not allow.")};
inline constexpr FaultCode PngMethodUnknown{
    "grids", QT_TRANSLATE_NOOP(
                 "grids", "It is a PNG with a compression, filter or interlace method that does not exist.")};
inline constexpr FaultCode PngEndsBeforePixels{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PNG that is cut off before the first pixel.")};
inline constexpr FaultCode PngWithoutPixels{"grids",
                                            QT_TRANSLATE_NOOP("grids", "It is a PNG without pixels.")};
inline constexpr FaultCode PngPaletteDamaged{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PNG with a damaged palette (wrong checksum).")};
inline constexpr FaultCode PngTransparencyDamaged{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PNG with a damaged transparency chunk (wrong checksum).")};
inline constexpr FaultCode PngPartUnknown{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PNG with a critical chunk that is not in the standard.")};
inline constexpr FaultCode PngPaletteMissing{
    "grids", QT_TRANSLATE_NOOP("grids", "It is a PNG whose palette is missing.")};
/// size, bytes
inline constexpr FaultCode PngTooShortForPixels{
    "grids", QT_TRANSLATE_NOOP("grids", "Its header says %1 pixels, but its %2 bytes cannot hold so many.")};
/// size, the most bytes
inline constexpr FaultCode InterlacedTooLarge{
    "grids", QT_TRANSLATE_NOOP("grids",
                               "It is an interlaced picture of %1 pixels. Interlaced pictures are read up to "
                               "%2 bytes unpacked: save it without interlacing.")};
/// size
inline constexpr FaultCode InterlacedWithoutRoom{
    "grids",
    QT_TRANSLATE_NOOP(
        "grids",
        "It is an interlaced picture of %1 pixels, and there is not enough memory to unpack it. Save the "
        "picture without interlacing.")};
inline constexpr FaultCode CacheCopyLost{
    "grids", QT_TRANSLATE_NOOP("grids",
                               "The cached copy is damaged and the picture can no longer be read: parts of "
                               "it are missing. Open it again.")};

// Making and writing pictures.
inline constexpr FaultCode WritingStopped{"grids",
                                          QT_TRANSLATE_NOOP("grids", "Cancelled; nothing was written.")};
/// path
inline constexpr FaultCode EncoderFailed{
    "grids", QT_TRANSLATE_NOOP("grids", "The PNG %1 cannot be written: the encoder failed.")};
inline constexpr FaultCode ThresholdNotWithin{
    "grids", QT_TRANSLATE_NOOP("grids", "The thresholds of a map.yaml are numbers from 0 to 1.")};
/// the lower one, the upper one
inline constexpr FaultCode NoShadeForUnknown{
    "grids",
    QT_TRANSLATE_NOOP("grids",
                      "Between the thresholds %1 (free) and %2 (occupied) there is no gray level for "
                      "unknown cells.")};
/// path
inline constexpr FaultCode PictureOnlyRead{
    "grids",
    QT_TRANSLATE_NOOP("grids", "The picture %1 is neither PGM nor PNG: other formats are read-only.")};
/// path
inline constexpr FaultCode PictureOfOtherSize{
    "grids", QT_TRANSLATE_NOOP("grids", "The size of the picture %1 has changed.")};
/// path, the cell
inline constexpr FaultCode CellWithoutShade{
    "grids", QT_TRANSLATE_NOOP("grids", "No gray level of the picture %1 means %2 by its map.yaml.")};
/// path; because: why
inline constexpr FaultCode PictureReadsOtherwise{
    "grids", QT_TRANSLATE_NOOP("grids", "The picture %1 was written, but reads back differently")};

// Messages of ROS.
/// how many
inline constexpr FaultCode RosCellsOutOfRange{
    "grids",
    QT_TRANSLATE_N_NOOP("grids", "%1 cells are outside the range of -1 to 100. They are shown as unknown.")};

// The robot itself.
/// folder; because: why
inline constexpr FaultCode MapsNotKept{
    "grids", QT_TRANSLATE_NOOP("grids", "Temporary files of large maps cannot be kept in %1")};
inline constexpr FaultCode DiskMayBeFull{"grids", QT_TRANSLATE_NOOP("grids", "the disk may be full")};

// Small pictures for lists.
/// how many cells
inline constexpr FaultCode TooLargeForThumbnail{
    "grids", QT_TRANSLATE_NOOP("grids", "it has %1 cells, too many for a preview in a list")};

}  // namespace mapwright::grids::fault
