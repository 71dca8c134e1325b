// What is found about whole maps and their pictures.
#include <QCoreApplication>

#include "sentences/words_by_code.h"

namespace mapwright::sentences {
namespace {

using map::ReasonCode;

class WordsOfMapsText {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

// One function for each group of codes.

QString ofPlaces(ReasonCode code) {
  switch (code) {
    case ReasonCode::ResolutionNoNumber:
      return WordsOfMapsText::tr("Its resolution is not a number, so it cannot be placed.");
    case ReasonCode::ResolutionNotPositive:
      return WordsOfMapsText::tr("Its resolution is %1, which is no size of a cell.");
    case ReasonCode::ResolutionOutOfBounds:
      return WordsOfMapsText::tr(
          "Its resolution of %1 m is out of bounds: between 0.1 mm and 1 km can be shown.");
    case ReasonCode::OriginNoNumber:
      return WordsOfMapsText::tr("Its origin is missing or not a number, so it cannot be placed.");
    case ReasonCode::OriginTooFar:
      return WordsOfMapsText::tr("Its origin lies farther than 10,000 km away, so it cannot be placed.");
    default:
      return {};
  }
}

QString ofMaps(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::SizesDiffer:
      return WordsOfMapsText::tr(
          "It is said to have %1 x %2 cells, but its picture has %3 x %4. It is shown as the picture has "
          "it.");
    case ReasonCode::SizesDisagree:
      return WordsOfMapsText::tr(
          "Its picture has %1 x %2 cells, but the robot says %3 x %4. Placed by the picture's own size.");
    case ReasonCode::TurnNoNumber:
      return WordsOfMapsText::tr("The turn of its origin is not a number. It is shown unturned.");
    case ReasonCode::CacheCopyDamaged:
      return WordsOfMapsText::tr(
          "Its copy in the cache was damaged. The map was read again from its picture.");
    case ReasonCode::AnotherMapCame:
      return WordsOfMapsText::tr("The robot answered with another map, %1. It is not shown.");
    case ReasonCode::FileNotHad:
      return WordsOfMapsText::tr("Shown without %1");
    case ReasonCode::RowsWithoutId:
      return WordsOfMapsText::tr("%1 rows without an id were left out.", nullptr, count);
    case ReasonCode::AnswerIsNoList:
      return WordsOfMapsText::tr("its answer is not a list");
    case ReasonCode::AnswerIsNoMap:
      return WordsOfMapsText::tr("the robot's answer is not a map");
    case ReasonCode::AnswerIsNoPicture:
      return WordsOfMapsText::tr("The robot's answer is no map picture, or is cut off.");
    case ReasonCode::NoPictureSent:
      return WordsOfMapsText::tr("The robot sent no picture.");
    case ReasonCode::AnswerIsNoJson:
      return WordsOfMapsText::tr("The robot's answer is not JSON, so it may not be an %1 robot.");
    case ReasonCode::AnswerHoldsNoData:
      return WordsOfMapsText::tr("its answer holds no data");
    case ReasonCode::MapsAreNoList:
      return WordsOfMapsText::tr("The robot's list of maps is not a list.");
    case ReasonCode::PointsAreNoList:
      return WordsOfMapsText::tr("The robot's list of points is not a list.");
    case ReasonCode::ScaleNotPositive:
      return WordsOfMapsText::tr(
          "Its resolution is missing or not above 0 pixels per metre, so it cannot be placed.");
    case ReasonCode::WrongMapSent:
      return WordsOfMapsText::tr("The robot sent the map %1 instead of it.");
    case ReasonCode::NoPictureOfItSent:
      return WordsOfMapsText::tr("The robot sent no picture of it.");
    case ReasonCode::PictureNotBase64:
      return WordsOfMapsText::tr("Its picture is not base64, or larger than 256 MB.");
    case ReasonCode::HeightNotSaid:
      return WordsOfMapsText::tr("Its picture is not a PNG, and the robot does not say how high it is.");
    case ReasonCode::PointOff:
      return WordsOfMapsText::tr(
          "Point %1 (%2): its pixels lie %3 px from its metres. Shown where its metres say.");
    case ReasonCode::PointsUnplaced:
      return WordsOfMapsText::tr("%1 points without a place were left out.", nullptr, count);
    case ReasonCode::MorePointsOff:
      return WordsOfMapsText::tr("%1 points more disagree with their pixels.", nullptr, count);
    default:
      return {};
  }
}

QString ofPictures(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::PictureEmpty:
      return WordsOfMapsText::tr("It is empty: there is no picture in it.");
    case ReasonCode::PictureFileNotOpened:
      return WordsOfMapsText::tr("The file %1 cannot be opened");
    case ReasonCode::NotRead:
      return WordsOfMapsText::tr("It cannot be read.");
    case ReasonCode::PictureKindUnknown:
      return WordsOfMapsText::tr("It is no picture that can be read as a map: neither PNG nor PGM nor BMP.");
    case ReasonCode::PictureWithoutPixels:
      return WordsOfMapsText::tr("It says that it is %1 pixels: there is nothing in it.");
    case ReasonCode::PictureTooLarge:
      return WordsOfMapsText::tr(
          "It says that it is %1 pixels. A map may have %2 along an edge and %3 in all.");
    case ReasonCode::PictureTooLargeForLayer:
      return WordsOfMapsText::tr("It is %1 pixels, and at most %2 are read.");
    case ReasonCode::PictureEndsEarly:
      return WordsOfMapsText::tr(
          "It says that it is %2 pixels, but %3 after %1 rows. The rest is shown as unknown.", nullptr,
          count);
    case ReasonCode::PictureEndsEarlyUnused:
      return WordsOfMapsText::tr("It says that it is %2 pixels, but %3 after %1 rows.", nullptr, count);
    case ReasonCode::PictureDoubtful:
      return WordsOfMapsText::tr("It is %1 pixels and all rows are there, but %2. Some of it may be wrong.");
    case ReasonCode::DataEnds:
      return WordsOfMapsText::tr("its data ends");
    case ReasonCode::DataDamaged:
      return WordsOfMapsText::tr("its data is damaged");
    case ReasonCode::PixelChecksumWrong:
      return WordsOfMapsText::tr("the checksum of its pixels is wrong");
    case ReasonCode::ChecksumWrong:
      return WordsOfMapsText::tr("a checksum in it is wrong (near byte %1)");
    case ReasonCode::ReadingStopped:
      return WordsOfMapsText::tr("reading it was stopped");
    case ReasonCode::NumberBeyondGreatest:
      return WordsOfMapsText::tr("it has a number beyond its greatest one");
    case ReasonCode::NotANumber:
      return WordsOfMapsText::tr("it has something that is no number");
    case ReasonCode::InterlacedTooLarge:
      return WordsOfMapsText::tr(
          "It is an interlaced picture of %1 pixels. Interlaced ones are read up to %2 bytes unpacked: save "
          "it without interlacing.");
    case ReasonCode::InterlacedWithoutRoom:
      return WordsOfMapsText::tr(
          "It is an interlaced picture of %1 pixels, and there is no room to put it together. Free space in "
          "the folder for temporary files, or save the picture without interlacing.");
    case ReasonCode::CacheCopyLost:
      return WordsOfMapsText::tr(
          "Its copy in the cache is damaged, and its picture can no longer be read: parts of it are missing. "
          "Open it again.");
    case ReasonCode::ResolutionNotAboveZero:
      return WordsOfMapsText::tr("The resolution must be more than 0.");
    case ReasonCode::NoSubmapToExport:
      return WordsOfMapsText::tr("There is no submap to export yet.");
    case ReasonCode::ComposedTooLarge:
      return WordsOfMapsText::tr(
          "The map is too large for one picture at this resolution. Choose a coarser one.");
    case ReasonCode::WritingStopped:
      return WordsOfMapsText::tr("Stopped; nothing was written.");
    case ReasonCode::EncoderFailed:
      return WordsOfMapsText::tr("The PNG %1 cannot be written: its encoder failed.");
    case ReasonCode::PictureNotEncoded:
      return WordsOfMapsText::tr("The picture for %1 cannot be encoded: %2.");
    case ReasonCode::PictureOnlyRead:
      return WordsOfMapsText::tr("The picture %1 is neither PGM nor PNG: such pictures are only read.");
    case ReasonCode::PictureOfOtherSize:
      return WordsOfMapsText::tr("The picture %1 has another size now.");
    case ReasonCode::CellWithoutShade:
      return WordsOfMapsText::tr("No gray of the picture %1 is read as a cell of %2 by its map.yaml.");
    case ReasonCode::PictureReadsOtherwise:
      return WordsOfMapsText::tr("The picture %1 was written, and is read back as another one");
    default:
      return {};
  }
}

QString ofPictureFormats(ReasonCode code) {
  switch (code) {
    case ReasonCode::BmpHeaderShort:
      return WordsOfMapsText::tr("It is a BMP that is cut off in its header.");
    case ReasonCode::BmpHeaderUnknown:
      return WordsOfMapsText::tr(
          "It is a BMP of a kind that is not read (its header has %1 bytes). Save it as PNG.");
    case ReasonCode::BmpWidthNegative:
      return WordsOfMapsText::tr("It is a BMP with a negative width.");
    case ReasonCode::BmpBitsUnknown:
      return WordsOfMapsText::tr(
          "It is a BMP with %1 bits a pixel; 1, 4, 8, 24 and 32 bits, uncompressed, are read. Save it as "
          "PNG.");
    case ReasonCode::BmpCompressed:
      return WordsOfMapsText::tr(
          "It is a BMP with %1 bits a pixel, compressed; 1, 4, 8, 24 and 32 bits, uncompressed, are read. "
          "Save it as PNG.");
    case ReasonCode::BmpColoursUneven:
      return WordsOfMapsText::tr("It is a BMP whose colours are not made of whole bytes. Save it as PNG.");
    case ReasonCode::BmpPaletteShort:
      return WordsOfMapsText::tr("It is a BMP that is cut off in its palette.");
    case ReasonCode::PgmHeaderBroken:
      return WordsOfMapsText::tr("It is a PGM whose header is cut off or no header.");
    case ReasonCode::PgmGreatestWrong:
      return WordsOfMapsText::tr("It is a PGM with %1 as its greatest gray; it must be 1 to 65535.");
    case ReasonCode::PngHeaderShort:
      return WordsOfMapsText::tr("It is a PNG that is cut off in its header.");
    case ReasonCode::PngHeaderMisplaced:
      return WordsOfMapsText::tr("It starts like a PNG, but its header is not where it has to be.");
    case ReasonCode::PngHeaderDamaged:
      return WordsOfMapsText::tr("It is a PNG whose header is damaged (its checksum is wrong).");
    case ReasonCode::PngKindUnknown:
      return WordsOfMapsText::tr(
          "It is a PNG of colour type %1 with %2 bits a sample, and there is no such PNG.");
    case ReasonCode::PngMethodUnknown:
      return WordsOfMapsText::tr(
          "It is a PNG with a compression, filter or interlace method that does not exist.");
    case ReasonCode::PngEndsBeforePixels:
      return WordsOfMapsText::tr("It is a PNG that is cut off before its first pixel.");
    case ReasonCode::PngWithoutPixels:
      return WordsOfMapsText::tr("It is a PNG without pixels.");
    case ReasonCode::PngPaletteDamaged:
      return WordsOfMapsText::tr("It is a PNG whose palette is damaged (its checksum is wrong).");
    case ReasonCode::PngTransparencyDamaged:
      return WordsOfMapsText::tr("It is a PNG whose transparency is damaged (its checksum is wrong).");
    case ReasonCode::PngPartUnknown:
      return WordsOfMapsText::tr("It is a PNG with a part that nobody but its writer understands.");
    case ReasonCode::PngPaletteMissing:
      return WordsOfMapsText::tr("It is a PNG with a palette, but the palette is missing.");
    case ReasonCode::PngTooShortForPixels:
      return WordsOfMapsText::tr("It says that it is %1 pixels, but its %2 bytes cannot hold so many.");
    default:
      return {};
  }
}

}  // namespace

QString wordsOfMaps(ReasonCode code, int count) {
  QString text;
  if (text.isEmpty()) text = ofPlaces(code);
  if (text.isEmpty()) text = ofMaps(code, count);
  if (text.isEmpty()) text = ofPictures(code, count);
  if (text.isEmpty()) text = ofPictureFormats(code);
  return text;
}

}  // namespace mapwright::sentences
