#include <cmath>
#include <limits>

#include <QtTest>

#include "cells/decode_cells.h"
#include "packed_samples.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_decode_cells {

using namespace mapwright;
using namespace mapwright::cells;
using samples::Bytes;
using samples::Colour;

namespace {

enum CellFormat { LogOdds = 0, TsdfDelta = 1, Intensity = 2 };

/// The table of docs/protocols/cartographer-submaps.md, read literally.
CellPair expectedCell(int v, int cell_format) {
  if (v == 0) {
    return {};
  }
  if (cell_format == Intensity) {
    return {std::uint8_t(v), 255};
  }
  const int delta = cell_format == LogOdds ? 128 - v : v - 128;
  if (delta > 0) {
    return {std::uint8_t(delta), 0};
  }
  return delta < 0 ? CellPair{0, std::uint8_t(-delta)} : CellPair{0, 1};
}

Bytes everyByte() {
  Bytes bytes(256);
  for (std::size_t i = 0; i < 256; ++i) {
    bytes[i] = std::uint8_t(i * 37 + 11);  // a permutation, so that no container's signature comes first
  }
  return bytes;
}

QString sentenceOf(const Bytes& bytes, int width, int height, int cell_format = 0,
                   double resolution_m = 0.05) {
  const auto texture = decodeCells(bytes, width, height, resolution_m, cell_format);
  return texture ? QString() : sentences::wordsOf(texture.error());
}

Bytes wrapped(const Bytes& plain, const QByteArray& container) {
  if (container == "gzip") {
    return samples::deflated(plain, samples::kGzipBits);
  }
  if (container.startsWith("zlib")) {
    const int effort = container.mid(4).toInt();
    return samples::deflated(plain, samples::kZlibBits, effort);
  }
  if (container == "gzip of members") {
    const std::size_t cut = plain.size() / 3;
    Bytes all;
    for (const auto part :
         {std::span(plain).first(cut), std::span(plain).subspan(cut, 0), std::span(plain).subspan(cut)}) {
      const Bytes member = samples::deflated(part, samples::kGzipBits);
      all.insert(all.end(), member.begin(), member.end());
    }
    return all;
  }
  return plain;
}

const QByteArray kContainers[] = {"raw", "gzip", "gzip of members", "zlib0", "zlib5", "zlib6", "zlib9"};

}  // namespace

