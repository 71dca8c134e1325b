#include "replay/track.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <variant>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QString>

#include "map/live_state.h"

namespace mapwright::replay {
namespace {

/// Walks through the samples and the limits of pieces.
/// Numbers maps in the order in which they are heard of.
class HeardMaps {
 public:
  std::size_t numberOf(const map::MapInfo& info) {
    const map::MapIdentity one{info.uid, info.name};
    const auto known = std::find(maps.begin(), maps.end(), one);
    if (known != maps.end()) return std::size_t(known - maps.begin());
    maps.push_back(one);
    return maps.size() - 1;
  }
  std::vector<map::MapIdentity> maps;
};

class Collecting {
 public:
  std::vector<TrackPoint> points;

  void read(const Digest& digest) {
    if (until_s_ && *until_s_ != digest.from_s) ends_ = true;
    until_s_ = digest.until_s;
    auto kept = digest.history.begin();
    for (const Digest::Pose& pose : digest.poses) {
      for (; kept != digest.history.end() && kept->index < pose.index; ++kept) hear(kept->message);
      add(pose);
    }
    for (; kept != digest.history.end(); ++kept) hear(kept->message);
  }

 private:
  void hear(const map::TopicMessage& message) {
    if (const auto* slam = std::get_if<map::SlamStatus>(&message)) {
      quality_ = slam->position_quality.value_or(0);
    } else if (const auto* list = std::get_if<map::SubmapList>(&message)) {
      if (list->uuid.empty() || list->uuid == uuid_) return;
      ends_ = ends_ || !uuid_.empty();
      uuid_ = list->uuid;
    } else if (const auto* info = std::get_if<map::MapInfo>(&message)) {
      // What was driven before the first one is heard was on it, too.
      const std::size_t now = maps_.numberOf(*info);
      ends_ = ends_ || now != map_;
      map_ = now;
    }
  }
  void add(const Digest::Pose& pose) {
    if (!points.empty()) {
      const TrackPoint& before = points.back();
      const map::TrailPoint from{{before.pose.x_m, before.pose.y_m}, before.stamp_s};
      ends_ = ends_ || !map::isWayKnown(from, placeOf(pose));
      if (ends_) ++piece_;
    }
    ends_ = false;
    points.push_back({pose.stamp_s, pose.pose, 0, quality_, piece_, map_});
  }

  std::optional<double> until_s_;
  HeardMaps maps_;
  std::size_t map_ = 0;
  std::string uuid_;
  int quality_ = 0;
  std::size_t piece_ = 0;
  bool ends_ = false;
};

double distance(const TrackPoint& a, const TrackPoint& b) {
  return std::hypot(b.pose.x_m - a.pose.x_m, b.pose.y_m - a.pose.y_m);
}

void addSpeeds(std::vector<TrackPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool has_before = i > 0 && points[i - 1].piece == points[i].piece;
    const bool has_after = i + 1 < points.size() && points[i + 1].piece == points[i].piece;
    const TrackPoint& before = points[has_before ? i - 1 : i];
    const TrackPoint& after = points[has_after ? i + 1 : i];
    const double took_s = after.stamp_s - before.stamp_s;
    const double way_m = distance(before, points[i]) + distance(points[i], after);
    points[i].speed_m_s = took_s > 0 ? way_m / took_s : 0;
  }
}

/// In a locale-independent format for programs.
void append(std::string& text, double value, int decimals) {
  char digits[400];  // of the largest double
  const auto written =
      std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals);
  text.append(digits, written.ptr);
}

constexpr int kStampDecimals = 6, kMetreDecimals = 6, kAngleDecimals = 9;

struct Piece {
  std::vector<TrackPoint>::const_iterator begin, end;
};

std::vector<Piece> piecesOf(const std::vector<TrackPoint>& track) {
  std::vector<Piece> pieces;
  for (auto begin = track.begin(); begin != track.end();) {
    const auto end = std::find_if(begin, track.end(),
                                  [&](const TrackPoint& point) { return point.piece != begin->piece; });
    pieces.push_back({begin, end});
    begin = end;
  }
  return pieces;
}

/// Nothing if it is empty.
void appendText(std::string& text, const char* name, const std::string& value) {
  if (value.empty()) return;
  const QByteArray list =
      QJsonDocument(QJsonArray{QString::fromStdString(value)}).toJson(QJsonDocument::Compact);
  text.append(",\"").append(name).append("\":").append(list.data() + 1, std::size_t(list.size() - 2));
}

template <typename Value>
void appendList(std::string& text, const char* name, const Piece& piece, Value value) {
  text.append(",\"").append(name).append("\":[");
  for (auto point = piece.begin; point != piece.end; ++point) {
    if (point != piece.begin) text += ',';
    value(*point);
  }
  text += ']';
}

}  // namespace

