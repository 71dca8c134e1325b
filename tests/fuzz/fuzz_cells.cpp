// The cells of a submap slice, what they are packed in, and the filters of PNG rows.
#include <algorithm>

#include "cells/decode_cells.h"
#include "packed/codec.h"
#include "packed/gunzip_stream.h"
#include "packed/png_unfilter.h"
#include "packed/unpack.h"
#include "target.h"

namespace mapwright::fuzz::cells {
namespace {

void unpackAll(Input bytes, std::size_t most) {
  using packed::Codec;
  using packed::Container;
  const Container container = packed::sniffContainer(bytes);
  if (container == Container::Gzip || container == Container::Zlib) {
    const auto unpacked = packed::unpack(container, bytes, most);
    MUST(!unpacked || unpacked->size <= most);
  }
  for (const Codec codec : {Codec::Zstd, Codec::Lz4, Codec::Bzip2}) {
    const auto unpacked = packed::unpackExactly(codec, bytes, most);
    MUST(!unpacked || unpacked->size == most);
  }
  use(packed::zstdContentSize(bytes));
}

/// What unpacks a gzip stream whole and what does it in pieces find the same.
void unpackPiecewise(Input bytes, std::size_t piece) {
  constexpr std::size_t kMost = std::size_t(1) << 20;
  Input left = bytes;
  packed::GunzipStream stream([&] {
    const Input next = left.first(std::min(left.size(), piece));
    left = left.subspan(next.size());
    return next;
  });
  std::vector<std::uint8_t> read(kMost);
  read.resize(stream.read(read));
  if (stream.state() != packed::GunzipStream::State::Ended) return;
  const auto whole = packed::unpack(packed::Container::Gzip, bytes, kMost);
  if (!whole) return;  // the other knows of several members
  MUST(whole->size >= read.size());
  MUST(std::equal(read.begin(), read.end(), whole->data.get()));
}

void unfilter(Choices from) {
  const int filter = int(from.byte() % 6), bits = 1 << (from.byte() % 3);
  const std::size_t unit = 1 + from.byte() % 8, row = from.rest().size() / 2 / unit * unit;
  if (row == 0) return;
  const auto above = exactly(from.bytes(row)), in = exactly(from.bytes(row));
  std::vector<std::uint8_t> out(row), samples(row * std::size_t(8 / bits));
  const bool known = packed::unfilterRow(filter, in.data(), above.data(), row, unit, out.data());
  MUST(known == (filter < 5));
  packed::unpackBits(in.data(), samples.size(), bits, samples.data());
}

void read(Input input) {
  Choices from(input);
  const unsigned what = from.byte() % 4;
  if (what == 3) return unfilter(from);
  const int width = int(from.twoBytes() & 1023), height = int(from.twoBytes() & 1023);
  const int format = int(from.byte() % 8) - 1;
  const auto bytes = exactly(from.rest());
  if (what == 2) {
    unpackAll(bytes, std::size_t(width) * std::size_t(height));
    unpackPiecewise(bytes, std::size_t(1 + width));
    return;
  }
  const auto cells = mapwright::cells::decodeCells(bytes, width, height, 0.05, format);
  if (!cells) return;
  MUST((*cells)->width() == width && (*cells)->height() == height);
}

}  // namespace
}  // namespace mapwright::fuzz::cells

MAPWRIGHT_FUZZ_TARGET(cells)