class TestDecodeCells : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsOneByteACell_data() {
    QTest::addColumn<QByteArray>("container");
    QTest::addColumn<int>("cell_format");
    for (const QByteArray& container : kContainers) {
      for (const int format : {LogOdds, TsdfDelta, Intensity}) {
        QTest::addRow("%s, format %d", container.constData(), format) << container << format;
      }
    }
  }
  void readsOneByteACell() {
    QFETCH(QByteArray, container);
    QFETCH(int, cell_format);
    const Bytes plain = everyByte();
    const auto texture = decodeCells(wrapped(plain, container), 16, 16, 0.05, cell_format);
    QVERIFY2(texture.has_value(), texture ? "" : qPrintable(sentences::wordsOf(texture.error())));
    QCOMPARE((*texture)->layout(), cell_format == Intensity ? CellLayout::Pairs : CellLayout::Folded);
    QCOMPARE((*texture)->observedCells(), std::size_t(255));
    for (int i = 0; i < 256; ++i) {
      QCOMPARE((*texture)->at(i % 16, i / 16), expectedCell(plain[std::size_t(i)], cell_format));
    }
  }

  void readsTwoBytesACellWhateverTheFormat_data() {
    QTest::addColumn<QByteArray>("container");
    QTest::addColumn<int>("cell_format");
    for (const QByteArray& container : kContainers) {
      for (const int format : {0, 1, 2, 99, -1}) {
        QTest::addRow("%s, format %d", container.constData(), format) << container << format;
      }
    }
  }
  void readsTwoBytesACellWhateverTheFormat() {
    QFETCH(QByteArray, container);
    QFETCH(int, cell_format);
    const auto cells = samples::blob(40, 30, 4);
    const auto texture =
        decodeCells(wrapped(samples::interleaved(cells), container), 40, 30, 0.02, cell_format);
    QVERIFY2(texture.has_value(), texture ? "" : qPrintable(sentences::wordsOf(texture.error())));
    QCOMPARE((*texture)->layout(), CellLayout::Folded);
    QCOMPARE((*texture)->resolutionM(), 0.02);
    for (int v = 0; v < 30; ++v) {
      for (int u = 0; u < 40; ++u) {
        QCOMPARE((*texture)->at(u, v), cells[std::size_t(v) * 40 + std::size_t(u)]);
      }
    }
  }

  void readsEveryKindOfPng_data() {
    QTest::addColumn<int>("colour");
    QTest::addColumn<int>("depth");
    QTest::addColumn<bool>("interlaced");
    for (const bool interlaced : {false, true}) {
      for (const auto& [colour, depths] :
           {std::pair{Colour::Gray, std::vector{1, 2, 4, 8, 16}},
            std::pair{Colour::Palette, std::vector{1, 2, 4, 8}},
            std::pair{Colour::GrayAlpha, std::vector{8, 16}}, std::pair{Colour::Rgb, std::vector{8, 16}},
            std::pair{Colour::Rgba, std::vector{8, 16}}}) {
        for (const int depth : depths) {
          QTest::addRow("colour type %d, %d bits%s", int(colour), depth, interlaced ? ", interlaced" : "")
              << int(colour) << depth << interlaced;
        }
      }
    }
  }
  void readsEveryKindOfPng() {
    QFETCH(int, colour);
    QFETCH(int, depth);
    QFETCH(bool, interlaced);
    // 1 x 1 up to sizes where every Adam7 pass has partial bytes.
    for (const auto& [width, height] :
         {std::pair{1, 1}, std::pair{3, 2}, std::pair{37, 21}, std::pair{64, 64}}) {
      const auto picture = samples::noise(width, height, Colour(colour), depth, interlaced);
      for (const int format : {LogOdds, TsdfDelta, Intensity}) {
        const auto texture = decodeCells(samples::png(picture), width, height, 0.05, format);
        QVERIFY2(texture.has_value(), texture ? "" : qPrintable(sentences::wordsOf(texture.error())));
        for (int v = 0; v < height; ++v) {
          for (int u = 0; u < width; ++u) {
            QCOMPARE((*texture)->at(u, v), cellOf(picture, u, v, format));
          }
        }
      }
    }
  }

  void refusesImpossibleAnnouncements() {
    const Bytes one{7};
    QCOMPARE(sentenceOf(one, 0, 5), QStringLiteral("the texture claims to have 0 x 5 cells"));
    QCOMPARE(sentenceOf(one, 5, -1), QStringLiteral("the texture claims to have 5 x -1 cells"));
    const int huge = std::numeric_limits<int>::max();
    QCOMPARE(sentenceOf(one, huge, huge),
             QStringLiteral("the texture claims to have 2,147,483,647 x 2,147,483,647 cells; at most "
                            "67,108,864 are allowed"));
    QVERIFY(sentenceOf(one, 65536, 65536).contains(QStringLiteral("at most 67,108,864")));
    QVERIFY(sentenceOf(one, 8193, 8192).contains(QStringLiteral("at most 67,108,864")));
    QCOMPARE(sentenceOf(one, 8192, 8192),
             QStringLiteral("1 byte where 67,108,864 (or 134,217,728) were expected"));
    QCOMPARE(sentenceOf(one, 1, 1, 0, 1e-300), QStringLiteral("the cell size is less than 0.1 mm"));
    for (const double resolution : {0.0, -0.05, std::nan(""), double(INFINITY), -double(INFINITY)}) {
      QCOMPARE(sentenceOf(one, 1, 1, 0, resolution),
               QStringLiteral("the cell size is not a positive number of metres"));
    }
    QCOMPARE(sentenceOf(one, 1, 1, 0, 101), QStringLiteral("the cell size is more than 100 m"));
    QCOMPARE(sentenceOf(one, 1, 1, 0, 100), QString());
  }

  void saysHowManyBytesWereExpected() {
    QCOMPARE(sentenceOf(Bytes(3200, 1), 256, 200),
             QStringLiteral("3,200 bytes where 51,200 (or 102,400) were expected"));
    QCOMPARE(sentenceOf({}, 4, 4), QStringLiteral("0 bytes where 16 (or 32) were expected"));
    for (const int window_bits : {samples::kGzipBits, samples::kZlibBits}) {
      QCOMPARE(sentenceOf(samples::deflated(Bytes(150, 9), window_bits), 10, 10),
               QStringLiteral("150 bytes where 100 (or 200) were expected"));
      QCOMPARE(sentenceOf(samples::deflated(Bytes(201, 9), window_bits), 10, 10),
               QStringLiteral("more than 200 bytes where 100 (or 200) were expected"));
    }
  }

  void refusesUnknownFormatsOfOneByte() {
    QCOMPARE(
        sentenceOf(Bytes(100, 5), 10, 10, 3),
        QStringLiteral("cell format 3 is unknown: with one byte per cell only 0, 1 and 2 are supported"));
    QVERIFY(sentenceOf(Bytes(100, 5), 10, 10, -7).startsWith(QStringLiteral("cell format -7 is unknown")));
    const auto picture = samples::noise(10, 10, Colour::Gray, 8, false);
    QVERIFY(sentenceOf(samples::png(picture), 10, 10, 1000).startsWith(QStringLiteral("cell format 1,000")));
    QCOMPARE(sentenceOf(samples::png(samples::noise(10, 10, Colour::GrayAlpha, 8, false)), 10, 10, 1000),
             QString());
  }

  void refusesAPngOfAnotherSize() {
    const auto picture = samples::noise(10, 12, Colour::Gray, 8, false);
    const auto expected = QStringLiteral("the PNG is %1 x %2 but should be %3");
    QCOMPARE(sentenceOf(samples::png(picture), 20, 20),
             expected.arg(10).arg(12).arg(QStringLiteral("20 x 20")));
    QCOMPARE(sentenceOf(samples::png(picture), 12, 10),
             expected.arg(10).arg(12).arg(QStringLiteral("12 x 10")));
    QCOMPARE(sentenceOf(samples::png(picture), 10, 11),
             expected.arg(10).arg(12).arg(QStringLiteral("10 x 11")));
    QCOMPARE(sentenceOf(samples::png(picture, 2000000000, 1000000000), 10, 12),
             expected.arg(QStringLiteral("2,000,000,000"), QStringLiteral("1,000,000,000"),
                          QStringLiteral("10 x 12")));
    // Even when its file has as many bytes as raw cells would have.
    const Bytes file = samples::png(picture);
    QVERIFY(sentenceOf(file, int(file.size()), 1).startsWith(QStringLiteral("the PNG is 10 x 12 but")));
  }

  void refusesWhatIsCutOffOrDamaged_data() {
    QTest::addColumn<QByteArray>("container");
    for (const char* container : {"gzip", "gzip of members", "zlib6", "png", "png interlaced"}) {
      QTest::addRow("%s", container) << QByteArray(container);
    }
  }
  void refusesWhatIsCutOffOrDamaged() {
    QFETCH(QByteArray, container);
    const auto picture = samples::noise(61, 59, Colour::GrayAlpha, 8, container == "png interlaced");
    const Bytes whole = container.startsWith("png")
                            ? samples::png(picture)
                            : wrapped(Bytes(picture.samples.begin(), picture.samples.end()), container);
    QCOMPARE(sentenceOf(whole, 61, 59), QString());
    const std::size_t pixels_end =
        whole.size() - (container.startsWith("png") ? 12 : 0);  // IEND does not matter
    for (std::size_t size = 2; size < pixels_end; size += 1 + size / 7) {
      const Bytes cut(whole.begin(), whole.begin() + std::ptrdiff_t(size));
      QVERIFY2(!sentenceOf(cut, 61, 59).isEmpty(), qPrintable(QString::number(size)));
    }
    Bytes flipped = whole;
    flipped[flipped.size() / 2] ^= 0x10;  // a checksum tells
    QVERIFY(!sentenceOf(flipped, 61, 59).isEmpty());
  }

  void takesCellsThatResembleAContainerAsRaw() {
    const Bytes beginnings[] = {{0x1F, 0x8B},
                                {0x1F, 0x8B, 8, 0},
                                {0x78, 0x01},
                                {0x78, 0x9C, 0x03},
                                {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'}};
    for (const Bytes& beginning : beginnings) {
      for (const std::size_t size : {std::size_t(100), std::size_t(200)}) {
        Bytes raw(size, 0x55);
        std::copy(beginning.begin(), beginning.end(), raw.begin());
        const auto texture = decodeCells(raw, 10, 10, 0.05, LogOdds);
        QVERIFY2(texture.has_value(), texture ? "" : qPrintable(sentences::wordsOf(texture.error())));
        const CellPair first = size == 100 ? expectedCell(raw[0], LogOdds) : CellPair{raw[0], raw[1]};
        QCOMPARE((*texture)->at(0, 0), first);
        raw.pop_back();
        QVERIFY(!sentenceOf(raw, 10, 10).isEmpty());
      }
    }
    // 78 02 is no zlib header, and without a valid check neither is 78 5D: raw from the start.
    QCOMPARE(sentenceOf({0x78, 0x02, 1}, 2, 2), QStringLiteral("3 bytes where 4 (or 8) were expected"));
  }

  void whatFollowsTheStreamIsIgnored() {
    for (const char* container : {"gzip", "zlib6"}) {
      Bytes bytes = wrapped(everyByte(), container);
      bytes.insert(bytes.end(), 9, std::uint8_t(0));
      QCOMPARE(sentenceOf(bytes, 16, 16), QString());
    }
  }

 private:
  static CellPair cellOf(const samples::Picture& picture, int u, int v, int cell_format) {
    const std::size_t channels = std::size_t(samples::channelsOf(picture.colour));
    const std::uint16_t* sample =
        &picture.samples[(std::size_t(v) * std::size_t(picture.width) + std::size_t(u)) * channels];
    const auto byte = [&](std::size_t channel) {
      return picture.depth == 16 ? sample[channel] / 256 : int(sample[channel]);
    };
    switch (picture.colour) {
      case Colour::Gray: {
        const int largest = picture.depth >= 8 ? 255 : (1 << picture.depth) - 1;
        return expectedCell(byte(0) * 255 / largest, cell_format);
      }
      case Colour::Palette:
        return expectedCell(byte(0), cell_format);
      case Colour::GrayAlpha:
        return {std::uint8_t(byte(0)), std::uint8_t(byte(1))};
      default: {
        const int luminance = (299 * byte(0) + 587 * byte(1) + 114 * byte(2) + 500) / 1000;
        return {std::uint8_t(luminance), std::uint8_t(picture.colour == Colour::Rgba ? byte(3) : 255)};
      }
    }
  }
};

}  // namespace test_decode_cells

MAPWRIGHT_TEST(test_decode_cells, TestDecodeCells, Core)
#include "test_decode_cells.moc"
