// Hostile and broken input: bombs, noise, and valid files with some bytes changed.
#include <sys/resource.h>

#include <QtTest>

#include "cells/decode_cells.h"
#include "packed_samples.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_decode_garbage {

using namespace mapwright;
using namespace mapwright::cells;
using samples::Bytes;
using samples::Colour;

namespace {

long peakKilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// A stream that unpacks to a gigabyte of zeros: the same packed megabyte over and over.
Bytes gigabyteOfZeros(int window_bits) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
  const Bytes zeros(std::size_t(1) << 20);
  Bytes megabyte(std::size_t(1) << 16);
  stream.next_in = const_cast<Bytef*>(zeros.data());
  stream.avail_in = uInt(zeros.size());
  stream.next_out = megabyte.data();
  stream.avail_out = uInt(megabyte.size());
  deflate(&stream, Z_FULL_FLUSH);
  megabyte.erase(megabyte.end() - std::ptrdiff_t(stream.avail_out), megabyte.end());
  deflateEnd(&stream);

  Bytes packed =
      window_bits == samples::kGzipBits ? Bytes{0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 0, 3} : Bytes{0x78, 0x9C};
  for (int i = 0; i < 1024; ++i) {
    packed.insert(packed.end(), megabyte.begin(), megabyte.end());
  }
  packed.insert(packed.end(), {3, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  return packed;
}

/// A small picture with a compressed text that unpacks to a gigabyte.
Bytes pngWithTextBomb(const Bytes& zlib_bomb) {
  Bytes file = samples::png(samples::noise(10, 10, Colour::Gray, 8, false));
  Bytes text{'C', 'o', 'm', 'm', 'e', 'n', 't', 0, 0};
  text.insert(text.end(), zlib_bomb.begin(), zlib_bomb.end());
  Bytes chunk;
  samples::appendChunk(chunk, "zTXt", text);
  file.insert(file.begin() + 33, chunk.begin(), chunk.end());
  return file;
}

}  // namespace

class TestDecodeGarbage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bombsCostNoMoreThanTheCells() {
    const Bytes gzip_bomb = gigabyteOfZeros(samples::kGzipBits);
    const Bytes zlib_bomb = gigabyteOfZeros(samples::kZlibBits);
    const Bytes text_bomb = pngWithTextBomb(zlib_bomb);
    const Bytes pixel_bomb = [&] {
      Bytes file = samples::png(samples::noise(1, 1, Colour::Gray, 8, false), 20, 20);
      Bytes chunk;
      samples::appendChunk(chunk, "IDAT", zlib_bomb);
      file.erase(file.begin() + 33, file.end());
      file.insert(file.end(), chunk.begin(), chunk.end());
      return file;
    }();
    const long before = peakKilobytes();
    for (const Bytes* bomb : {&gzip_bomb, &zlib_bomb}) {
      const auto texture = decodeCells(*bomb, 20, 20, 0.05, 0);
      QVERIFY(!texture.has_value());
      QCOMPARE(sentences::wordsOf(texture.error()),
               QStringLiteral("more than 800 bytes where 400 (or 800) were expected"));
    }
    static_cast<void>(decodeCells(text_bomb, 10, 10, 0.05, 0));
    static_cast<void>(decodeCells(pixel_bomb, 20, 20, 0.05, 0));
    QVERIFY2(peakKilobytes() - before < 32 * 1024, qPrintable(QString::number(peakKilobytes() - before)));
  }

  void announcedSizesAloneTakeNoMemory() {
    const Bytes small = samples::deflated(Bytes(64, 1), samples::kGzipBits);
    const Bytes png = samples::png(samples::noise(4, 4, Colour::Rgba, 16, false), 8192, 8192);
    const long before = peakKilobytes();
    QVERIFY(!decodeCells(small, 8192, 8192, 0.05, 0).has_value());
    QVERIFY(!decodeCells(png, 8192, 8192, 0.05, 0).has_value());
    QVERIFY2(peakKilobytes() - before < 16 * 1024, qPrintable(QString::number(peakKilobytes() - before)));
  }

  void noiseIsTakenByItsSizeAlone() {
    std::minstd_rand random(2024);
    const Bytes beginnings[] = {
        {},
        {0x1F, 0x8B, 8},
        {0x78, 0x9C},
        {0x78, 0x01},
        {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'},
        {0x78, 0xDA},
    };
    int taken = 0;
    for (int round = 0; round < 4000; ++round) {
      const int width = 1 + int(random() % 40);
      const int height = 1 + int(random() % 40);
      const std::size_t cells = std::size_t(width) * std::size_t(height);
      const std::size_t sizes[] = {cells, 2 * cells, std::size_t(random() % 4000), cells + 1};
      Bytes bytes(sizes[random() % 4]);
      for (std::uint8_t& byte : bytes) {
        byte = std::uint8_t(random() >> 8);
      }
      const Bytes& beginning = beginnings[random() % std::size(beginnings)];
      std::copy_n(beginning.begin(), std::min(beginning.size(), bytes.size()), bytes.begin());
      const int format = int(random() % 3);
      const auto texture = decodeCells(bytes, width, height, 0.05, format);
      const bool fits = bytes.size() == cells || bytes.size() == 2 * cells;
      QCOMPARE(texture.has_value(), fits);
      if (texture) {
        ++taken;
        for (int level = 0; level < (*texture)->levels(); ++level) {
          QVERIFY((*texture)->expand(level).width >= 1);
        }
      } else {
        QVERIFY(!sentences::wordsOf(texture.error()).isEmpty());
      }
    }
    QVERIFY(taken > 1000 && taken < 3500);
  }

  void changedFilesAreReadOrRefused() {
    std::minstd_rand random(77);
    const auto gray = samples::noise(33, 29, Colour::Gray, 4, true);
    const auto colour = samples::noise(33, 29, Colour::Rgba, 16, false);
    const auto palette = samples::noise(33, 29, Colour::Palette, 2, false);
    const Bytes cells = samples::interleaved(samples::blob(33, 29, 1));
    const Bytes files[] = {samples::png(gray), samples::png(colour), samples::png(palette),
                           samples::deflated(cells, samples::kGzipBits),
                           samples::deflated(cells, samples::kZlibBits)};
    int refused = 0;
    for (int round = 0; round < 4000; ++round) {
      Bytes bytes = files[random() % std::size(files)];
      const int changes = 1 + int(random() % 4);
      for (int i = 0; i < changes; ++i) {
        bytes[random() % bytes.size()] = std::uint8_t(random() >> 8);
      }
      if (random() % 4 == 0) {
        bytes.resize(random() % bytes.size());
      }
      const auto texture = decodeCells(bytes, 33, 29, 0.05, int(random() % 4));
      if (texture) {
        QCOMPARE((*texture)->width(), 33);
        QCOMPARE((*texture)->height(), 29);
      } else {
        ++refused;
        QVERIFY(!sentences::wordsOf(texture.error()).isEmpty());
      }
    }
    QVERIFY(refused > 2000);
  }
};

}  // namespace test_decode_garbage

MAPWRIGHT_TEST(test_decode_garbage, TestDecodeGarbage, Core)
#include "test_decode_garbage.moc"
