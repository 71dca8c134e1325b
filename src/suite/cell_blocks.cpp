#include "suite/cell_blocks.h"

#include <algorithm>

#include <QJsonArray>
#include <QJsonObject>
#include <QtEndian>
#include <climits>

namespace mapwright::suite {
namespace {

constexpr int kLeastEdge = 16, kMostBlocks = 2048, kMostEdge = 1 << 20;
constexpr std::uint32_t kSumStart = 2166136261u, kSumFactor = 16777619u;  // FNV-1a

}  // namespace

CellBlocks::CellBlocks(int width_cells, int height_cells)
    : width(width_cells), height(height_cells), edge(kLeastEdge) {
  while (std::int64_t(columns()) * rows() > kMostBlocks) edge *= 2;
  sums.assign(std::size_t(columns()) * std::size_t(rows()), kSumStart);
}

void CellBlocks::addRow(int y, const std::uint8_t* cells) {
  std::uint32_t* const row = sums.data() + std::ptrdiff_t(y / edge) * columns();
  for (int column = 0; column < columns(); ++column) {
    std::uint32_t sum = row[column];
    const int end = std::min(width, (column + 1) * edge);
    for (int x = column * edge; x < end; ++x) sum = (sum ^ cells[x]) * kSumFactor;
    row[column] = sum;
  }
}

std::vector<ChangedPatch> changedPatches(const CellBlocks& before, const CellBlocks& after,
                                         const geometry::Pose2& origin, double resolution_m) {
  const int columns = after.columns(), rows = after.rows(), edge = after.edge;
  const map::GridReference grid{after.width, after.height, resolution_m, origin};
  std::vector<bool> left(after.sums.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = before.sums[i] != after.sums[i];
  std::vector<ChangedPatch> patches;
  for (std::size_t start = 0; start < left.size(); ++start) {
    if (!left[start]) continue;
    left[start] = false;
    ChangedPatch patch;
    int min_x = INT_MAX, min_y = INT_MAX, max_x = 0, max_y = 0;  // cells
    std::vector<int> open{int(start)};
    while (!open.empty()) {
      const int column = open.back() % columns, row = open.back() / columns;
      open.pop_back();
      const int x1 = column * edge, x2 = std::min(after.width, x1 + edge);
      const int y1 = row * edge, y2 = std::min(after.height, y1 + edge);
      geometry::WorldRect& block = patch.blocks.emplace_back();
      for (const int x : {x1, x2}) {
        for (const int y : {y1, y2}) block.extend(grid.worldFromCell({double(x), double(y)}));
      }
      min_x = std::min(min_x, x1);
      min_y = std::min(min_y, y1);
      max_x = std::max(max_x, x2);
      max_y = std::max(max_y, y2);
      for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r) {
        for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c) {
          const auto next = std::size_t(r) * std::size_t(columns) + std::size_t(c);
          if (!left[next]) continue;
          left[next] = false;
          open.push_back(int(next));
        }
      }
    }
    patch.width_m = (max_x - min_x) * resolution_m;
    patch.height_m = (max_y - min_y) * resolution_m;
    patch.center_m = grid.worldFromCell({(min_x + max_x) / 2., (min_y + max_y) / 2.});
    patches.push_back(std::move(patch));
  }
  std::stable_sort(patches.begin(), patches.end(), [](const ChangedPatch& a, const ChangedPatch& b) {
    return a.blocks.size() > b.blocks.size();
  });
  return patches;
}

QJsonValue jsonOf(const CellBlocks& blocks) {
  if (!blocks.known()) return {};
  QJsonArray rows;
  for (int row = 0; row < blocks.rows(); ++row) {
    QByteArray bytes(blocks.columns() * 4, 0);
    qToBigEndian<quint32>(blocks.sums.data() + std::ptrdiff_t(row) * blocks.columns(), blocks.columns(),
                          bytes.data());
    rows << QString::fromLatin1(bytes.toBase64(QByteArray::OmitTrailingEquals));
  }
  return QJsonObject{{QStringLiteral("size"), QJsonArray{blocks.width, blocks.height}},
                     {QStringLiteral("edge"), blocks.edge},
                     {QStringLiteral("rows"), rows}};
}

CellBlocks blocksFrom(const QJsonValue& value) {
  const QJsonObject json = value.toObject();
  const QJsonArray size = json[QLatin1String("size")].toArray(), rows = json[QLatin1String("rows")].toArray();
  CellBlocks blocks;
  blocks.width = size.at(0).toInt();
  blocks.height = size.at(1).toInt();
  blocks.edge = json[QLatin1String("edge")].toInt();
  if (std::min({blocks.width, blocks.height, blocks.edge}) <= 0 ||
      std::max({blocks.width, blocks.height, blocks.edge}) > kMostEdge || blocks.rows() != rows.size())
    return {};
  for (const QJsonValue& row : rows) {
    const QByteArray bytes = QByteArray::fromBase64(row.toString().toLatin1());
    if (bytes.size() != qsizetype(blocks.columns()) * 4) return {};
    for (int column = 0; column < blocks.columns(); ++column)
      blocks.sums.push_back(qFromBigEndian<quint32>(bytes.constData() + 4 * column));
  }
  return blocks;
}

}  // namespace mapwright::suite
