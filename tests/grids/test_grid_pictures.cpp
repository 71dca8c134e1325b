// Every kind of picture gives the cells that its pixels say; broken ones give a sentence and the rows that
// came.
#include <array>
#include <cmath>

#include <QtTest>

#include "grids/grid_pyramid.h"
#include "picture_samples.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_grid_pictures {

using namespace mapwright;
using namespace mapwright::grids;
using map::CellReading;
using test::PngRecipe;
using test::Samples;

namespace {

struct Read {
  std::shared_ptr<const GridPyramid> pyramid;
  std::string sentence;  // of open or read; empty = none
};

Read readAll(std::string bytes, const CellReading& reading = {}) {
  GridOptions options;
  options.reading = reading;
  auto opened = openGrid(test::shared(std::move(bytes)), options);
  if (!opened) return {nullptr, sentences::wordsOf(opened.error()).toStdString()};
  const std::atomic<bool> cancelled{false};
  const auto error = (*opened)->read(cancelled, {});
  return {(*opened)->pyramid(), error ? sentences::wordsOf(*error).toStdString() : std::string()};
}

CellReading readingOf(CellReading::Mode mode) {
  CellReading reading;
  reading.mode = mode;
  return reading;
}

/// The first cell that is not what expected(x, y) says; empty when all are.
QString difference(const Read& read, int width, int height, const std::function<int(int, int)>& expected) {
  if (!read.pyramid) return QString::fromStdString(read.sentence);
  if (read.pyramid->width() != width || read.pyramid->height() != height) return QStringLiteral("size");
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (read.pyramid->at(x, y) != expected(x, y)) {
        return QStringLiteral("column %1 row %2: %3 for %4")
            .arg(x)
            .arg(y)
            .arg(read.pyramid->at(x, y))
            .arg(expected(x, y));
      }
    }
  }
  return {};
}

Samples randomSamples(int width, int height, int channels, int depth) {
  Samples samples;
  for (int n = 0; n < width * height * channels; ++n) {
    samples.push_back(std::uint16_t(test::noise(std::uint32_t(n)) % (1u << depth)));
  }
  return samples;
}

std::string little(std::uint32_t number, int bytes) {
  std::string text;
  for (int n = 0; n < bytes; ++n, number >>= 8) text.push_back(char(number & 0xff));
  return text;
}

}  // namespace

