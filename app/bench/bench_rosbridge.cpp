// From a frame of rosbridge to the cells of a grid, each of the three ways that it can travel. The baseline
// copies the cells: what nobody can do without.
#include <cmath>
#include <cstring>
#include <vector>

#include <QBuffer>
#include <QByteArray>
#include <QCborStreamWriter>
#include <QImage>
#include <benchmark/benchmark.h>

#include "net/rosbridge/frame.h"

namespace {

using mapwright::net::rosbridge::Frame;

constexpr int kWidth = 2000, kHeight = 1500;
constexpr std::size_t kCells = std::size_t(kWidth) * kHeight;

/// Rooms with walls of two cells, unknown ground between the buildings.
const std::vector<std::int8_t>& gridCells() {
  static const std::vector<std::int8_t> cells = [] {
    std::vector<std::int8_t> made(kCells);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool outside = (x / 960 + y / 800) % 3 == 2;
        const bool wall = x % 240 < 2 || y % 200 < 2;
        made[std::size_t(y) * kWidth + std::size_t(x)] = std::int8_t(outside ? -1 : wall ? 100 : 0);
      }
    }
    return made;
  }();
  return cells;
}

QByteArray jsonFrame() {
  QByteArray text =
      R"({"op": "publish", "topic": "\/map", "msg": {"info": {"width": 2000, "height": 1500}, "data": [)";
  for (const std::int8_t cell : gridCells()) text += QByteArray::number(cell) + ", ";
  text.chop(2);
  return text + "]}}";
}

QByteArray pictureFrame() {
  QByteArray text = jsonFrame();
  const int width = int(std::floor(std::sqrt(double(text.size()) / 3.0)));
  const int height = int(std::ceil(double(text.size()) / 3.0 / width));
  text.append(QByteArray(qsizetype(width) * height * 3 - text.size(), '\n'));
  const QImage image(reinterpret_cast<const uchar*>(text.constData()), width, height, width * 3,
                     QImage::Format_RGB888);
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return "{\"op\": \"png\", \"data\": \"" + png.toBase64() + "\"}";
}

QByteArray cborFrame() {
  QByteArray bytes;
  QCborStreamWriter writer(&bytes);
  const auto text = [&](const char* word) { writer.append(QLatin1String(word)); };
  writer.startMap(3);
  text("op");
  text("publish");
  text("topic");
  text("/map");
  text("msg");
  writer.startMap(1);
  text("data");
  writer.append(QCborTag(72));
  writer.appendByteString(reinterpret_cast<const char*>(gridCells().data()), qsizetype(kCells));
  writer.endMap();
  writer.endMap();
  return bytes;
}

void readCells(benchmark::State& state, const QByteArray& bytes, Frame::Wire wire) {
  for (auto _ : state) {
    const auto frame = Frame::read(bytes, wire);
    const auto cells = frame->root()["msg"]["data"].int8s(kCells);
    if (!cells || *cells != gridCells()) {
      state.SkipWithError("the cells are not those that were sent");
      return;
    }
  }
  state.counters["frame_bytes"] = double(bytes.size());
  state.SetItemsProcessed(state.iterations() * std::int64_t(kCells));
}

void RosbridgeGridJson(benchmark::State& state) { readCells(state, jsonFrame(), Frame::Wire::Text); }
void RosbridgeGridPng(benchmark::State& state) { readCells(state, pictureFrame(), Frame::Wire::Text); }
void RosbridgeGridCbor(benchmark::State& state) { readCells(state, cborFrame(), Frame::Wire::Binary); }

void RosbridgeGridCopied(benchmark::State& state) {
  for (auto _ : state) {
    std::vector<std::int8_t> cells(kCells);
    std::memcpy(cells.data(), gridCells().data(), kCells);
    benchmark::DoNotOptimize(cells.data());
    benchmark::ClobberMemory();
    if (cells != gridCells()) state.SkipWithError("the copy differs");
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(kCells));
}

BENCHMARK(RosbridgeGridJson)->Unit(benchmark::kMillisecond);
BENCHMARK(RosbridgeGridPng)->Unit(benchmark::kMillisecond);
BENCHMARK(RosbridgeGridCbor)->Unit(benchmark::kMillisecond);
BENCHMARK(RosbridgeGridCopied)->Unit(benchmark::kMillisecond);

}  // namespace
