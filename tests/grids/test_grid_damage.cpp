// Broken, lying and hostile pictures: a sentence that says what is wrong, the rows that came, bounded memory.
#include <QtTest>

#include "grids/grid_pyramid.h"
#include "picture_samples.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_grid_damage {

using namespace mapwright;
using namespace mapwright::grids;
using test::PngRecipe;
using test::Samples;

namespace {

struct Read {
  std::shared_ptr<const GridPyramid> pyramid;
  std::string opening, reading;  // sentences; empty = none
};

Read readAll(std::string bytes) {
  const auto shared = test::shared(std::move(bytes));
  auto opened = openGrid(shared, {});
  if (!opened) return {nullptr, sentences::wordsOf(opened.error()).toStdString(), {}};
  const std::atomic<bool> cancelled{false};
  auto error = (*opened)->read(cancelled, {});
  GridOptions again;
  again.code = (*opened)->otherCode();
  if (again.code) {
    opened = openGrid(shared, again);
    error = (*opened)->read(cancelled, {});
  }
  return {(*opened)->pyramid(), {}, error ? sentences::wordsOf(*error).toStdString() : std::string()};
}

bool says(const std::string& sentence, const char* words) {
  return sentence.find(words) != std::string::npos;
}

/// Rows from the top that are as in `samples`.
int rowsAsIn(const GridPyramid& pyramid, const Samples& samples) {
  for (int y = 0; y < pyramid.height(); ++y) {
    for (int x = 0; x < pyramid.width(); ++x) {
      if (pyramid.at(x, y) != samples[std::size_t(y) * std::size_t(pyramid.width()) + std::size_t(x)])
        return y;
    }
  }
  return pyramid.height();
}

/// A picture of one gray that says it is of this size; only `rows` of them are packed.
std::string uniformPng(int width, int height, int rows, std::uint8_t gray) {
  PngRecipe recipe{width, height};
  recipe.chunk = 1 << 20;
  z_stream stream{};
  deflateInit(&stream, 6);
  std::string row(std::size_t(width) + 1, char(gray)), packed, out(1 << 16, '\0');
  row[0] = 0;
  for (int y = 0; y <= rows; ++y) {
    stream.next_in = reinterpret_cast<Bytef*>(row.data());
    stream.avail_in = y < rows ? uInt(row.size()) : 0;
    do {
      stream.next_out = reinterpret_cast<Bytef*>(out.data());
      stream.avail_out = uInt(out.size());
      deflate(&stream, y < rows ? Z_NO_FLUSH : Z_FINISH);
      packed.append(out, 0, out.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  }
  deflateEnd(&stream);
  return test::pngHead(recipe) + test::pngTail(recipe, packed);
}

}  // namespace

class TestGridDamage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPictureCutOffAnywhereKeepsTheRowsThatCame_data() {
    QTest::addColumn<bool>("interlaced");
    QTest::newRow("plain") << false;
    QTest::newRow("interlaced") << true;
  }
  void aPictureCutOffAnywhereKeepsTheRowsThatCame() {
    QFETCH(bool, interlaced);
    PngRecipe recipe{300, 400};
    recipe.interlaced = interlaced;
    const Samples samples = test::roomGrays(300, 400);
    const std::string whole = test::png(recipe, samples);
    int most = 0;
    for (std::size_t size = 0; size < whole.size(); size += 100) {
      const Read read = readAll(whole.substr(0, size));
      if (!read.pyramid) {
        QVERIFY2(!read.opening.empty(), qPrintable(QString::number(size)));
        continue;
      }
      QVERIFY(read.pyramid->complete());
      const int rows = rowsAsIn(*read.pyramid, samples);
      if (rows == 400) continue;  // only the trailer is missing
      QVERIFY2(says(read.reading, "its data ends after"), read.reading.c_str());
      QVERIFY2(says(read.reading, "300 x 400"), read.reading.c_str());
      QVERIFY(rows >= most || interlaced);
      most = std::max(most, rows);
      QCOMPARE(int(read.pyramid->at(5, 399)), int(kTransparentGray));
    }
    QVERIFY2(most > (interlaced ? 200 : 350), qPrintable(QString::number(most)));
  }

  void pgmAndBmpCutOffAnywhereNeverCrash() {
    std::string pgm = "P5 # a map\n50 60\n255\n" + std::string(3000, '\x20');
    std::string plain = "P2\n50 60\n255\n";
    for (int n = 0; n < 3000; ++n) plain += "17 ";
    for (const std::string& whole : {pgm, plain}) {
      for (std::size_t size = 0; size + 60 < whole.size(); size += 13) {
        const Read read = readAll(whole.substr(0, size));
        QVERIFY(!read.opening.empty() || says(read.reading, "ends after"));
      }
      QVERIFY(readAll(whole).reading.empty());
      QVERIFY(readAll(whole + "trailing").reading.empty());
    }
  }

  void aSizeThatLiesCostsNothing() {
    const Read read = readAll(uniformPng(60'000, 60'000, 10, 77));
    QVERIFY(read.pyramid);
    QVERIFY2(says(read.reading, "60,000 x 60,000"), read.reading.c_str());
    QVERIFY2(says(read.reading, "after 10 rows"), read.reading.c_str());
    QVERIFY(read.pyramid->complete());
    QCOMPARE(int(read.pyramid->at(59'999, 9)), 77);
    QCOMPARE(int(read.pyramid->at(0, 10)), int(kTransparentGray));
    QVERIFY2(read.pyramid->bytes() < 20'000'000, qPrintable(QString::number(read.pyramid->bytes())));
  }

  void anInterlacedSizeThatLiesIsRefusedAtOnce() {
    PngRecipe recipe{60'000, 60'000, 16, 6, true};
    const Read read =
        readAll(test::pngHead(recipe) + test::pngTail(recipe, test::deflated(std::string(900, 'x'), 6)));
    QVERIFY2(says(read.opening, "cannot hold"), read.opening.c_str());
  }

  void anInterlacedBombIsRefusedBeforeItTakesRoom_data() {
    QTest::addColumn<int>("edge");
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("depth");
    QTest::addColumn<bool>("read");
    QTest::newRow("one bit a pixel") << 60'000 << 0 << 1 << false;
    QTest::newRow("just too large") << 16'385 << 0 << 1 << false;
    QTest::newRow("wide pixels") << 8'200 << 6 << 8 << false;
    QTest::newRow("deep pixels") << 5'800 << 6 << 16 << false;
    QTest::newRow("large") << 3'000 << 6 << 8 << true;
  }
  void anInterlacedBombIsRefusedBeforeItTakesRoom() {
    QFETCH(int, edge);
    QFETCH(int, type);
    QFETCH(int, depth);
    QFETCH(bool, read);
    PngRecipe recipe{edge, edge, depth, type, true};
    recipe.chunk = 1 << 20;
    const std::size_t bits = std::size_t(test::pngChannels(type) * depth);
    const std::size_t zeros = std::size_t(edge) * std::size_t(edge) * bits / 8 + 4 * std::size_t(edge) + 4096;
    std::string bytes = test::pngHead(recipe);
    if (read) {
      bytes += test::pngTail(recipe, test::deflated(std::string(zeros, '\0'), 1));
    } else {
      // As long as the file would be that holds so many zeros.
      bytes += test::pngTail(recipe, test::deflated(std::string(100'000, '\0'), 1)) +
               std::string(zeros / 1000, 'x');
    }
    const Read got = readAll(bytes);
    QCOMPARE(got.pyramid != nullptr, read);
    if (!read) {
      QVERIFY2(says(got.opening, "without interlacing"), got.opening.c_str());
      QVERIFY2(says(got.opening, "268,435,456"), got.opening.c_str());
    } else {
      QCOMPARE(got.reading, std::string());
    }
  }

  void headersThatPromiseMuchCostNothing() {
    const std::string pgm = "P5 400000 85000 255\n" + std::string(400'000, '\x20');
    const std::string plain = "P2 400000 85000 255\n7 7 7";
    std::string bmp(14 + 40 + 1024 + 4000, '\0');
    const auto put = [&bmp](std::size_t at, std::uint32_t number) {
      for (std::size_t n = 0; n < 4; ++n) bmp[at + n] = char(number >> 8 * n & 0xff);
    };
    bmp[0] = 'B';
    bmp[1] = 'M';
    put(10, 14 + 40 + 1024);
    put(14, 40);
    put(18, 400'000);
    put(22, std::uint32_t(-85'000));
    bmp[26] = 1;
    bmp[28] = 8;
    for (const std::string& bytes : {pgm, plain, bmp}) {
      const Read read = readAll(bytes);
      QVERIFY2(read.pyramid, read.opening.c_str());
      QVERIFY2(says(read.reading, "400,000 x 85,000"), read.reading.c_str());
      QVERIFY2(read.pyramid->bytes() < 50'000'000, qPrintable(QString::number(read.pyramid->bytes())));
    }
  }

  void aBombIsReadUpToTheRowsItSays() {
    const Read read = readAll(uniformPng(8000, 8000, 30'000, 255));
    QCOMPARE(read.reading, std::string());
    QCOMPARE(read.pyramid->height(), 8000);
    QVERIFY(read.pyramid->bytes() < 2'000'000);
  }

  void emptyAndAbsurdSizesAreSentences_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<QString>("words");
    QTest::newRow("nothing") << 0 << 5 << QStringLiteral("it is empty");
    QTest::newRow("no rows") << 5 << 0 << QStringLiteral("it is empty");
    QTest::newRow("wide") << 400'001 << 1 << QStringLiteral("400,000 along an edge");
    QTest::newRow("high") << 1 << 2'147'483'647 << QStringLiteral("2,147,483,647");
    QTest::newRow("many") << 399'999 << 399'999 << QStringLiteral("34,359,738,368 in total");
    QTest::newRow("negative") << -1 << -1 << QStringLiteral("4,294,967,295");
  }
  void emptyAndAbsurdSizesAreSentences() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(QString, words);
    PngRecipe recipe{width, height};
    const Read read = readAll(test::pngHead(recipe) + test::pngTail(recipe, test::deflated("x", 6)));
    QVERIFY2(says(read.opening, words.toUtf8().constData()), read.opening.c_str());
    if (width < 0) return;
    const std::string pgm = "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
    QVERIFY2(says(readAll(pgm).opening, words.toUtf8().constData()), readAll(pgm).opening.c_str());
  }

  void aWrongChecksumIsSaid() {
    const Samples samples = test::roomGrays(300, 400);
    PngRecipe recipe{300, 400};
    std::string bytes = test::png(recipe, samples);
    bytes[bytes.size() - 20] = char(bytes[bytes.size() - 20] ^ 1);  // the last IDAT's checksum
    QVERIFY(!readAll(bytes).reading.empty());
    bytes = test::png(recipe, samples);
    bytes[bytes.find("IDAT") + 1004] = char(bytes[bytes.find("IDAT") + 1004] ^ 1);  // the first one's
    const Read read = readAll(bytes);
    QVERIFY2(says(read.reading, "a checksum in it is wrong"), read.reading.c_str());
    QVERIFY(rowsAsIn(*read.pyramid, samples) > 0);
    bytes = test::png(recipe, samples);
    bytes[20] = char(bytes[20] ^ 1);
    QVERIFY2(says(readAll(bytes).opening, "damaged header"), readAll(bytes).opening.c_str());
  }

  void aWrongPixelChecksumIsSaid() {
    const Samples samples = test::roomGrays(50, 40);
    PngRecipe recipe{50, 40};
    std::string packed = test::deflated(test::pngPass(recipe, samples, 0, 0, 1, 1), 6);
    packed.back() = char(packed.back() ^ 1);
    const Read read = readAll(test::pngHead(recipe) + test::pngTail(recipe, packed));
    QVERIFY2(says(read.reading, "checksum"), read.reading.c_str());
    QCOMPARE(rowsAsIn(*read.pyramid, samples), 40);
  }

  void aFilterThatDoesNotExistIsSaid() {
    PngRecipe recipe{4, 2};
    const std::string plain(
        "\0abcd\x09"
        "abcd",
        10);
    const Read read = readAll(test::pngHead(recipe) + test::pngTail(recipe, test::deflated(plain, 6)));
    QVERIFY2(says(read.reading, "damaged after 1 row."), read.reading.c_str());
    QCOMPARE(int(read.pyramid->at(3, 0)), int('d'));
  }

  void samplesAboveTheMaximumAreSaid() {
    for (const bool wide : {false, true}) {
      for (const bool above : {false, true}) {
        const std::string head = wide ? "P5\n2 2\n1000\n" : "P5\n2 2\n100\n";
        const std::string most = wide ? std::string("\x03\xe8", 2) : std::string("\x64");
        const std::string more = wide ? std::string("\x03\xe9", 2) : std::string("\x65");
        const Read read = readAll(head + most + (above ? more : most) + most + most);
        QCOMPARE(says(read.reading, "a number exceeds the maximum in the header"), above);
        QCOMPARE(int(read.pyramid->at(0, 0)), 255);
      }
    }
  }

  void whatFollowsAPictureIsIgnored() {
    const Samples samples = test::roomGrays(300, 40);
    const Read read = readAll(test::png({300, 40}, samples) + std::string(5000, 'x'));
    QCOMPARE(read.reading, std::string());
    QCOMPARE(rowsAsIn(*read.pyramid, samples), 40);
  }

  void flippedBitsNeverCrash() {
    const Samples samples = test::roomGrays(120, 90);
    PngRecipe recipe{120, 90};
    for (const bool interlaced : {false, true}) {
      recipe.interlaced = interlaced;
      const std::string whole = test::png(recipe, samples);
      for (std::uint32_t round = 0; round < 500; ++round) {
        std::string bytes = whole;
        for (std::uint32_t flip = 0; flip <= round % 4; ++flip) {
          const std::uint32_t at = test::noise(round * 4 + flip);
          // The size stays: other tests lie about it.
          const std::size_t offset = 24 + at % (bytes.size() - 24);
          bytes[offset] = char(bytes[offset] ^ 1 << (at >> 28) % 8);
        }
        readAll(bytes);
      }
    }
  }

  void damagedDataBehindRightChecksumsNeverCrashes() {
    const std::string plain = test::pngPass({120, 90}, test::roomGrays(120, 90), 0, 0, 1, 1);
    const std::string packed = test::deflated(plain, 6);
    for (std::uint32_t round = 0; round < 500; ++round) {
      std::string bytes = packed;
      const std::uint32_t at = test::noise(round);
      bytes[at % bytes.size()] = char(at >> 24);
      PngRecipe recipe{120, 90};
      recipe.interlaced = round % 2 == 0;
      const Read read = readAll(test::pngHead(recipe) + test::pngTail(recipe, bytes));
      QVERIFY(read.pyramid);
    }
  }

  void garbageIsNoPicture() {
    QVERIFY2(says(readAll("").opening, "empty"), "");
    QVERIFY(says(readAll("GIF89a, which is no map").opening, "PNG, PGM or BMP"));
    for (const char* header :
         {"P5", "P2 3", "P5 3 3", "P5 3 3 0 ", "P5 3 3 70000 ", "P5 -3 3 255 ", "P2 # no end", "BM",
          "BMxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx", "\x89PNG",
          "\x89PNG\r\n\x1a\n", "\x89PNG\r\n\x1a\n____________________________________"}) {
      QVERIFY2(!readAll(header).opening.empty(), header);
    }
    QVERIFY(!openGrid(nullptr, {}));
  }

  void aPaletteThatIsMissingIsSaid() {
    PngRecipe recipe{4, 1, 8, 3};
    const Read read = readAll(test::png(recipe, {0, 1, 2, 3}));
    QVERIFY2(says(read.opening, "palette is missing"), read.opening.c_str());
  }
};

}  // namespace test_grid_damage

MAPWRIGHT_TEST(test_grid_damage, TestGridDamage, Core)
#include "test_grid_damage.moc"