class TestGridPictures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyPngTypeIsRead_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("depth");
    QTest::addColumn<bool>("interlaced");
    const std::vector<std::pair<int, std::vector<int>>> kinds{
        {0, {1, 2, 4, 8, 16}}, {2, {8, 16}}, {3, {1, 2, 4, 8}}, {4, {8, 16}}, {6, {8, 16}}};
    for (const auto& [type, depths] : kinds) {
      for (const int depth : depths) {
        for (const bool interlaced : {false, true}) {
          QTest::addRow("type %d, %d bits%s", type, depth, interlaced ? ", interlaced" : "")
              << type << depth << interlaced;
        }
      }
    }
  }
  void everyPngTypeIsRead() {
    QFETCH(int, type);
    QFETCH(int, depth);
    QFETCH(bool, interlaced);
    for (const auto& [width, height] : {std::pair{61, 43}, {1, 1}, {3, 2}, {7, 300}}) {
      PngRecipe recipe{width, height, depth, type, interlaced};
      if (type == 3) {
        for (int n = 0; n < 3 << depth; ++n)
          recipe.palette.push_back(char(test::noise(std::uint32_t(n) + 99)));
      }
      const int channels = test::pngChannels(type), largest = (1 << depth) - 1;
      const Samples samples = randomSamples(width, height, channels, depth);
      const auto expected = [&](int x, int y) {
        const std::uint16_t* at =
            samples.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels);
        if ((type == 4 || type == 6) && at[channels - 1] * 2 < largest) return int(kTransparentGray);
        double gray = at[0], scale = largest;
        if (type == 3) {
          const auto* colour = reinterpret_cast<const std::uint8_t*>(recipe.palette.data()) + 3 * at[0];
          gray = (colour[0] * 299 + colour[1] * 587 + colour[2] * 114) / 1000.0;
          scale = 255;
        } else if (channels >= 3) {
          gray = (at[0] * 299.0 + at[1] * 587.0 + at[2] * 114.0) / 1000.0;
        }
        return int(std::lround(gray / scale * 255));
      };
      const Read read = readAll(test::png(recipe, samples));
      QCOMPARE(read.sentence, std::string());
      QCOMPARE(difference(read, width, height, expected), QString());
    }
  }

  void everyFilterIsUndone_data() {
    QTest::addColumn<int>("type");
    for (const int type : {0, 2, 4, 6}) QTest::addRow("type %d", type) << type;
  }
  void everyFilterIsUndone() {
    QFETCH(int, type);
    const int channels = test::pngChannels(type);
    Samples samples = randomSamples(70, 40, channels, 8);
    if (type == 4 || type == 6) {
      for (std::size_t n = std::size_t(channels) - 1; n < samples.size(); n += std::size_t(channels))
        samples[n] = 255;
    }
    for (int filter = 0; filter < 5; ++filter) {
      PngRecipe recipe{70, 40, 8, type};
      recipe.filter = filter;
      const Read filtered = readAll(test::png(recipe, samples));
      recipe.filter = 0;
      const Read plain = readAll(test::png(recipe, samples));
      QCOMPARE(filtered.sentence, std::string());
      QCOMPARE(difference(filtered, 70, 40, [&](int x, int y) { return int(plain.pyramid->at(x, y)); }),
               QString());
    }
  }

  void transparentColoursAreUnknown() {
    const Samples grays{0, 10, 20, 255};
    PngRecipe recipe{4, 1, 8, 0};
    recipe.transparency = std::string("\0\x14", 2);
    QCOMPARE(difference(readAll(test::png(recipe, grays)), 4, 1,
                        [&](int x, int) { return x == 2 ? 128 : int(grays[std::size_t(x)]); }),
             QString());

    const Samples deep{0, 2570, 5140, 65535};
    recipe.depth = 16;
    recipe.transparency = std::string("\x14\x14", 2);
    QCOMPARE(difference(readAll(test::png(recipe, deep)), 4, 1,
                        [&](int x, int) { return x == 2 ? 128 : deep[std::size_t(x)] / 257; }),
             QString());

    const Samples colours{1, 2, 3, 9, 9, 9, 9, 9, 8, 0, 0, 0};
    PngRecipe rgb{4, 1, 8, 2};
    rgb.transparency = std::string("\0\x09\0\x09\0\x09", 6);
    QCOMPARE(difference(readAll(test::png(rgb, colours)), 4, 1,
                        [&](int x, int) {
                          return x == 0 ? 2 : x == 1 ? 128 : x == 2 ? 9 : 0;
                        }),
             QString());

    PngRecipe palette{3, 1, 8, 3};
    palette.palette = std::string("\x05\x05\x05\x64\x64\x64\xff\xff\xff", 9);
    palette.transparency = std::string("\xff\x10", 2);
    QCOMPARE(difference(readAll(test::png(palette, {0, 1, 2})), 3, 1,
                        [&](int x, int) { return x == 0   ? 5
                                                 : x == 1 ? 128
                                                          : 255; }),
             QString());
  }

  void grayAlphaIsReadAsNav2Does() {
    // nav2 sees three equal colours and alpha: trinary averages all four.
    PngRecipe recipe{3, 1, 8, 4};
    const Samples samples{0, 255, 0, 0, 255, 254};
    const Read trinary = readAll(test::png(recipe, samples), readingOf(CellReading::Mode::Trinary));
    // shade 0.25 -> occupied 0.75; shade 0 -> occupied 1; shade 0.999 -> free
    QCOMPARE(difference(trinary, 3, 1, [](int x, int) { return x == 2 ? 0 : 100; }), QString());
    const Read scale = readAll(test::png(recipe, samples), readingOf(CellReading::Mode::Scale));
    QCOMPARE(difference(scale, 3, 1, [](int x, int) { return x == 0 ? 100 : 255; }), QString());
    const Read raw = readAll(test::png(recipe, samples), readingOf(CellReading::Mode::Raw));
    QCOMPARE(difference(raw, 3, 1, [](int x, int) { return x == 2 ? 255 : 0; }), QString());
  }

  void pgmIsRead_data() {
    QTest::addColumn<int>("maxval");
    QTest::addColumn<bool>("plain");
    for (const int maxval : {1, 15, 100, 255, 256, 1000, 65535}) {
      QTest::addRow("P5 %d", maxval) << maxval << false;
      QTest::addRow("P2 %d", maxval) << maxval << true;
    }
  }
  void pgmIsRead() {
    QFETCH(int, maxval);
    QFETCH(bool, plain);
    const int width = 37, height = 21;
    std::string bytes = std::string(plain ? "P2" : "P5") +
                        "\n# made by map_saver 0.05 m/pix\n37 # columns\n21\n" + std::to_string(maxval) +
                        "\n";
    std::vector<int> levels;
    for (int n = 0; n < width * height; ++n) {
      levels.push_back(int(test::noise(std::uint32_t(n)) % std::uint32_t(maxval + 1)));
      if (plain) {
        bytes += std::to_string(levels.back()) + (n % 9 == 0 ? "\n" : n % 50 == 7 ? " # nine\n " : " ");
      } else {
        if (maxval > 255) bytes.push_back(char(levels.back() >> 8));
        bytes.push_back(char(levels.back()));
      }
    }
    const Read read = readAll(bytes);
    QCOMPARE(read.sentence, std::string());
    QCOMPARE(difference(read, width, height,
                        [&](int x, int y) {
                          return int(std::lround(levels[std::size_t(y * width + x)] * 255.0 / maxval));
                        }),
             QString());
  }

  void bmpIsRead_data() {
    QTest::addColumn<int>("bits");
    QTest::addColumn<bool>("top_down");
    for (const int bits : {1, 4, 8, 24, 32}) {
      QTest::addRow("%d bits", bits) << bits << false;
      QTest::addRow("%d bits, top down", bits) << bits << true;
    }
  }
  void bmpIsRead() {
    QFETCH(int, bits);
    QFETCH(bool, top_down);
    const int width = 13, height = 9, colours = bits <= 8 ? 1 << bits : 0;
    const std::uint32_t at = 54 + 4 * std::uint32_t(colours);
    std::string palette, pixels;
    const auto level = [&](int x, int y) {
      return int(test::noise(std::uint32_t(y * 100 + x)) % std::uint32_t(bits <= 8 ? colours : 256));
    };
    const auto grayOf = [&](int index) { return bits <= 8 ? index * 255 / (colours - 1) : index; };
    for (int n = 0; n < colours; ++n) palette += std::string(3, char(grayOf(n))) + '\0';
    for (int row = 0; row < height; ++row) {
      const int y = top_down ? row : height - 1 - row;
      std::string line;
      for (int x = 0; x < width; ++x) {
        if (bits >= 24) {
          line += std::string(3, char(level(x, y)));
          if (bits == 32) line.push_back(0);  // no alpha: it would hide everything
          continue;
        }
        const int in_byte = 8 / bits;
        if (x % in_byte == 0) line.push_back(0);
        line.back() = char(line.back() | level(x, y) << (8 - bits - x % in_byte * bits));
      }
      line.resize((line.size() + 3) / 4 * 4);
      pixels += line;
    }
    const std::string bytes = "BM" + little(at + std::uint32_t(pixels.size()), 4) + little(0, 4) +
                              little(at, 4) + little(40, 4) + little(width, 4) +
                              little(std::uint32_t(top_down ? -height : height), 4) + little(1, 2) +
                              little(std::uint32_t(bits), 2) + little(0, 24) + palette + pixels;
    const Read read = readAll(bytes);
    QCOMPARE(read.sentence, std::string());
    QCOMPARE(difference(read, width, height, [&](int x, int y) { return grayOf(level(x, y)); }), QString());
    for (std::size_t size = 0; size < bytes.size(); size += 11) readAll(bytes.substr(0, size));
  }

  /// As Pillow and OpenCV write it: 32 bits without masks.
  void aBmpWithAlphaReadsAsThePngOfTheSamePixels() {
    for (std::uint32_t round = 0; round < 40; ++round) {
      const int width = 1 + int(test::noise(round) % 9), height = 1 + int(test::noise(round + 100) % 9);
      Samples samples;
      std::string pixels;
      for (int n = 0; n < width * height; ++n) {
        const std::uint32_t seed = round * 1000 + std::uint32_t(n);
        const int gray = std::array{0, 205, 254, 100}[test::noise(seed) % 4];
        const int alpha = std::array{0, 1, 128, 254, 255}[test::noise(seed + 500) % 5];
        for (const int sample : {gray, gray, gray, n == 0 ? 255 : alpha})
          samples.push_back(std::uint16_t(sample));
      }
      for (int y = height - 1; y >= 0; --y) {
        for (int n = y * width * 4; n < (y + 1) * width * 4; ++n)
          pixels.push_back(char(samples[std::size_t(n)]));
      }
      const std::string bmp = "BM" + little(54 + std::uint32_t(pixels.size()), 4) + little(0, 4) +
                              little(54, 4) + little(40, 4) + little(std::uint32_t(width), 4) +
                              little(std::uint32_t(height), 4) + little(1, 2) + little(32, 2) +
                              little(0, 24) + pixels;
      for (const auto mode : {CellReading::Mode::Trinary, CellReading::Mode::Scale, CellReading::Mode::Raw,
                              CellReading::Mode::Picture}) {
        const Read png = readAll(test::png({width, height, 8, 6}, samples), readingOf(mode));
        const Read read = readAll(bmp, readingOf(mode));
        QCOMPARE(difference(read, width, height, [&](int x, int y) { return int(png.pyramid->at(x, y)); }),
                 QString());
      }
    }
  }

  void aPictureInAFileReadsTheSame() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a map.png"));
    const std::string bytes = test::png({500, 700}, test::roomGrays(500, 700));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes.data(), qint64(bytes.size()));
    file.close();
    auto opened = openGridFile(path.toStdString(), {});
    QVERIFY(opened);
    QVERIFY(!(*opened)->complete());
    int calls = 0;
    const std::atomic<bool> cancelled{false};
    QVERIFY(!(*opened)->read(cancelled, [&] { ++calls; }));
    QVERIFY((*opened)->complete());
    QVERIFY(calls >= 1);
    const Read memory = readAll(bytes);
    QCOMPARE(difference({(*opened)->pyramid(), {}}, 500, 700,
                        [&](int x, int y) { return int(memory.pyramid->at(x, y)); }),
             QString());
  }

  void whatIsNoFileIsASentence() {
    const auto none = openGridFile("/nowhere/at/all.png", {});
    QVERIFY(!none);
    QCOMPARE(none.error().arguments, (std::vector<FaultArgument>{"/nowhere/at/all.png"}));
    QVERIFY(!openGridFile("/", {}));
    QVERIFY(!openGridFile("/dev/zero", {}));
  }

  void aPointerOfGitLfsIsCalledSo() {
    const Read read = readAll(
        "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a214614ab2935c943f9e0ff69d22e\nsize "
        "12345\n");
    QVERIFY2(read.sentence.find("Git LFS") != std::string::npos, read.sentence.c_str());
    const Read other = readAll("version 2\n");
    QVERIFY2(other.sentence.find("Git LFS") == std::string::npos, other.sentence.c_str());
  }

  void readingCanBeCancelled() {
    for (const bool interlaced : {false, true}) {
      PngRecipe recipe{300, 3000};
      recipe.interlaced = interlaced;
      auto opened = openGrid(test::shared(test::png(recipe, test::roomGrays(300, 3000))), {});
      QVERIFY(opened);
      const std::atomic<bool> cancelled{true};
      QVERIFY(!(*opened)->read(cancelled, {}));
      QVERIFY(!(*opened)->complete());
      QVERIFY(!(*opened)->pyramid()->complete());
    }
  }
};

}  // namespace test_grid_pictures

MAPWRIGHT_TEST(test_grid_pictures, TestGridPictures, Core)
#include "test_grid_pictures.moc"
