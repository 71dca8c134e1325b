#include "raw_robot.h"

#include <array>
#include <cctype>
#include <zlib.h>

#include <QBuffer>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTcpSocket>

namespace raw {
namespace {

constexpr int kPatienceMs = 20'000;

/// Reads one answer from `text`; `used` is where it ends.
HttpReply parseReply(const std::string& text) {
  HttpReply reply;
  const std::size_t end = text.find("\r\n\r\n");
  if (end == std::string::npos) return reply;
  reply.status = std::stoi(text.substr(9, 3));
  std::size_t at = text.find("\r\n") + 2;
  while (at < end + 2) {
    const std::size_t line_end = text.find("\r\n", at);
    const std::string line = text.substr(at, line_end - at);
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos) {
      std::string name = line.substr(0, colon);
      for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      reply.headers[name] = line.substr(line.find_first_not_of(' ', colon + 1));
    }
    at = line_end + 2;
  }
  reply.body = text.substr(end + 4);
  const auto length = reply.headers.find("content-length");
  reply.whole =
      length == reply.headers.end() ? reply.body.empty() : std::stoul(length->second) == reply.body.size();
  return reply;
}

std::string inflate(const std::string& bytes, std::size_t most) {
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) return {};
  std::string out(most, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int result = ::inflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  inflateEnd(&stream);
  return result == Z_STREAM_END ? out : std::string();
}

bool isPng(const std::string& cells) { return cells.starts_with("\x89PNG"); }
bool isGzip(const std::string& cells) { return cells.starts_with("\x1f\x8b"); }
bool isZlib(const std::string& cells) {
  if (cells.size() < 2 || cells[0] != 0x78) return false;
  return (0x78 * 256 + static_cast<unsigned char>(cells[1])) % 31 == 0;
}

/// A value of one byte per cell as a pair (docs/protocols/cartographer-submaps.md, "Containers and cell
/// layouts").
std::array<unsigned char, 2> pairOf(int v, int format) {
  if (v == 0) return {0, 0};
  if (format == 2) return {static_cast<unsigned char>(v), 255};
  const int delta = format == 0 ? 128 - v : v - 128;
  if (delta > 0) return {static_cast<unsigned char>(delta), 0};
  if (delta < 0) return {0, static_cast<unsigned char>(-delta)};
  return {0, 1};
}

using Matrix = std::array<double, 12>;  // rows of [R | t]

Matrix matrixOf(const double* p) {
  const double x = p[3], y = p[4], z = p[5], w = p[6];
  return {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),     p[0],
          2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),     p[1],
          2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y), p[2]};
}

Point transformed(const Matrix& m, const Point& p) {
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
          m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}

}  // namespace

std::string exchange(int port, const std::string& bytes, int answers) {
  QTcpSocket socket;
  socket.connectToHost(QStringLiteral("127.0.0.1"), static_cast<quint16>(port));
  if (!socket.waitForConnected(kPatienceMs)) return {};
  socket.write(bytes.data(), static_cast<qint64>(bytes.size()));
  std::string all;
  while (socket.state() == QAbstractSocket::ConnectedState && socket.waitForReadyRead(kPatienceMs)) {
    all += socket.readAll().toStdString();
    int whole = 0;
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t end = all.find("\r\n\r\n", at);
      if (end == std::string::npos) break;
      const std::size_t field = all.find("Content-Length: ", at);
      const std::size_t length = field < end ? std::stoul(all.substr(field + 16)) : 0;
      if (end + 4 + length > all.size()) break;
      at = end + 4 + length;
      ++whole;
    }
    if (whole >= answers) return all;
  }
  return all + socket.readAll().toStdString();
}

HttpReply get(int port, const std::string& target, const std::map<std::string, std::string>& headers,
              const std::string& method) {
  std::string request = method + " " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\n";
  for (const auto& [name, value] : headers) request += name + ": " + value + "\r\n";
  return parseReply(exchange(port, request + "\r\n", 1));
}

HttpReply send(int port, const std::string& method, const std::string& target, const std::string& body,
               std::map<std::string, std::string> headers) {
  headers["Content-Length"] = std::to_string(body.size());
  headers.try_emplace("Content-Type", "application/json");
  std::string request = method + " " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\n";
  for (const auto& [name, value] : headers) request += name + ": " + value + "\r\n";
  return parseReply(exchange(port, request + "\r\n" + body, 1));
}

const Entry* List::find(int trajectory, int index) const {
  for (const Entry& entry : entries) {
    if (entry.trajectory == trajectory && entry.index == index) return &entry;
  }
  return nullptr;
}

