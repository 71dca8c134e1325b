// A client of the simulated robot that owes nothing to the client library: blocking HTTP over a plain socket,
// and its own reading of cells.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ros_messages/slam.pb.h"

namespace raw {

struct HttpReply {
  int status = 0;                              // 0: the connection ended without a whole answer
  std::map<std::string, std::string> headers;  // names in lower case
  std::string body;
  bool whole = false;  // as many bytes as Content-Length promised
};

/// One request on a connection of its own.
HttpReply get(int port, const std::string& target, const std::map<std::string, std::string>& headers = {},
              const std::string& method = "GET");
/// Likewise with a body.
HttpReply send(int port, const std::string& method, const std::string& target, const std::string& body,
               std::map<std::string, std::string> headers = {});
/// Sends `bytes` as they are and returns everything that comes until the connection ends or `answers` are
/// there.
std::string exchange(int port, const std::string& bytes, int answers);

struct Entry {
  int trajectory = 0, index = 0, version = 0;
  double pose[7] = {0, 0, 0, 0, 0, 0, 1};
  bool frozen = false, incremental = false, nearby = false;
};
struct List {
  std::string uuid, slam_state;
  std::vector<Entry> entries;
  const Entry* find(int trajectory, int index) const;
};
/// A /submap_list message as JSON text.
List readList(const std::string& json);

/// The answer for a submap, at its current version; nullopt when there is none.
std::optional<ros_messages::slam::SubmapQueryV2Response> fetch(int port, const std::string& uuid,
                                                               const Entry& entry);

/// Cells as (value, alpha) pairs.
struct Pairs {
  int width = 0, height = 0;
  std::vector<unsigned char> bytes;
  int value(int u, int v) const { return bytes[static_cast<std::size_t>(2 * (v * width + u))]; }
  int alpha(int u, int v) const { return bytes[static_cast<std::size_t>(2 * (v * width + u) + 1)]; }
  bool observed(int u, int v) const { return value(u, v) != 0 || alpha(u, v) != 0; }
};

/// "png-gray", "png-palette", "png-gray-alpha", "gzip-2", "zlib-2", "raw-2", "raw-1", "gzip-1", ...
std::string packingOf(const ros_messages::slam::SubmapTexture& texture);
std::optional<Pairs> unpack(const ros_messages::slam::SubmapTexture& texture);

/// Where a cell's centre lies in the world: pose * slice_pose, columns along -y and rows along -x.
struct Point {
  double x = 0, y = 0, z = 0;
};
Point worldOf(const Entry& entry, const ros_messages::slam::SubmapTexture& texture, double u, double v);

}  // namespace raw