std::vector<TrackPoint> trackOf(const std::map<Tick, Digest>& digests) {
  Collecting collecting;
  for (const auto& [from, digest] : digests) collecting.read(digest);
  addSpeeds(collecting.points);
  return std::move(collecting.points);
}

std::vector<map::MapIdentity> mapsOf(const std::map<Tick, Digest>& digests) {
  HeardMaps heard;
  for (const auto& [from, digest] : digests) {
    for (const Digest::Kept& kept : digest.history) {
      if (const auto* info = std::get_if<map::MapInfo>(&kept.message)) heard.numberOf(*info);
    }
  }
  return std::move(heard.maps);
}

std::vector<TrackPoint> within(const std::vector<TrackPoint>& track, double from_s, double to_s) {
  std::vector<TrackPoint> part;
  std::copy_if(track.begin(), track.end(), std::back_inserter(part),
               [&](const TrackPoint& point) { return point.stamp_s >= from_s && point.stamp_s <= to_s; });
  return part;
}

std::string csvOf(const std::vector<TrackPoint>& track) {
  std::string text = "stamp_s,x_m,y_m,yaw_rad,speed_m_s,quality,piece,map\n";
  for (const TrackPoint& point : track) {
    append(text, point.stamp_s, kStampDecimals);
    for (const auto& [value, decimals] : {std::pair(point.pose.x_m, kMetreDecimals),
                                          {point.pose.y_m, kMetreDecimals},
                                          {point.pose.yaw_rad, kAngleDecimals},
                                          {point.speed_m_s, kMetreDecimals}}) {
      text += ',';
      append(text, value, decimals);
    }
    text += ',' + std::to_string(point.quality) + ',' + std::to_string(point.piece) + ',' +
            std::to_string(point.map) + '\n';
  }
  return text;
}

std::string tumOf(const std::vector<TrackPoint>& track) {
  std::string text;
  for (const TrackPoint& point : track) {
    append(text, point.stamp_s, kStampDecimals);
    text += ' ';
    append(text, point.pose.x_m, kMetreDecimals);
    text += ' ';
    append(text, point.pose.y_m, kMetreDecimals);
    text += " 0 0 0 ";
    append(text, std::sin(point.pose.yaw_rad / 2), kAngleDecimals);
    text += ' ';
    append(text, std::cos(point.pose.yaw_rad / 2), kAngleDecimals);
    text += '\n';
  }
  return text;
}

std::string geoJsonOf(const std::vector<TrackPoint>& track, const std::vector<map::MapIdentity>& maps) {
  std::string text = R"({"type":"FeatureCollection","units":"metres of the map","features":[)";
  bool first = true;
  for (const Piece& piece : piecesOf(track)) {
    if (!std::exchange(first, false)) text += ',';
    const bool line = std::distance(piece.begin, piece.end) > 1;
    text += R"({"type":"Feature","geometry":{"type":")";
    text += line ? R"(LineString","coordinates":[)" : R"(Point","coordinates":)";
    double length_m = 0;
    for (auto point = piece.begin; point != piece.end; ++point) {
      if (point != piece.begin) {
        text += ',';
        length_m += distance(*std::prev(point), *point);
      }
      text += '[';
      append(text, point->pose.x_m, kMetreDecimals);
      text += ',';
      append(text, point->pose.y_m, kMetreDecimals);
      text += ']';
    }
    text += line ? "]}" : "}";
    text += R"(,"properties":{"piece":)" + std::to_string(piece.begin->piece) + R"(,"map":)" +
            std::to_string(piece.begin->map);
    if (piece.begin->map < maps.size()) {
      appendText(text, "map_uid", maps[piece.begin->map].uid);
      appendText(text, "map_name", maps[piece.begin->map].name);
    }
    text += R"(,"start_s":)";
    append(text, piece.begin->stamp_s, kStampDecimals);
    text += R"(,"end_s":)";
    append(text, std::prev(piece.end)->stamp_s, kStampDecimals);
    text += R"(,"length_m":)";
    append(text, length_m, kMetreDecimals);
    appendList(text, "stamps_s", piece,
               [&](const TrackPoint& point) { append(text, point.stamp_s, kStampDecimals); });
    appendList(text, "yaws_rad", piece,
               [&](const TrackPoint& point) { append(text, point.pose.yaw_rad, kAngleDecimals); });
    appendList(text, "speeds_m_s", piece,
               [&](const TrackPoint& point) { append(text, point.speed_m_s, kMetreDecimals); });
    appendList(text, "qualities", piece,
               [&](const TrackPoint& point) { text += std::to_string(point.quality); });
    text += "}}";
  }
  return text + "]}\n";
}

}  // namespace mapwright::replay