List readList(const std::string& json) {
  const QJsonObject message = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
  List list;
  list.uuid = message[QLatin1String("uuid")].toString().toStdString();
  list.slam_state = message[QLatin1String("slam_state")].toString().toStdString();
  for (const QJsonValue& value : message[QLatin1String("submap")].toArray()) {
    const QJsonObject row = value.toObject(), pose = row[QLatin1String("pose")].toObject();
    Entry entry;
    entry.trajectory = row[QLatin1String("trajectory_id")].toInt();
    entry.index = row[QLatin1String("submap_index")].toInt();
    entry.version = row[QLatin1String("submap_version")].toInt();
    int i = 0;
    for (const char* key : {"x", "y", "z", "qx", "qy", "qz", "qw"})
      entry.pose[i++] = pose[QLatin1String(key)].toDouble();
    entry.frozen = row[QLatin1String("is_frozen")].toBool();
    entry.incremental = row[QLatin1String("is_incremental_submap")].toBool();
    entry.nearby = row[QLatin1String("is_nearby_map")].toBool();
    list.entries.push_back(entry);
  }
  return list;
}

std::optional<ros_messages::slam::SubmapQueryV2Response> fetch(int port, const std::string& uuid,
                                                               const Entry& entry) {
  const HttpReply reply =
      get(port, "/ros/slam/submaps/" + uuid + "/" + std::to_string(entry.trajectory) + "/" +
                    std::to_string(entry.index) + "?ver=" + std::to_string(entry.version));
  ros_messages::slam::SubmapQueryV2Response response;
  if (reply.status != 200 || !reply.whole || !response.ParseFromString(reply.body)) return std::nullopt;
  return response;
}

std::string packingOf(const ros_messages::slam::SubmapTexture& texture) {
  const std::string& cells = texture.cells();
  if (isPng(cells)) {
    const char type = cells.size() > 25 ? cells[25] : '\xff';
    return type == 0 ? "png-gray" : type == 3 ? "png-palette" : type == 4 ? "png-gray-alpha" : "png-other";
  }
  const bool packed = isGzip(cells) || isZlib(cells);
  const std::size_t area =
      static_cast<std::size_t>(texture.width()) * static_cast<std::size_t>(texture.height());
  const std::size_t size = packed ? inflate(cells, 2 * area + 1).size() : cells.size();
  const std::string container = isGzip(cells) ? "gzip-" : isZlib(cells) ? "zlib-" : "raw-";
  return container + (size == area ? "1" : size == 2 * area ? "2" : "?");
}

std::optional<Pairs> unpack(const ros_messages::slam::SubmapTexture& texture) {
  Pairs pairs;
  pairs.width = texture.width();
  pairs.height = texture.height();
  if (pairs.width < 1 || pairs.height < 1) return std::nullopt;
  const std::size_t area = static_cast<std::size_t>(pairs.width) * static_cast<std::size_t>(pairs.height);
  const std::string& cells = texture.cells();
  std::vector<unsigned char> single;
  if (isPng(cells)) {
    const QImage image = QImage::fromData(QByteArray::fromStdString(cells), "PNG");
    if (image.width() != pairs.width || image.height() != pairs.height) return std::nullopt;
    const char type = cells[25];
    for (int v = 0; v < pairs.height; ++v) {
      for (int u = 0; u < pairs.width; ++u) {
        if (type == 3) {
          single.push_back(static_cast<unsigned char>(image.pixelIndex(u, v)));
        } else if (type == 0) {
          single.push_back(static_cast<unsigned char>(qRed(image.pixel(u, v))));
        } else {
          const QRgb pixel = image.pixel(u, v);
          pairs.bytes.push_back(static_cast<unsigned char>(qRed(pixel)));
          pairs.bytes.push_back(static_cast<unsigned char>(qAlpha(pixel)));
        }
      }
    }
  } else {
    const std::string plain = isGzip(cells) || isZlib(cells) ? inflate(cells, 2 * area + 1) : cells;
    if (plain.size() == 2 * area) {
      pairs.bytes.assign(plain.begin(), plain.end());
    } else if (plain.size() == area) {
      single.assign(plain.begin(), plain.end());
    } else {
      return std::nullopt;
    }
  }
  for (const unsigned char v : single) {
    const auto pair = pairOf(v, texture.cell_format());
    pairs.bytes.insert(pairs.bytes.end(), pair.begin(), pair.end());
  }
  return pairs;
}

Point worldOf(const Entry& entry, const ros_messages::slam::SubmapTexture& texture, double u, double v) {
  const ros_messages::Pose& s = texture.slice_pose();
  const double slice[7] = {s.x(), s.y(), s.z(), s.qx(), s.qy(), s.qz(), s.qw()};
  const Point in_slice{-(v + 0.5) * texture.resolution(), -(u + 0.5) * texture.resolution(), 0};
  return transformed(matrixOf(entry.pose), transformed(matrixOf(slice), in_slice));
}

}  // namespace raw
